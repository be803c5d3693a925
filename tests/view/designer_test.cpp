// The panel Designer: what it changes on the whole crowd, when, and how it is undone.
#include <algorithm>
#include <cmath>

#include "samples/view/designer/design.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class DesignerPanel : public Staged
{
protected:
    void open_people(uint32_t count = 6)
    {
        Stage stage;
        stage.line_up = {"decurion", "plebeian"};
        stage.count = count;
        stage.width = 640, stage.height = 600;
        open(stage);
        play({"click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Designer\""});
    }
    view::Designer &designer() { return session().model().designer; }
    const clq_hsb_range &range()
    {
        const auto *palette = view::shown_palette(designer());
        EXPECT_TRUE(palette);
        return palette->at(designer().entry).range;
    }

    // The colours that the library gives everyone for the design, as a host would get them from the saved map.
    void expect_worn()
    {
        if (designer().design.classes.empty()) return;
        const view::World &world = session().world();
        const scenes::ColourMap map = view::map_of(world.context(), designer().design);
        for (const clq_actor actor : world.everyone()) {
            clq_actor_info info = clq_actor_info_init();
            clq_template_info tmpl = clq_template_info_init();
            ASSERT_TRUE(world.find(actor, info));
            ASSERT_EQ(clq_template_get_info(info.tmpl, &tmpl), CLQ_OK);
            const uint32_t found = clq_colour_map_find_template(map.get(), tmpl.name);
            if (found == CLQ_NONE) continue;
            clq_colour_sample_def def = clq_colour_sample_def_init();
            def.colour_class = found, def.tmpl = info.tmpl;
            def.crowd_seed = 1, def.actor_seed = actor.index1 - 1;
            std::vector<float> wanted(3 * tmpl.zone_count), worn(3 * tmpl.zone_count);
            ASSERT_EQ(clq_colour_map_sample(map.get(), &def, wanted.data(), tmpl.zone_count), CLQ_OK);
            ASSERT_EQ(clq_actor_get_colours(world.crowd(), actor, worn.data(), tmpl.zone_count), CLQ_OK);
            for (size_t k = 0; k < wanted.size(); ++k) ASSERT_NEAR(worn[k], wanted[k], 0.5 / 255 + 1e-6);
        }
    }
};

TEST_F(DesignerPanel, DressesEveryoneInTheFrameOfEachChange)
{
    open_people();
    size_t changes = 0;
    view::Design last = designer().design;
    seen = [&] {
        expect_worn();
        if (!(last == designer().design)) ++changes;
        last = designer().design;
    };
    play({"click \"template: decurion\"", "click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6",
          "drag \"shade box\" 0.2 0.2 0.7 0.6", "click \"spread: oklab\"", "click \"add entry\"",
          "drag \"hue arc\" 0.9 0.1", "drag \"weight\" 0.3 0.6", "click \"zone: outer\"", "click \"linked to: tunic\"",
          "drag \"variation\" 0.2 0.4", "click \"undo\"", "click \"undo\"", "click \"redo\"",
          "click \"template: plebeian\"", "click \"zone: skin\"", "drag \"shade box\" 0.1 0.1 0.9 0.3",
          "click \"remove class\""});
    EXPECT_GT(changes, 20u);
}

TEST_F(DesignerPanel, MakesNoIndividualAnew)
{
    open_people();
    const clq_crowd *crowd = session().world().crowd();
    const std::vector<clq_actor> before = session().world().everyone();
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6", "click \"undo\""});
    const std::vector<clq_actor> after = session().world().everyone();
    EXPECT_EQ(session().world().crowd(), crowd);
    ASSERT_EQ(after.size(), before.size());
    for (size_t k = 0; k < after.size(); ++k) {
        EXPECT_EQ(after[k].index1, before[k].index1);
        EXPECT_EQ(after[k].generation, before[k].generation);
    }
}

TEST_F(DesignerPanel, TakesThePictureBackToTheBitWithEachUndo)
{
    open_people();
    std::vector<std::vector<uint8_t>> pictures = {picture()};
    for (const char *step : {"drag \"hue arc\" 0.3 0.6", "drag \"shade box\" 0.6 0.1 0.9 0.3", "click \"add entry\"",
                             "drag \"hue arc\" 0.05 0.2", "click \"spread: oklab\""}) {
        if (pictures.size() == 1) play({"click \"zone: tunic\""});
        play({step, "wait 0.04"});
        pictures.push_back(picture());
    }
    EXPECT_NE(pictures[1], pictures[0]);
    EXPECT_NE(pictures[2], pictures[1]);
    ASSERT_EQ(designer().history.done(), 5u);
    for (size_t k = 5; k-- > 0;) {
        play({k % 2 == 0 ? "click \"undo\"" : "key ctrl+Z", "wait 0.04"});
        EXPECT_EQ(picture(), pictures[k]) << k;
    }
    for (size_t k = 1; k < 6; ++k) {
        play({k % 2 == 0 ? "click \"redo\"" : "key shift+ctrl+Z", "wait 0.04"});
        EXPECT_EQ(picture(), pictures[k]) << k;
    }
}

TEST_F(DesignerPanel, DrawsTheArcOfHuesWhereItIsDraggedAcrossTheTopToo)
{
    open_people();
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6"});
    EXPECT_NEAR(range().hue_min_deg, 108, 2);
    EXPECT_NEAR(range().hue_max_deg, 216, 2);
    play({"drag \"hue arc\" 0.93 0.16"});
    EXPECT_NEAR(range().hue_min_deg, 335, 2);
    EXPECT_NEAR(range().hue_max_deg, 58, 2);
    EXPECT_EQ(range().hue_min_deg, std::round(range().hue_min_deg));
    const clq_hsb_range before = range();
    play({"drag \"hue arc\" 0.5 0.5"});
    EXPECT_TRUE(view::same(range(), before));
}

