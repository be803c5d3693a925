// The widgets of the testing ground: scripts reach each that is drawn, and none is cut or hides another.
#include <set>

#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class GroundWidgets : public Staged
{
protected:
    // A character with everything open that the testing ground has for it.
    void open_ground(Stage stage, const std::string &character)
    {
        stage.character = character;
        view::Session &s = open(stage);
        s.model().clock.paused = true;
        s.model().picked.actor = s.world().everyone().front();
        s.model().open = {false, false, false, false};
        s.model().ground.open = {true, true, true, true, true};
        s.model().view.mode = view::CameraMode::free;
        play({"click \"add layer\"", "click \"joints: head\"", "click \"give\""});
        scenes::roles::Role &role = s.model().ground.roles.begin()->second;
        role.motion.layers[0].joint = "head";
        role.flight.corners = {1, 2, 1, 1, 2, -1, -1, 2, 0};
        if (character != "citizen") role.face.looks = true, role.face.target = {{0, 1, 3}};
        else role.motion.treadmill_m_s = 1.4, role.flight = {};
        play({"wait 0.1"});
    }

    bool uses(const std::string &name)
    {
        bool used = false;
        seen = [&] {
            const view::Widget *widget = session().ui().find(name);
            used = used || (widget && widget->used);
        };
        for (const std::string &step :
             {"click \"" + name + "\"", "drag \"" + name + "\" 0.15 0.85", "type \"" + name + "\" \"x\""}) {
            if (used || !session().ui().find(name)) break;
            play({step});
        }
        seen = [] {};
        return used;
    }
};

TEST_F(GroundWidgets, AreAllReachedByTheirNames)
{
    for (const char *character : {"herald", "citizen"}) {
        open_ground({}, character);
        const view::Model all = session().model();
        std::set<std::string> names;
        for (const view::Widget &widget : session().ui().widgets()) names.insert(widget.name);
        std::set<std::string> wanted = {"treadmill",
                                        "walking speed",
                                        "add layer",
                                        "drop layer",
                                        "layer: 1",
                                        "kind: adds",
                                        "weight",
                                        "joint",
                                        "all but it",
                                        "mask: whole body",
                                        "object: basket",
                                        "hold in",
                                        "give",
                                        "put down",
                                        "mechanism",
                                        "load",
                                        "examine",
                                        "height",
                                        "left click: adds a corner"};
        if (character == std::string("herald"))
            wanted.insert({"gaze", "left drag: moves the target", "let it look about", "expression: by chance",
                           "blinks", "phrase", "say", "flight speed", "forget path"});
        for (const std::string &name : wanted) EXPECT_EQ(names.count(name), 1u) << name;
        for (const std::string &name : names) {
            if (name == "examine") continue;  // it takes seconds, and another test clicks it
            session().model() = all;
            play({});
            EXPECT_TRUE(uses(name)) << character << ": " << name;
        }
    }
}

TEST_F(GroundWidgets, AreNeitherCutNorOverlapAtAnySize)
{
    struct Size {
        int width, height;
        float scale;
    };
    for (const char *character : {"herald", "citizen"})
        for (const Size size : {Size{1024, 640, 1}, {2560, 1440, 1}, {2560, 1440, 2}, {1280, 800, 2}}) {
            Stage stage;
            stage.count = 1, stage.width = size.width, stage.height = size.height, stage.scale = size.scale;
            open_ground(stage, character);
            if (size.width == 1024) play({"click \"examine\"", "wait 0.1"});  // it takes seconds
            view_test::expect_in_order(session().ui(), std::string(character) + " " + std::to_string(size.width) + "x" +
                                                           std::to_string(size.height) + " scale " +
                                                           std::to_string(size.scale) + ": ");
        }
}

}  // namespace
