// The testing ground in the window: what scripts do there is what people see, and it can be saved.
#include <map>
#include <set>

#include "samples/scenes/roles/roles_scene.h"
#include "samples/view/ground/save.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class GroundOf : public Staged
{
protected:
    void pick(const char *character, uint32_t count = 1)
    {
        Stage stage;
        stage.character = character, stage.count = count;
        view::Session &s = open(stage);
        s.model().picked.actor = s.world().everyone().front();
        play({"click \"Camera\"", "click \"Person\"", "wait 0.2"});
    }
    view::Ground &ground() { return session().model().ground; }
    // The vertices and colours of an individual as they are drawn.
    static std::vector<float> shown(const clq_view *view, clq_actor actor)
    {
        clq_view_stats stats = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view, &stats), CLQ_OK);
        for (uint32_t i = 0; i < stats.visible; ++i) {
            clq_drawn_actor one = clq_drawn_actor_init();
            EXPECT_EQ(clq_view_get_drawn_actor(view, i, &one), CLQ_OK);
            if (one.actor.index1 != actor.index1) continue;
            std::vector<float> out(3 * static_cast<size_t>(one.vertex_count));
            std::vector<uint8_t> rgb(3 * static_cast<size_t>(one.zone_count));
            EXPECT_EQ(clq_view_get_vertices(view, i, out.data(), nullptr, one.vertex_count), CLQ_OK);
            EXPECT_EQ(clq_view_get_colours(view, i, rgb.data(), one.zone_count), CLQ_OK);
            out.insert(out.end(), rgb.begin(), rgb.end());
            out.insert(out.end(), one.model_view, one.model_view + 16);
            return out;
        }
        return {};
    }
    // The same of the first person of the scenario that is saved now, seen by the same camera at the same time.
    std::vector<float> saved()
    {
        const std::string text = view::scenario_text(session().world(), session().model());
        const scenes::Scenario scenario =
            scenes::read_scenario(text, "saved.toml",
                                  {"", [](const std::string &, std::string &) { return std::string(); },
                                   [](const std::string &) { return std::string(); }});
        scenes::Library library(1);
        const auto scene = scenes::roles::make_scenario(library, scenes::CrowdOptions(), scenario);
        clq_view *view = nullptr;
        EXPECT_EQ(clq_view_create(scene->crowd(), &view), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(view, &session().world().camera()), CLQ_OK);
        EXPECT_EQ(clq_view_set_height(view, static_cast<float>(session().world().height())), CLQ_OK);
        const double time_s = session().model().clock.time_s;
        scene->place(time_s);
        EXPECT_EQ(clq_crowd_update(scene->crowd(), time_s, &view, 1), CLQ_OK) << clq_last_error();
        return shown(view, scene->actors().front());
    }
    std::vector<float> now() { return shown(session().world().view(), session().model().picked.actor); }
};

TEST_F(GroundOf, AWalkerShowsItsGaitAndItsDrift)
{
    pick("citizen");
    const std::vector<uint8_t> before = picture();
    play({"click \"Motion\"", "click \"treadmill\"", "wait 1.5", "see \"walks\"", "see \"mm at most\""});
    EXPECT_NE(picture(), before);
    ASSERT_TRUE(ground().treadmill);
    EXPECT_GT(ground().treadmill->steps, 8u);
    EXPECT_LT(ground().treadmill->drift_most_mm, 20);
    play({"drag \"walking speed\" 0.3 0.6", "wait 0.5", "see \"runs\""});
    play({"click \"treadmill\"", "wait 0.2"});
    EXPECT_FALSE(ground().treadmill);
    EXPECT_EQ(session().model().message, "");
}

TEST_F(GroundOf, AnOwlSaysWhyItDoesNotWalk)
{
    pick("owl");
    play({"click \"Motion\"", "click \"treadmill\"", "wait 0.2", "see \"has no clip named walk\""});
    EXPECT_FALSE(ground().treadmill);
    // Longer sentences take more lines, and none is cut.
    session().model().message = std::string(150, 'm') + " " + std::string(40, 'n');
    play({"wait 0.1"});
    view_test::expect_in_order(session().ui(), "a long message: ");
}

