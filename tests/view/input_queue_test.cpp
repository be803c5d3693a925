// What a window tells, as the input of frames: nothing of it is lost, and the picture shows it soon.
#include "samples/view/input_queue.h"

#include "samples/view/serve/keys.h"
#include "tests/view/staged.h"

namespace
{

using view::Event;
using view::Input;
using view::InputQueue;
using view_test::Staged;

TEST(InputQueue, ShowsAClickWithinAFrameInTwo)
{
    InputQueue queue;
    queue.push({Event::Kind::move, 10, 20});
    queue.push({Event::Kind::button, 0, 0, view::left_button, true});
    queue.push({Event::Kind::move, 90, 20});
    queue.push({Event::Kind::button, 0, 0, view::left_button, false});
    Input input;
    queue.next(input);
    EXPECT_TRUE(input.buttons[view::left_button]);
    EXPECT_EQ(input.mouse_x, 10);  // where it began
    queue.next(input);
    EXPECT_FALSE(input.buttons[view::left_button]);
    EXPECT_EQ(input.mouse_x, 90);
}

TEST(InputQueue, SumsTheWheelAndTheTextOfAFrameAndForgetsThemInTheNext)
{
    InputQueue queue;
    queue.push({Event::Kind::wheel, 0, 1});
    queue.push({Event::Kind::wheel, 0, -3});
    queue.push({Event::Kind::text, 0, 0, 0, false, "sal"});
    queue.push({Event::Kind::text, 0, 0, 0, false, "ve"});
    Input input;
    input.width = 7;
    queue.next(input);
    EXPECT_EQ(input.wheel, -2);
    EXPECT_EQ(input.text, "salve");
    EXPECT_EQ(input.width, 7);
    queue.next(input);
    EXPECT_EQ(input.wheel, 0);
    EXPECT_EQ(input.text, "");
}

TEST(InputQueue, LeavesNothingPressedWhenMoreComesThanItKeeps)
{
    InputQueue queue;
    Input input;
    queue.push({Event::Kind::key, 0, 0, 'W', true});
    queue.next(input);
    EXPECT_TRUE(input.keys['W']);
    for (int k = 0; k < 10000; ++k) queue.push({Event::Kind::key, 0, 0, 'A', k % 2 == 0});
    queue.next(input);
    EXPECT_FALSE(input.keys['W']);
}

TEST(Keys, OfAViewerBecomeKeysTextAndButtons)
{
    InputQueue queue;
    view::serve::Keys keys(queue);
    keys.pointer(0, 5, 6);
    keys.pointer(1 | 8, 5, 6);
    keys.key('a', true);
    keys.key(0xe9, true);        // e with an acute accent, in Latin-1
    keys.key(0x010020ac, true);  // the Euro sign
    keys.key(0xff51, true);
    Input input;
    queue.next(input);
    EXPECT_TRUE(input.buttons[view::left_button]);
    EXPECT_EQ(input.wheel, 1);
    EXPECT_EQ(input.text, "a\xc3\xa9\xe2\x82\xac");
    EXPECT_TRUE(input.keys['A']);
    EXPECT_TRUE(input.keys[view::key::left]);
    keys.key(0xffe3, true);
    keys.key('a', false), keys.key('a', true);
    queue.next(input), queue.next(input);
    EXPECT_TRUE(input.control);
    EXPECT_EQ(input.text, "") << "with control it is a command";
    keys.release();
    queue.next(input);
    EXPECT_FALSE(input.control || input.buttons[view::left_button] || input.keys.any());
}

class InputReaches : public Staged
{
protected:
    // Frames until the picture differs from one without the events, time standing still.
    int frames_until_seen(const std::vector<Event> &events)
    {
        view::Session &s = open({});
        s.model().clock.paused = true;
        Input input;
        input.width = input.height = 480;
        InputQueue queue;
        queue.push({Event::Kind::move, 100, 100});
        for (int frame = 0; frame < 4; ++frame) queue.next(input), s.frame(input);
        const std::vector<uint8_t> before = window();
        for (const Event &event : events) queue.push(event);
        for (int frame = 1; frame <= 10; ++frame) {
            queue.next(input);
            s.frame(input);
            if (window() != before) return frame;
        }
        return 0;
    }
};

TEST_F(InputReaches, ThePictureWithinTwoFrames)
{
    open({});
    play({});
    const view::Widget *pause = session().ui().find("pause");
    ASSERT_NE(pause, nullptr);
    const float x = (pause->box.x0 + pause->box.x1) / 2, y = (pause->box.y0 + pause->box.y1) / 2;
    const auto seen = [&](const std::vector<Event> &events) {
        const int frames = frames_until_seen(events);
        return frames > 0 && frames <= 2;
    };
    EXPECT_TRUE(seen({{Event::Kind::wheel, 0, 2}}));
    EXPECT_TRUE(seen({{Event::Kind::key, 0, 0, view::key::tab, true}}));
    EXPECT_TRUE(seen({{Event::Kind::button, 0, 0, view::left_button, true}, {Event::Kind::move, 160, 130}}));
    EXPECT_TRUE(seen({{Event::Kind::move, x, y},
                      {Event::Kind::button, 0, 0, view::left_button, true},
                      {Event::Kind::button, 0, 0, view::left_button, false}}));
    EXPECT_EQ(frames_until_seen({}), 0);
}

}  // namespace
