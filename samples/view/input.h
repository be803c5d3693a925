// What a person does in one frame, wherever it comes from: a window's events or a script.
#pragma once

#include <bitset>
#include <string>

namespace view
{

// Keys are the codes of capital letters and digits, and these.
namespace key
{
constexpr int count = 512;
constexpr int tab = 9, enter = 13, escape = 27, space = 32, backspace = 8, del = 127;
constexpr int left = 256, right = 257, up = 258, down = 259, page_up = 260, page_down = 261, home = 262, end = 263;
}  // namespace key

enum Button { left_button, right_button, middle_button, button_count };

struct Input {
    int width = 1280, height = 800;          // of the picture, in pixels
    double elapsed_s = 0;                    // since the last frame
    float mouse_x = -1e6f, mouse_y = -1e6f;  // pixels from the upper left corner
    bool buttons[button_count] = {};
    float wheel = 0;  // notches away from the person, in this frame
    std::bitset<key::count> keys;
    bool shift = false, control = false;
    std::string text;     // typed in this frame, UTF-8
    std::string dropped;  // a file that was dropped on the window in this frame
};

}  // namespace view
