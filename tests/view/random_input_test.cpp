// Input that no person makes: nothing ends the program, and what is shown stays a function of the model.
#include <cstdlib>
#include <random>

#include "tests/view/staged.h"

namespace
{

using view_test::Staged;

// CLAQUE_VIEW_EVENTS: how many, in place of a number that takes seconds.
int number_from(const char *variable, int otherwise)
{
    const char *text = std::getenv(variable);
    return text ? std::atoi(text) : otherwise;
}
int event_count() { return number_from("CLAQUE_VIEW_EVENTS", 400); }
// CLAQUE_VIEW_SIDE: of the largest window, in place of one that is drawn quickly.
int most_side() { return number_from("CLAQUE_VIEW_SIDE", 1024); }

class RandomInput : public Staged
{
};

TEST_F(RandomInput, EndsNothing)
{
    constexpr int side = 400;
    const int most = most_side(), sizes[][2] = {{most, most}, {1, 1}, {most, 1}, {1, most}, {side, side / 2}};
    view::Session &s = open({"parade", 4, most, most});
    std::mt19937 random(7);
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    view::Input input;
    input.width = input.height = side;
    int frames = 0, resized = 0, lost = 0;
    for (int event = 0; event < event_count(); ++event, ++frames) {
        input.wheel = 0;
        input.text.clear();
        input.elapsed_s = below(20) == 0 ? below(1000) : below(100) / 1000.0;
        switch (below(8)) {
            case 0:
                input.buttons[below(view::button_count)] ^= true;
                break;
            case 1:
                input.wheel = static_cast<float>(below(41) - 20);
                break;
            case 2:
                input.keys.flip(static_cast<size_t>(below(view::key::count)));
                break;
            case 3:
                input.keys.reset();
                break;
            case 4:
                input.text = below(2) == 0 ? "a\xff\xfe" : "0\xe2\x82\xac";
                break;
            case 5:
                if (below(6) != 0) break;
                input.width = 1 + below(side), input.height = 1 + below(side);
                break;
            case 6:
                input.shift = below(2) == 0, input.control = below(2) == 0;
                break;
            default:
                input.mouse_x = static_cast<float>(below(2 * side) - side / 2);
                input.mouse_y = static_cast<float>(below(2 * side) - side / 2);
        }
        // Twenty times a size that no person chooses, for a frame; then one that does not take long.
        const int part = std::max(1, event_count() / 20);
        if (event % part == 0) {
            const int *size = sizes[resized++ % 5];
            input.width = size[0], input.height = size[1];
        } else if (event % part == 1) input.width = input.height = side;
        ASSERT_NO_THROW(s.frame(input)) << "event " << event;
        if (event % (5 * part) == 3) {
            ASSERT_NO_THROW(s.renew()) << "event " << event;
            ++lost;
        }
    }
    EXPECT_GE(resized, 20);
    EXPECT_GE(lost, 4);
    EXPECT_EQ(frames, event_count());
    const uint32_t asked = s.model().designer.people;
    EXPECT_EQ(clq_crowd_get_actor_count(s.world().crowd()), asked > 0 ? asked : 4u);
}

// A window may get a click before its first picture.
TEST_F(RandomInput, MayClickBeforeThePanelsAreThere)
{
    view::Session &s = open({});
    view::Input input;
    input.width = input.height = 480;
    input.mouse_x = 100, input.mouse_y = 470;
    input.buttons[view::left_button] = true;
    EXPECT_NO_THROW(s.frame(input));
    input.buttons[view::left_button] = false;
    EXPECT_NO_THROW(s.frame(input));
    EXPECT_NO_THROW(s.frame(input));
}

}  // namespace
