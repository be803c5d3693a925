// The widgets: each can be reached, and none hides another or is cut.
#include <set>

#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

// Without the names of clips, joints, zones and texture sets, which characters bring along.
const std::vector<std::string> &names_of_widgets()
{
    static const std::vector<std::string> names = {"pause",
                                                   "back",
                                                   "step",
                                                   "picture",
                                                   "film",
                                                   "panels",
                                                   "speed",
                                                   "time",
                                                   "Camera",
                                                   "Person",
                                                   "Character",
                                                   "Designer",
                                                   "Frame",
                                                   "Motion",
                                                   "Face",
                                                   "Flight",
                                                   "State",
                                                   "Check",
                                                   "camera: overview",
                                                   "camera: close",
                                                   "camera: free",
                                                   "camera: follow",
                                                   "keep as: 1",
                                                   "keep as: 2",
                                                   "keep as: 3",
                                                   "keep as: 4",
                                                   "keep as: 5",
                                                   "recall: 1",
                                                   "field",
                                                   "add key",
                                                   "saved as",
                                                   "save path",
                                                   "forget keys",
                                                   "colours: own",
                                                   "colours: level",
                                                   "colours: rate",
                                                   "colours: age",
                                                   "colours: cache",
                                                   "colours: zones",
                                                   "save scenario",
                                                   "bounding spheres",
                                                   "follow",
                                                   "frame",
                                                   "let go",
                                                   "fade",
                                                   "curve: linear",
                                                   "curve: smooth",
                                                   "curve: inertial",

                                                   "undo",
                                                   "redo",
                                                   "load map",
                                                   "save map",
                                                   "map file",
                                                   "people",
                                                   "template: citizen",
                                                   "textures: mixed",
                                                   "textures: own",
                                                   "texels",
                                                   "tool: pick",
                                                   "tool: brush",
                                                   "tool: fill",
                                                   "brush size",
                                                   "new zone",
                                                   "add zone",
                                                   "save zones",
                                                   "zones at most",
                                                   "propose zones",
                                                   "grey texels",
                                                   "zone: skin",
                                                   "zone: tunic",
                                                   "hue arc",
                                                   "shade box",
                                                   "hue",
                                                   "saturation",
                                                   "brightness",
                                                   "one colour",
                                                   "palette",
                                                   "entry: 1",
                                                   "entry: 2",
                                                   "weight",
                                                   "add entry",
                                                   "remove entry",
                                                   "spread: hsb",
                                                   "spread: oklab",
                                                   "linked to: none",
                                                   "linked to: hair",
                                                   "variation",
                                                   "leave to template",
                                                   "class: citizens",
                                                   "class name",
                                                   "add class",
                                                   "remove class",
                                                   "strategy: fused",
                                                   "strategy: binned",
                                                   "strategy: per zone",
                                                   "close textures: off",
                                                   "close textures: on",
                                                   "caches: full",
                                                   "caches: palettes",
                                                   "caches: none",
                                                   "caches: key-poses",
                                                   "culling: three phases",
                                                   "culling: last",
                                                   "format: float",
                                                   "format: packed",
                                                   "levels: off",
                                                   "levels: on",
                                                   "levels: early",
                                                   "threads: 1",
                                                   "threads: 2",
                                                   "threads: 4",
                                                   "count anew"};
    return names;
}

class Widgets : public Staged
{
protected:
    // All panels open and all widgets there: a picked person, a kept camera, two keys, a joint set by hand.
    void open_all(Stage stage)
    {
        stage.character = "citizen";
        stage.count = 2;
        open(stage);
        play({"click \"pause\"", "click person 1", "click \"keep as: 1\"", "click \"add key\"", "click \"step\"",
              "click \"add key\"", "click \"Character\"", "click \"Frame\"", "click \"Designer\""});
        design_all();
    }
    // A texture that is painted, and a zone that is linked and has two palette entries of its own.
    void design_all()
    {
        play({"click \"tool: brush\"", "drag \"texels\" 0.3 0.7 0.4 0.7", "click \"zone: hair\"",
              "click \"spread: oklab\"", "click \"zone: tunic\"", "click \"linked to: hair\"", "click \"add entry\"",
              "click \"entry: 1\""});
    }

    bool uses(const std::string &name)
    {
        bool used = false;
        seen = [&] {
            const view::Widget *widget = session().ui().find(name);
            used = used || (widget && widget->used);
        };
        static const std::set<std::string> slide = {"speed",     "time",       "field",        "fade",
                                                    "people",    "weight",     "hue arc",      "shade box",
                                                    "variation", "brush size", "zones at most"};
        static const std::map<std::string, const char *> typed = {
            {"saved as", "film"},      {"map file", "map"},       {"hue", "10 20"},       {"saturation", "0.1 0.2"},
            {"brightness", "0.1 0.2"}, {"one colour", "#102030"}, {"class name", "folk"}, {"new zone", "mantle"}};
        const bool slides = slide.count(name) != 0;
        if (typed.count(name) != 0) play({"type \"" + name + "\" \"" + typed.at(name) + "\""});
        else if (name == "palette") play({"drag \"palette\" 0.9 0.9"});
        else play({slides ? "drag \"" + name + "\" 0.15 0.85" : "click \"" + name + "\""});
        seen = [] {};
        return used;
    }
};

