// Scripts: what they refuse, and that they do what a person would.
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

std::string refusal(const std::string &toml)
{
    try {
        view::read_script(toml, "clicks.toml");
    } catch (const scenes::Failure &failure) {
        return failure.what();
    }
    return "";
}

TEST(Script, RefusesWhatIsNoStepWithItsNumberAndTheRule)
{
    EXPECT_EQ(refusal("steps = ['wait 1', 'jump 3']"),
              "clicks.toml: step 2, 'jump 3': there is no step 'jump'; there are: click, drag, type, key, wheel, wait, "
              "size, drop, see, shot");
    EXPECT_EQ(refusal("steps = ['wait']"), "clicks.toml: step 1, 'wait': the step has the form: wait SECONDS [FRAMES]");
    EXPECT_EQ(refusal("steps = ['click \"pause']"),
              "clicks.toml: step 1, 'click \"pause': a quotation mark is not closed");
    EXPECT_EQ(refusal("steps = ['']"), "clicks.toml: step 1, '': the step is empty");
    EXPECT_NE(refusal("stops = []"), "");
    EXPECT_EQ(refusal("steps = ['click \"pause\"', 'wait 0.5']"), "");
}

class Scripts : public Staged
{
protected:
    std::string failure_of(const std::string &step)
    {
        try {
            play({step});
        } catch (const scenes::Failure &failure) {
            return failure.what();
        }
        return "";
    }
};

TEST_F(Scripts, SayWhatIsThereWhenAWidgetIsNot)
{
    open({});
    EXPECT_EQ(failure_of("click \"jump\"")
                  .rfind("test: step 1, 'click \"jump\"': there is no widget 'jump' in sight; "
                         "there are: pause, back, step,",
                         0),
              0u)
        << failure_of("click \"jump\"");
    EXPECT_EQ(failure_of("click person 77"), "test: step 1, 'click person 77': person 77 is nowhere in the picture");
    EXPECT_EQ(failure_of("wait long"), "test: step 1, 'wait long': 'long' is no number from 0 to 3600");
    EXPECT_NE(failure_of("see \"no such words\"").find("the panels do not say"), std::string::npos);
}

TEST_F(Scripts, PauseStepAndScrubTime)
{
    view::Clock &clock = open({}).model().clock;
    play({"wait 1", "click \"pause\""});
    EXPECT_TRUE(clock.paused);
    const double paused = clock.time_s;
    EXPECT_GT(paused, 1.0);
    play({"wait 2"});
    EXPECT_EQ(clock.time_s, paused);
    play({"click \"step\""});
    EXPECT_DOUBLE_EQ(clock.time_s, paused + 0.04);
    play({"click \"back\"", "click \"back\""});
    EXPECT_NEAR(clock.time_s, paused - 0.04, 1e-12);
    play({"drag \"time\" 0.1 0.5"});
    EXPECT_NEAR(clock.time_s, 30, 1);
}

TEST_F(Scripts, PickThePersonThatTheyClick)
{
    view::Session &s = open({"plaza", 12, 640, 480});
    int picked = 0;
    for (uint32_t person = 1; person <= 12; ++person) {
        float x = 0, y = 0;
        play({"wait 0.04"});
        if (!s.world().point_on(person, x, y)) continue;
        play({"click \"pause\"", "click person " + std::to_string(person), "click \"pause\"",
              "see \"" + std::to_string(person) + ", made once\""});
        EXPECT_EQ(s.model().picked.actor.index1, person);
        EXPECT_NE(s.model().picked.zone, CLQ_NONE);
        ++picked;
    }
    EXPECT_GT(picked, 6);
    play({"key escape"});
    EXPECT_EQ(s.model().picked.actor.index1, 0u);
}

TEST_F(Scripts, PlayAClipOfThePickedPerson)
{
    view::Session &s = open({});
    play({"click person 2", "click \"Character\"", "click \"clip: cheer\"", "wait 1", "see \"cheer at\""});
    EXPECT_EQ(s.model().message, "");
    EXPECT_TRUE(s.ui().find("clip: cheer")->chosen);
    EXPECT_FALSE(s.ui().find("clip: stand")->chosen);
}

// Frames of half a second: what the panel says is about the picture that was made, not about the one to come.
TEST_F(Scripts, SeeHowOldAPoseIsInThePictureThatIsShown)
{
    view::Session &s = open({"parade", 2});
    play({"click person 1", "key F"});
    view::Script slow = view::read_script("frames_per_s = 2\nsteps = ['wait 5']", "test");
    int seen_ages = 0;
    play(std::move(slow), [&](const view::Input &) {
        for (const view::Widget &text : s.ui().texts()) {
            const size_t at = text.name.find(" s, ");
            if (at == std::string::npos || text.name.find(" ms old") == std::string::npos) continue;
            EXPECT_LE(std::stoi(text.name.substr(at + 4)), 20) << text.name;  // 50 poses a second
            ++seen_ages;
        }
    });
    EXPECT_GE(seen_ages, 10);
}

}  // namespace
