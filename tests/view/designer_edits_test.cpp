// The designer's changes as values: what undo gives back, what links mean, what a drag round the circle sweeps.
#include <random>

#include <gtest/gtest.h>

#include "samples/view/designer/widgets.h"

namespace
{

using view::Designer;

const clq_hsb_range own = {10, 50, 0.1f, 0.9f, 0.2f, 0.8f};

class Edits : public testing::Test
{
protected:
    Edits()
    {
        d_.tmpl = "decurion";
        d_.zone = "tunic";
    }
    void on(const std::string &zone) { d_.zone = zone, d_.entry = 0; }
    const view::ZoneColours &zone(const std::string &name) { return *view::chosen_class(d_)->find(name); }

    Designer d_;
};

void change_at_random(Designer &d, std::mt19937 &random)
{
    const auto any = [&](size_t count) { return random() % count; };
    const auto share = [&] { return static_cast<float>(any(101)) / 100; };
    const char *const zones[] = {"skin", "hair", "tunic", "outer"};
    d.zone = zones[any(4)];
    d.tmpl = any(2) == 0 ? "decurion" : "plebeian";
    const view::ColourClass *colours = view::chosen_class(d);
    const std::vector<std::string> leaders = colours ? view::leaders_for(*colours, d.zone) : std::vector<std::string>();
    switch (any(10)) {
        case 0:
            return view::set_weight(d, own, 0.5f + share(), "weight");
        case 1:
            return view::add_entry(d, own);
        case 2:
            return view::remove_entry(d);
        case 3:
            return view::link_zone(d, own, leaders.empty() ? "" : leaders[any(leaders.size())]);
        case 4:
            return view::set_variation(d, share(), "variation");
        case 5:
            return view::forget_zone(d);
        case 6:
            return any(4) == 0 ? view::remove_class(d) : view::add_class(d);
        case 7:
            return view::set_space(d, own, static_cast<clq_colour_space>(any(2)));
        case 8:
            return view::name_class(d, "class " + std::to_string(any(9)));
        default:
            return view::set_range(d, own, {share() * 360, share() * 360, 0, share(), 0, share()}, "shade box");
    }
}

TEST_F(Edits, AreUndoneAndRedoneOneByOneWhateverTheyWere)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        Designer d;
        std::vector<view::Design> states = {d.design};
        for (int k = 0; k < 200; ++k) {
            change_at_random(d, random);
            d.history.let_go();
            if (d.design == states.back()) continue;
            states.push_back(d.design);
        }
        ASSERT_GT(states.size(), 100u);
        ASSERT_EQ(d.history.done(), states.size() - 1);
        for (size_t k = states.size() - 1; k-- > 0;) {
            ASSERT_TRUE(view::undo(d));
            ASSERT_TRUE(d.design == states[k]) << "seed " << seed << ", step " << k;
        }
        EXPECT_FALSE(view::undo(d));
        for (size_t k = 1; k < states.size(); ++k) {
            ASSERT_TRUE(view::redo(d));
            ASSERT_TRUE(d.design == states[k]) << "seed " << seed << ", step " << k;
        }
        EXPECT_FALSE(view::redo(d));
    }
}

TEST_F(Edits, AtRandomAlwaysMakeAMapThatTheLibraryTakes)
{
    clq_context_def def = clq_context_def_init();
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    const scenes::Own<clq_context> owner(context);
    std::mt19937 random(7);
    size_t maps = 0;
    for (int k = 0; k < 300; ++k) {
        change_at_random(d_, random);
        if (k % 3 != 0 || d_.design.classes.empty()) continue;
        ASSERT_NO_THROW(view::map_of(context, d_.design)) << "change " << k;
        ++maps;
    }
    EXPECT_GT(maps, 50u);
}

TEST_F(Edits, OfAHeldWidgetAreOneStep)
{
    for (const float hue : {10.0f, 20.0f, 30.0f}) view::set_range(d_, own, {hue, 90, 0, 1, 0, 1}, "hue arc");
    EXPECT_EQ(d_.history.done(), 1u);
    view::set_range(d_, own, {30, 90, 0, 0.5f, 0, 1}, "shade box");
    EXPECT_EQ(d_.history.done(), 2u);
    d_.history.let_go();
    view::set_range(d_, own, {30, 90, 0, 0.7f, 0, 1}, "shade box");
    EXPECT_EQ(d_.history.done(), 3u);
    ASSERT_TRUE(view::undo(d_));
    EXPECT_EQ(zone("tunic").palette[0].range.saturation_max, 0.5f);
}

TEST_F(Edits, AfterAnUndoLeaveNothingToRedo)
{
    view::set_range(d_, own, {10, 90, 0, 1, 0, 1}, "");
    view::set_range(d_, own, {20, 90, 0, 1, 0, 1}, "");
    ASSERT_TRUE(view::undo(d_));
    view::set_range(d_, own, {30, 90, 0, 1, 0, 1}, "");
    EXPECT_FALSE(view::redo(d_));
    EXPECT_EQ(zone("tunic").palette[0].range.hue_min_deg, 30);
}