TEST_F(Widgets, AreAllReachedByTheirNames)
{
    open_all({});
    const view::Model all = session().model();
    std::set<std::string> there;
    for (const std::string &name : names_of_widgets()) {
        session().model() = all;
        play({});
        for (const view::Widget &widget : session().ui().widgets()) there.insert(widget.name);
        EXPECT_TRUE(uses(name)) << name;
    }
    for (const std::string &name : names_of_widgets()) there.erase(name);
    clq_actor_info info = clq_actor_info_init();
    session().model() = all;
    play({});
    ASSERT_TRUE(session().world().find(session().model().picked.actor, info));
    for (const std::string &name : there) {
        const std::string list = name.substr(0, name.find(':')), item = name.substr(list.size() + 2);
        if (name == "class: folk") continue;  // which was typed
        if (list == "zone") EXPECT_NE(clq_template_find_zone(info.tmpl, item.c_str()), CLQ_NONE) << name;
        else if (list == "textures")
            EXPECT_NE(clq_template_find_texture_set(info.tmpl, item.c_str()), CLQ_NONE) << name;
        else {
            EXPECT_EQ(list, "clip") << name;
            EXPECT_NE(clq_template_find_clip(info.tmpl, item.c_str()), CLQ_NONE) << name;
        }
    }
}

TEST_F(Widgets, AreNeitherCutNorOverlapAtAnySize)
{
    struct Size {
        int width, height;
        float scale;
    };
    for (const Size size : {Size{1024, 640, 1}, {1280, 800, 1}, {2560, 1440, 1}, {2560, 1440, 2}, {1280, 800, 2}}) {
        Stage stage;
        stage.width = size.width, stage.height = size.height, stage.scale = size.scale;
        open_all(stage);
        view_test::expect_in_order(session().ui(), std::to_string(size.width) + "x" + std::to_string(size.height) +
                                                       " scale " + std::to_string(size.scale) + ": ");
    }
}

TEST(Words, AreBrokenAtSpacesSoThatNumbersStayWhole)
{
    EXPECT_EQ(view::in_lines("walk at 0.30 s, stand at 0.48 s", 28), "walk at 0.30 s, stand at\n0.48 s");
    EXPECT_EQ(view::in_lines("walk at 0.30 s", 14), "walk at 0.30 s");
    EXPECT_EQ(view::in_lines("walk at 0.30 s", 13), "walk at 0.30\ns");
    EXPECT_EQ(view::in_lines("/a/path/without/spaces is long", 10), "/a/path/without/spaces\nis long");
    EXPECT_EQ(view::in_lines("two\nlines of words", 8), "two\nlines of\nwords");
    EXPECT_EQ(view::in_lines("", 1), "");
    EXPECT_EQ(view::line_count("", 1), 1u);
    EXPECT_EQ(view::line_count("two lines", 5), 2u);
    EXPECT_EQ(view::line_count("/a/path/without/spaces is long", 10), 4u);
}

// What the mouse and the keys do, and what is said about the last thing that was done, at the least width.
TEST_F(Widgets, OfTheLowerBarHaveRoomInANarrowWindow)
{
    Stage stage;
    stage.width = 480, stage.height = 400;
    view::Session &s = open(stage);
    play({"key tab", "wait 0.1", "see \"drag: turn\""});
    view_test::expect_in_order(s.ui(), "hint: ");
    const int high = s.world().height();
    s.model().message = "a word";
    play({"wait 0.1"});
    EXPECT_EQ(s.world().height(), high) << "the first message changes the size of the picture";
    s.model().message = "a sentence of many words that is about the last thing that was done and needs some lines";
    play({"wait 0.1"});
    view_test::expect_in_order(s.ui(), "sentence: ");
}

TEST_F(Widgets, OfJointsMoveThePickedPersonAndLeaveItToItsClip)
{
    Stage stage;
    stage.scene = "town_sky", stage.count = 3;
    view::Session &s = open(stage);
    s.model().picked.actor = s.world().everyone().front();
    play({"click \"pause\"", "click \"follow\"", "click \"frame\"", "click \"Camera\"", "click \"Person\"",
          "click \"Character\"", "wait 0.1"});
    clq_actor_info info = clq_actor_info_init();
    clq_template_info tmpl = clq_template_info_init();
    ASSERT_TRUE(s.world().find(s.model().picked.actor, info));
    ASSERT_EQ(clq_template_get_info(info.tmpl, &tmpl), CLQ_OK);
    ASSERT_GT(tmpl.dof_count, 0u);
    uint32_t moving = 0;
    for (uint32_t k = 0; k < tmpl.dof_count; ++k) {
        clq_dof_info dof = clq_dof_info_init();
        ASSERT_EQ(clq_template_get_dof(info.tmpl, k, &dof), CLQ_OK);
        const std::vector<uint8_t> before = picture();
        play({std::string("drag \"") + dof.name + "\" 0.05 0.95", "wait 0.1"});
        const std::vector<uint8_t> by_hand = picture();
        play({"click \"leave joints to clips\"", "wait 0.1"});
        moving += by_hand != before;
        EXPECT_EQ(picture(), before) << dof.name;
    }
    EXPECT_GT(moving, 0u);
}

}  // namespace
