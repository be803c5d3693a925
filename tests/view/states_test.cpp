// The state machine of a picked person, live.
#include <filesystem>
#include <fstream>
#include <set>
#include <unistd.h>

#include "samples/stage/staged_scene.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Staged;

class States : public Staged
{
protected:
    void SetUp() override
    {
        Staged::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("claque-states-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        std::ofstream(folder_ / "acts.toml") << R"(machine = "acts"
[states.waits]
initial = true
enter = [ { play = "stand" } ]
transitions = [ { after = [1, 1], to = "acts" } ]
[states.acts]
[states.acts.states.cheers]
initial = true
enter = [ { play = "stand_cheer", fade = 0.2 } ]
transitions = [ { after = [2, 2], to = "waits" } ]
)";
        std::ofstream(folder_ / "two.toml") << R"(name = "two"
[stage]
seconds = 20.0
[[characters]]
name = "people"
character = "citizen"
[[agents]]
class = "people"
machine = "acts.toml"
count = 2
area = [-1.0, -1.0, 1.0, 1.0]
)";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
};

TEST_F(States, ArePickedPersonsOwnAtTheTimeShown)
{
    const auto scenario =
        std::make_shared<const scenes::Scenario>(scenes::load_scenario((folder_ / "two.toml").string()));
    view::Session &s = open_with([scenario](scenes::Library &) {
        view::Opened opened;
        opened.options.scene = "two";
        opened.options.crowd_options.count = 0;
        opened.options.make = [scenario](scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
            return staged::make_scenario(library, crowd_options, *scenario);
        };
        return opened;
    });
    play({"click \"Person\"", "click \"Camera\"", "click \"State\""});
    s.model().picked.actor = s.world().everyone().front();
    std::set<std::string> seen_states;
    for (int i = 0; i < 40; ++i) {
        s.model().clock.paused = false;
        play({"wait 0.2"});
        s.model().clock.paused = true;
        play({});
        const view::Ground &ground = s.model().ground;
        ASSERT_TRUE(ground.mind);
        EXPECT_EQ(ground.mind->states, (std::vector<std::string>{"waits", "acts", "acts.cheers"}));
        EXPECT_GE(ground.mind->decided_s, s.model().clock.time_s - 0.05);
        const view::Ground::Entered *shown = nullptr;
        for (const view::Ground::Entered &one : ground.entered)
            if (one.at_s <= s.model().clock.time_s) shown = &one;
        if (!shown) continue;
        play({"see \"" + shown->state + " for \"", "see \"acts.toml\""});
        seen_states.insert(shown->state);
        // What the crowd shows is what the state says.
        clq_actor_info info = clq_actor_info_init();
        ASSERT_TRUE(s.world().find(s.model().picked.actor, info));
        clq_clip_info clip = clq_clip_info_init();
        ASSERT_EQ(clq_template_get_clip(info.tmpl, info.play.clip, &clip), CLQ_OK);
        EXPECT_STREQ(clip.name, shown->state == "waits" ? "stand" : "stand_cheer") << s.model().clock.time_s;
    }
    EXPECT_EQ(seen_states, (std::set<std::string>{"waits", "cheers"}));
}

}  // namespace