TEST_F(Edits, BeginWithTheTemplatesOwnRange)
{
    view::set_weight(d_, own, 1, "");
    ASSERT_EQ(d_.design.classes.size(), 1u);
    EXPECT_EQ(d_.design.classes[0]->name, "decurions");
    EXPECT_EQ(d_.design.classes[0]->tmpl, "decurion");
    EXPECT_TRUE(view::same(zone("tunic").palette[0].range, own));
}

TEST_F(Edits, LinkAZoneToAnotherAndGiveItThatOnesColoursWhenItIsFreeAgain)
{
    const clq_hsb_range blue = {200, 240, 0.5f, 0.6f, 0.5f, 0.6f};
    view::set_range(d_, own, blue, "");
    on("border");
    view::link_zone(d_, own, "tunic");
    view::set_variation(d_, 0.25f, "");
    EXPECT_EQ(zone("border").linked_to, "tunic");
    EXPECT_EQ(zone("border").variation, 0.25f);
    EXPECT_TRUE(zone("border").palette.empty());
    ASSERT_TRUE(view::shown_palette(d_));
    EXPECT_TRUE(view::same(view::shown_palette(d_)->at(0).range, blue));
    view::link_zone(d_, own, "");
    EXPECT_EQ(zone("border").linked_to, "");
    EXPECT_EQ(zone("border").variation, 0);
    EXPECT_TRUE(view::same(zone("border").palette.at(0).range, blue));
}

TEST_F(Edits, OfferNoLinkThatWouldBeOneOfAChain)
{
    view::set_weight(d_, own, 1, "");
    on("border");
    view::link_zone(d_, own, "tunic");
    on("belt");
    view::set_weight(d_, own, 1, "");
    const view::ColourClass &colours = *view::chosen_class(d_);
    EXPECT_EQ(view::leaders_for(colours, "belt"), std::vector<std::string>{"tunic"});
    EXPECT_TRUE(view::leaders_for(colours, "tunic").empty());
}

TEST_F(Edits, OfAZoneThatLeadsOthersLeaveThemItsColours)
{
    const clq_hsb_range blue = {200, 240, 0.5f, 0.6f, 0.5f, 0.6f};
    view::set_range(d_, own, blue, "");
    on("border");
    view::link_zone(d_, own, "tunic");
    on("tunic");
    view::forget_zone(d_);
    EXPECT_EQ(view::chosen_class(d_)->find("tunic"), nullptr);
    EXPECT_EQ(zone("border").linked_to, "");
    EXPECT_TRUE(view::same(zone("border").palette.at(0).range, blue));
}

TEST(HueArc, ReachesFromWhereADragBeginsToWhereItIsAcrossTheTopToo)
{
    const auto arc = [](float start, float swept) {
        float ends[2];
        view::arc_of({start, 0, swept}, ends[0], ends[1]);
        return std::make_pair(ends[0], ends[1]);
    };
    EXPECT_EQ(arc(20, 70), std::make_pair(20.0f, 90.0f));
    EXPECT_EQ(arc(335, 83), std::make_pair(335.0f, 58.0f));
    EXPECT_EQ(arc(58, -83), std::make_pair(335.0f, 58.0f));
    EXPECT_EQ(arc(90, -70), std::make_pair(20.0f, 90.0f));
    EXPECT_EQ(arc(90, 359.6f), std::make_pair(0.0f, 360.0f));
    EXPECT_EQ(arc(90, -359.6f), std::make_pair(0.0f, 360.0f));
    EXPECT_EQ(arc(90, 0.4f), std::make_pair(90.0f, 90.0f));
    EXPECT_EQ(arc(90, 400), std::make_pair(0.0f, 360.0f));
}

TEST(PairField, TakesTwoNumbersInTheirBoundsAndOrder)
{
    const auto read = [](const std::string &text, bool ordered) {
        float a = -1, b = -1;
        return view::read_pair(text, 1, ordered, a, b) ? std::make_pair(a, b) : std::make_pair(-1.0f, -1.0f);
    };
    const std::pair<float, float> none = {-1.0f, -1.0f};
    EXPECT_EQ(read("0.4 0.8", true), std::make_pair(0.4f, 0.8f));
    EXPECT_EQ(read("0.4, 0.8", true), std::make_pair(0.4f, 0.8f));
    for (const char *text : {"", "0.4", "0.4 ", "0.4 0.8 1", "0.4 1.2", "-0.1 1", "0.4 x", "nan 1", "0.8 0.4"})
        EXPECT_EQ(read(text, true), none) << text;
    EXPECT_EQ(read("0.8 0.4", false), std::make_pair(0.8f, 0.4f));
}

}  // namespace