TEST_F(GroundOf, ADragMovesTheTargetOfTheGaze)
{
    pick("herald");
    play({"click \"Face\"", "click \"gaze\"", "click \"left drag: moves the target\"", "wait 0.2"});
    const view::FreeCamera camera = session().model().view.free;
    play({"drag view 0.5 0.5 0.8 0.3", "wait 0.6", "see \"target\""});
    const auto &face = ground().roles.begin()->second.face;
    ASSERT_TRUE(face.target);
    double x = 0, y = 0;
    ASSERT_TRUE(view::project(session().world().camera(), *face.target, x, y));
    EXPECT_NEAR(x, 0.6, 0.02) << "below the mouse";
    EXPECT_NEAR(y, 0.4, 0.02);
    EXPECT_EQ(session().model().view.free.yaw_rad, camera.yaw_rad) << "the camera stays";
    play({"click \"let it look about\"", "click \"left drag: camera\"", "drag view 0.5 0.5 0.6 0.5"});
    EXPECT_FALSE(face.target);
    EXPECT_NE(session().model().view.free.yaw_rad, camera.yaw_rad);
}

TEST_F(GroundOf, TypedPhrasesAreSaidAndFacesChange)
{
    pick("herald");
    play({"click \"Face\"", "click \"pause\"", "wait 0.1"});
    const std::vector<float> silent = now();
    play({"type \"phrase\" \"a a a\"", "click \"say\"", "click \"pause\"", "wait 0.2"});
    EXPECT_NE(now(), silent);
    EXPECT_EQ(ground().roles.begin()->second.face.phrase, "a a a");
    play({"click \"expression: raised\"", "click \"blinks\"", "wait 0.2", "click \"expression: none\""});
    EXPECT_FALSE(ground().roles.begin()->second.face.expresses);
    EXPECT_TRUE(ground().roles.begin()->second.face.blinks);
    EXPECT_EQ(session().model().message, "");
}

TEST_F(GroundOf, ClicksDrawAPathThatTheOwlFlies)
{
    pick("owl");
    play({"click \"Flight\"", "click \"left click: adds a corner\"", "drag \"height\" 0 0.02",
          "drag view 0.2 0.6 0.2 0.6", "drag view 0.5 0.8 0.5 0.8", "drag view 0.8 0.6 0.8 0.6", "see \"3 corners\""});
    const clq_actor owl = session().model().picked.actor;
    clq_actor_info info = clq_actor_info_init();
    double most = 0, first[3] = {0, 0, 0};
    for (int i = 0; i < 20; ++i) {
        play({"wait 0.2"});
        ASSERT_TRUE(session().world().find(owl, info));
        if (i == 0) std::copy(info.root.position, info.root.position + 3, first);
        for (int k = 0; k < 3; ++k) most = std::max(most, std::fabs(info.root.position[k] - first[k]));
    }
    EXPECT_GT(most, 0.5);
    play({"click \"forget path\"", "click \"left click: camera\"", "wait 0.1"});
    EXPECT_FALSE(ground().roles.begin()->second.flight.flies());
    EXPECT_EQ(session().model().message, "");
}

TEST_F(GroundOf, ThingsAreGivenToJointsAndSeen)
{
    pick("citizen");
    play({"click \"pause\"", "click \"Flight\"", "wait 0.1"});
    const std::vector<uint8_t> before = picture();
    play({"click \"object: torch\"", "click \"joints: hand_l\"", "click \"give\"", "wait 0.1", "see \"torch\""});
    EXPECT_NE(picture(), before);
    play({"click \"put down\"", "wait 0.1"});
    EXPECT_EQ(picture(), before);
    play({"type \"hold in\" \"tail\"", "click \"give\"", "wait 0.1", "see \"has no joint\""});
}

