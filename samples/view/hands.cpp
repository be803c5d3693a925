#include "samples/view/hands.h"

#include <algorithm>
#include <cmath>

namespace view
{
namespace
{

constexpr float slop_px = 4;  // a click may move the mouse so far
constexpr double walk_m_s = 3;

// Before panels were first drawn, no widget takes a click on their places.
bool inside(const Input &input)
{
    return input.mouse_x >= 0 && input.mouse_y >= 0 && input.mouse_x <= static_cast<float>(input.width) &&
           input.mouse_y <= static_cast<float>(input.height);
}

std::array<float, 2> point_of(const Input &input)
{
    return {2 * input.mouse_x / static_cast<float>(std::max(1, input.width)) - 1,
            1 - 2 * input.mouse_y / static_cast<float>(std::max(1, input.height))};
}

bool any(const bool (&buttons)[button_count]) { return buttons[0] || buttons[1] || buttons[2]; }

}  // namespace

void take_camera(Model &model)
{
    if (model.view.mode == CameraMode::scene) model.view.mode = CameraMode::free;
}

void Hands::act(Model &model, const Input &input, bool for_mouse, bool for_keys)
{
    mouse(model, input, for_mouse);
    if (for_keys) keys(model, input);
    last_ = input;
}

void Hands::mouse(Model &model, const Input &input, bool for_mouse)
{
    if (for_mouse && input.wheel != 0) {
        take_camera(model);
        model.view.free.zoom(static_cast<double>(input.wheel));
    }
    const bool began = any(input.buttons) && !any(last_.buttons);
    if (began) {
        holds_ = for_mouse && inside(input);
        moved_ = false;
        start_x_ = input.mouse_x, start_y_ = input.mouse_y;
    }
    if (!holds_) return;
    if (model.ground.tool != Tool::camera && (last_.buttons[left_button] || input.buttons[left_button])) {
        // The tool has the left button.
        if (input.buttons[left_button] && inside(input)) model.ground.touch = point_of(input);
        if (!any(input.buttons)) holds_ = false;
        return;
    }
    if (std::hypot(input.mouse_x - start_x_, input.mouse_y - start_y_) > slop_px) moved_ = true;
    if (any(input.buttons) && !began && moved_) {
        const double high = std::max(1, input.height);
        const double right = static_cast<double>(input.mouse_x - last_.mouse_x) / high;
        const double down = static_cast<double>(input.mouse_y - last_.mouse_y) / high;
        take_camera(model);
        if (input.buttons[middle_button] || input.shift) {
            model.view.mode = CameraMode::free;
            model.view.free.pan(right, down);
        } else model.view.free.orbit(right, down);
    }
    if (any(input.buttons)) return;
    if (!moved_ && last_.buttons[left_button] && inside(input)) model.wishes.pick = point_of(input);
    holds_ = false;
}

void Hands::keys(Model &model, const Input &input)
{
    const auto held = [&](int code) { return input.keys[static_cast<size_t>(code)]; };
    const auto pressed = [&](int code) { return held(code) && !last_.keys[static_cast<size_t>(code)]; };
    const double step = walk_m_s * (input.shift ? 4 : 1) * std::min(input.elapsed_s, 0.1);
    const double ahead = (held('W') ? step : 0) - (held('S') ? step : 0);
    const double right = (held('D') ? step : 0) - (held('A') ? step : 0);
    if (!input.control && (ahead != 0 || right != 0)) {
        model.view.mode = CameraMode::free;
        model.view.free.walk(right, ahead);
    }
    if (input.control && pressed('Z')) (input.shift ? model.designer.wishes.redo : model.designer.wishes.undo) = true;
    if (pressed('F')) model.wishes.frame_selection = true;
    if (pressed(key::space)) model.clock.paused = !model.clock.paused;
    if (pressed(key::tab)) model.panel = !model.panel;
    if (pressed(key::escape)) model.picked = {};
    for (int number = 1; number <= 9; ++number) {
        if (!pressed('0' + number)) continue;
        auto &kept = model.view.kept[static_cast<size_t>(number - 1)];
        const std::string name = "camera " + std::to_string(number);
        if (input.control) {
            kept = model.view.free;
            model.message = name + " is kept";
        } else if (kept) {
            model.view.mode = CameraMode::free;
            model.view.free = *kept;
        } else model.message = name + " is not kept yet: ctrl+" + std::to_string(number) + " keeps one";
    }
}

}  // namespace view