TEST_F(DesignerPanel, DrawsTheBoxOfShadesFromCornerToCornerWithinItsSides)
{
    open_people();
    const float near = 0.015f;
    const auto expect = [&](float s0, float s1, float b0, float b1) {
        EXPECT_NEAR(range().saturation_min, s0, near);
        EXPECT_NEAR(range().saturation_max, s1, near);
        EXPECT_NEAR(range().brightness_min, b0, near);
        EXPECT_NEAR(range().brightness_max, b1, near);
    };
    play({"click \"zone: tunic\"", "drag \"shade box\" 0.4 0.3 0.8 0.5"});
    expect(0.4f, 0.8f, 0.5f, 0.7f);
    play({"drag \"shade box\" 0.8 0.5 0.4 0.3"});
    expect(0.4f, 0.8f, 0.5f, 0.7f);
    play({"drag \"shade box\" 0.5 0.5 1 1"});
    expect(0.5f, 1, 0, 0.5f);
    EXPECT_LE(range().saturation_max, 1);
    EXPECT_GE(range().brightness_min, 0);
}

TEST_F(DesignerPanel, TakesNumbersThatAreTyped)
{
    open_people();
    play({"click \"zone: tunic\"", "type \"hue\" \"335 58\"", "type \"saturation\" \"0.32 0.48\"",
          "type \"brightness\" \"0.62 0.88\""});
    EXPECT_TRUE(view::same(range(), {335, 58, 0.32f, 0.48f, 0.62f, 0.88f}));
    play({"type \"brightness\" \"0.9 0.1\""});
    EXPECT_EQ(range().brightness_min, 0.62f);
    play({"type \"one colour\" \"#66023c\"", "click \"add entry\"", "type \"weight\" \"3.5\""});
    const auto purple = view::range_of_hex(session().world().context(), "#66023c");
    ASSERT_TRUE(purple);
    EXPECT_TRUE(view::same(range(), *purple));
    EXPECT_EQ(view::chosen_zone(designer())->palette[1].weight, 3.5f);
}

TEST_F(DesignerPanel, ChoosesWhatIsClickedOnAFigureOrOnTheTexture)
{
    open_people();
    for (const uint32_t person : {2u, 1u}) {
        play({"click person " + std::to_string(person)});
        clq_zone_info zone = clq_zone_info_init();
        clq_actor_info info = clq_actor_info_init();
        ASSERT_TRUE(session().world().find(session().model().picked.actor, info));
        ASSERT_EQ(clq_template_get_zone(info.tmpl, session().model().picked.zone, &zone), CLQ_OK);
        EXPECT_EQ(designer().tmpl, person == 1 ? "decurion" : "plebeian");
        EXPECT_EQ(designer().zone, zone.name);
    }
    std::vector<std::string> chosen;
    for (const float at : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f}) {
        const std::string place = std::to_string(at);
        play({"drag \"texels\" " + place + " 0.5 " + place + " 0.5"});
        chosen.push_back(designer().zone);
    }
    std::sort(chosen.begin(), chosen.end());
    EXPECT_GT(std::unique(chosen.begin(), chosen.end()) - chosen.begin(), 1);
}

TEST_F(DesignerPanel, ChangesTheNumberOfPeopleAndKeepsThoseThatStay)
{
    open_people(6);
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6"});
    const clq_crowd *crowd = session().world().crowd();
    const std::vector<clq_actor> before = session().world().everyone();
    seen = [this] { expect_worn(); };
    play({"type \"people\" \"20\"", "wait 0.1"});
    const std::vector<clq_actor> more = session().world().everyone();
    EXPECT_EQ(session().world().crowd(), crowd);
    ASSERT_EQ(more.size(), 20u);
    for (size_t k = 0; k < before.size(); ++k) EXPECT_EQ(more[k].generation, before[k].generation);
    play({"key escape", "click \"pause\"", "type \"people\" \"3\"", "wait 0.1"});
    EXPECT_EQ(session().world().everyone().size(), 3u);
}

TEST_F(DesignerPanel, PutsATextureSetOnAllOfATemplateAndGivesEachItsOwnAgain)
{
    open_people(12);
    const auto sets = [this] {
        std::vector<uint32_t> all;
        for (const clq_actor actor : session().world().everyone()) {
            clq_actor_info info = clq_actor_info_init();
            EXPECT_TRUE(session().world().find(actor, info));
            all.push_back(info.texture_set);
        }
        return all;
    };
    const std::vector<uint32_t> own = sets();
    play({"click \"template: decurion\"", "click \"textures: own\""});
    for (size_t k = 0; k < own.size(); ++k) EXPECT_EQ(sets()[k], k % 2 == 0 ? 0 : own[k]);
    play({"click \"textures: mixed\""});
    EXPECT_EQ(sets(), own);
}

TEST_F(DesignerPanel, ColoursAnyScene)
{
    open({"plaza", 12, 640, 600});
    play({"click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Designer\"", "wait 0.1"});
    const std::vector<uint8_t> before = picture();
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6", "drag \"shade box\" 0.6 0.1 0.9 0.3"});
    EXPECT_NE(picture(), before);
    play({"click \"undo\"", "click \"undo\"", "wait 0.1"});
    EXPECT_EQ(picture(), before);
    play({"click \"redo\"", "click \"redo\"", "wait 0.1"});
    const std::vector<uint8_t> dressed = picture();
    play({"type \"people\" \"5\"", "wait 0.1"});
    EXPECT_EQ(session().world().everyone().size(), 5u);
    play({"type \"people\" \"12\"", "wait 0.1"});
    EXPECT_EQ(picture(), dressed);
}

}  // namespace