TEST_F(GroundOf, AMechanismIsLoadedAndAWrongOneRefused)
{
    pick("herald");
    const std::string type = std::string("type \"mechanism\" \"") + CLAQUE_NOD + "\"";
    play({"click \"Flight\"", type, "click \"load\"", "wait 0.2", "see \"--allow-mechanisms\""});
    ground().mechanisms = "/";
    play({"click \"load\"", "wait 0.2", "see \"nod\""});
    EXPECT_EQ(ground().mechanism_name, "nod");
    play({"click \"take it off\"", "type \"mechanism\" \"/nowhere.so\"", "click \"load\"", "wait 0.1",
          "see \"the mechanism /nowhere.so cannot be loaded\""});
    EXPECT_EQ(ground().mechanism_name, "");
}

TEST_F(GroundOf, StatesAreSavedAsScenariosThatShowTheSame)
{
    const std::map<std::string, std::vector<std::string>> doings = {
        {"citizen",
         {"click \"Character\"", "click \"clip: cheer\"", "wait 1", "click \"clip: stand_wave\"", "wait 0.2"}},
        {"patrician",
         {"click \"Motion\"", "click \"treadmill\"", "wait 0.6", "click \"add layer\"", "click \"layer plays: cheer\"",
          "click \"mask: upper_arm_l\"", "drag \"weight\" 0.9 0.7", "wait 0.3"}},
        {"herald",
         {"click \"Face\"", "click \"gaze\"", "click \"left drag: moves the target\"", "drag view 0.5 0.5 0.7 0.3",
          "click \"blinks\"", "click \"expression: raised\"", "click \"say\"", "wait 0.3", "click \"Face\"",
          "click \"Character\"", "drag \"wing_left_flap\" 0.5 0.9", "wait 0.1"}},
        {"owl",
         {"click \"Flight\"", "click \"left click: adds a corner\"", "drag \"height\" 0 0.02",
          "drag view 0.2 0.6 0.2 0.6", "drag view 0.5 0.8 0.5 0.8", "drag view 0.8 0.6 0.8 0.6", "click \"give\"",
          "wait 0.3"}}};
    for (const auto &[character, steps] : doings) {
        pick(character.c_str());
        const std::vector<float> before = now();
        play(steps);
        if (character != "owl") {
            EXPECT_EQ(session().model().message, "") << character;
        }
        const std::vector<float> shown_here = now();
        ASSERT_FALSE(shown_here.empty()) << character;
        EXPECT_NE(shown_here, before) << character;
        EXPECT_EQ(saved(), shown_here) << character << "\n"
                                       << view::scenario_text(session().world(), session().model());
    }
}

TEST_F(GroundOf, ThatHasNoPeopleIsNoScenario)
{
    open({});
    EXPECT_THROW(view::scenario_text(session().world(), session().model()), scenes::Failure);
}

// Parts that are hidden are no part of what is examined either.
TEST_F(GroundOf, WhatIsExaminedIsTheCharacterAsItWasOpened)
{
    open_with([](scenes::Library &library) {
        view::Opened opened;
        opened.options.character.tmpl = library.builtin("citizen");
        opened.options.crowd_options.count = 1;
        opened.asset_of = [](scenes::Library &of, const std::string &name) {
            EXPECT_EQ(name, "citizen");
            clq_asset *made = nullptr;
            scenes::check(clq_asset_builtin(of.context(), "owl", &made));
            return scenes::Own<clq_asset>(made);
        };
        return opened;
    });
    session().model().picked.actor = session().world().everyone().front();
    ground().examine = true;
    play({"wait 0.1"});
    clq_actor_info info = clq_actor_info_init();
    ASSERT_TRUE(session().world().find(session().model().picked.actor, info));
    const view::Findings *found = session().world().findings(info.tmpl);
    ASSERT_TRUE(found);
    std::set<std::string> names;
    for (const view::Findings::Zone &zone : found->zones) names.insert(zone.name);
    clq_template *owl = nullptr;
    scenes::check(clq_template_builtin(session().world().context(), "owl", &owl));
    const scenes::Own<clq_template> held(owl);
    clq_template_info about = clq_template_info_init();
    scenes::check(clq_template_get_info(owl, &about));
    EXPECT_EQ(names.size(), about.zone_count);
    for (uint32_t zone = 0; zone < about.zone_count; ++zone) {
        clq_zone_info one = clq_zone_info_init();
        scenes::check(clq_template_get_zone(owl, zone, &one));
        EXPECT_EQ(names.count(one.name), 1u) << one.name;
    }
}

