// Widgets of the designer used at random: nothing ends the program, and whatever is made can be saved and undone.
#include <cstdlib>
#include <random>

#include "samples/view/designer/design.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class RandomDesigner : public Staged
{
protected:
    // A press somewhere on a widget, a way from there, and words that are typed.
    void use(const view::Widget &widget, std::mt19937 &random, view::Input &input)
    {
        const auto share = [&] { return static_cast<float>(random() % 1001) / 1000; };
        const auto frame = [&] { ASSERT_NO_THROW(session().frame(input)) << widget.name; };
        const auto move = [&] {
            input.mouse_x = widget.box.x0 + (widget.box.x1 - widget.box.x0) * share();
            input.mouse_y = widget.box.y0 + (widget.box.y1 - widget.box.y0) * share();
            frame();
        };
        static const char *const words[] = {"10 200", "0.2 0.5", "#203040", "7", "a\xff", "folk", "1 0", ""};
        move();
        input.buttons[view::left_button] = true;
        frame();
        if (random() % 2 == 0) move(), move();
        input.buttons[view::left_button] = false;
        frame();
        input.text = words[random() % 8];
        frame();
        input.text.clear();
    }
};

TEST_F(RandomDesigner, EndsNothingAndMakesWhatCanBeSavedAndUndone)
{
    const char *asked = std::getenv("CLAQUE_VIEW_EVENTS");
    const int uses = asked ? std::atoi(asked) : 150;
    Stage stage;
    stage.line_up = {"citizen", "plebeian"};
    stage.count = 2, stage.width = 330, stage.height = 900;
    open(stage);
    play({"click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Designer\"", "click \"tool: brush\""});
    view::Designer &designer = session().model().designer;
    std::mt19937 random(3);
    view::Input input;
    input.width = stage.width, input.height = stage.height, input.elapsed_s = 0.04;
    size_t most = 0;
    for (int k = 0; k < uses; ++k) {
        const std::vector<view::Widget> widgets = session().ui().widgets();
        const view::Widget &widget = widgets[random() % widgets.size()];
        input.wheel = static_cast<float>(static_cast<int>(random() % 5) - 2);
        // Thousands of people, or panels that are closed, show nothing more.
        if (widget.name == "people" || widget.name == "panels" || widget.name == "Designer") continue;
        if (widget.box.y0 < widget.clip.y0 || widget.box.y1 > widget.clip.y1) continue;
        use(widget, random, input);
        most = std::max(most, designer.history.done());
        if (!designer.design.classes.empty()) {
            ASSERT_NO_THROW(view::map_of(session().world().context(), designer.design)) << widget.name;
        }
    }
    EXPECT_GT(most, 5u);
    while (view::undo(designer)) {}
    EXPECT_TRUE(designer.design == view::Design());
    play({"wait 0.1"});
    EXPECT_EQ(designer.why_not, "");
}

}  // namespace