TEST_F(GroundOf, CharactersAreExaminedAndTheirLevelsStandInARow)
{
    pick("citizen");
    play({"click \"pause\"", "click \"Check\"", "click \"examine\"", "wait 0.2", "see \"The loader has no warnings.\"",
          "see \"open edges\"", "see \"skin: \""});
    clq_actor_info info = clq_actor_info_init();
    ASSERT_TRUE(session().world().find(session().model().picked.actor, info));
    const view::Findings *found = session().world().findings(info.tmpl);
    ASSERT_TRUE(found);
    double shares = 0;
    for (const view::Findings::Zone &zone : found->zones) shares += zone.share;
    EXPECT_NEAR(shares, 1, 0.02);
    EXPECT_EQ(found->most_influences <= 4, found->many_influences == 0);
    ASSERT_GT(found->levels.size(), 4u);
    for (size_t i = 1; i < found->levels.size(); ++i) {
        EXPECT_LT(found->levels[i].triangles, found->levels[i - 1].triangles);
        EXPECT_GT(found->levels[i].error_mm, 0);
    }
    const std::vector<uint8_t> alone = picture();
    play({"click \"levels in a row\"", "wheel -20", "wait 0.1"});
    EXPECT_NE(picture(), alone);
    const view::LevelRow *row = session().world().level_row();
    ASSERT_TRUE(row);
    // Each stands in its own level.
    clq_view_stats stats = clq_view_stats_init();
    ASSERT_EQ(clq_view_get_stats(row->view(), &stats), CLQ_OK);
    EXPECT_GT(stats.visible, 3u);
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor one = clq_drawn_actor_init();
        ASSERT_EQ(clq_view_get_drawn_actor(row->view(), i, &one), CLQ_OK);
        EXPECT_EQ(one.level, one.actor.index1 - 1);
    }
    play({"click \"levels in a row\"", "wait 0.1"});
    EXPECT_FALSE(session().world().level_row());
}

TEST_F(GroundOf, OverlaysTellWhatWasCachedAndHowCleanZonesAre)
{
    open({"plaza", 12, 640, 480});
    play({"wait 0.5", "click \"pause\"", "click \"colours: cache\"", "wait 0.2", "see \"vertices from the cache\""});
    const view::Model &model = session().model();
    const auto sum = [&] { return model.served[0] + model.served[1] + model.served[2]; };
    EXPECT_EQ(sum(), model.cost.crowd.visible);
    EXPECT_EQ(model.served[0], model.cost.crowd.visible) << "time stands still";
    const std::vector<uint8_t> cached = picture();
    play({"click \"Camera\"", "click \"Frame\"", "click \"caches: none\"", "wait 0.2"});
    EXPECT_EQ(model.served[2], model.cost.crowd.visible);
    EXPECT_NE(picture(), cached);
    play({"click \"caches: palettes\"", "wait 0.2"});
    EXPECT_EQ(model.served[1], model.cost.crowd.visible);
    play({"click \"caches: full\"", "click \"Camera\"", "click \"colours: zones\"", "wait 0.2",
          "see \"triangles of one zone each\""});
    EXPECT_NE(picture(), cached);
}

}  // namespace
