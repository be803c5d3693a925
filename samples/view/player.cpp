// Steps of a script as frames of input.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "samples/scenes/odeon/toml_table.h"
#include "samples/view/script.h"

namespace view
{
namespace
{

constexpr int drag_frames = 6, most_scrolls = 300;

[[noreturn]] void fail(const Step &step, const std::string &sentence)
{
    throw scenes::Failure(step.at + ": " + sentence);
}

double number(const Step &step, size_t word, double low, double high)
{
    const std::string &text = step.words.at(word);
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != 0 || !(value >= low && value <= high))
        fail(step, "'" + text + "' is no number from " + scenes::show(low) + " to " + scenes::show(high));
    return value;
}

int key_named(const Step &step, const std::string &name)
{
    static const std::pair<const char *, int> names[] = {
        {"tab", key::tab},     {"enter", key::enter},         {"escape", key::escape},
        {"space", key::space}, {"backspace", key::backspace}, {"delete", key::del},
        {"left", key::left},   {"right", key::right},         {"up", key::up},
        {"down", key::down},   {"home", key::home},           {"end", key::end}};
    if (name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9'))) return name[0];
    for (const auto &[known, code] : names)
        if (name == known) return code;
    fail(step, "'" + name +
                   "' is no key: A to Z, 0 to 9, tab, enter, escape, space, backspace, delete, home, end or "
                   "an arrow, after shift+ and ctrl+");
}

Button button_named(const Step &step, const std::string &name)
{
    if (name == "left") return left_button;
    if (name == "middle") return middle_button;
    if (name == "right") return right_button;
    fail(step, "'" + name + "' is no button: left, middle or right");
}

}  // namespace

Player::Player(Script script, int width, int height)
    : script_(std::move(script)), most_width_(width), most_height_(height)
{
    now_.width = width, now_.height = height;
    frames_.assign(2, still());  // panels know their sizes from the second frame on
}

Input Player::still() const
{
    Input input = now_;
    input.elapsed_s = 1 / script_.frames_per_s;
    input.wheel = 0;
    input.text.clear();
    input.dropped.clear();
    input.keys.reset();
    return input;
}

bool Player::next(Input &input, const Ui &ui, const World &world)
{
    shot_.clear();
    while (frames_.empty()) {
        if (at_ == script_.steps.size()) return false;
        again_ = false;
        begin(script_.steps[at_], ui, world);
        if (!again_) ++at_, scrolls_ = 0;
    }
    input = frames_.front();
    frames_.pop_front();
    if (frames_.empty()) shot_.swap(pending_shot_);
    return true;
}

void Player::begin(const Step &step, const Ui &ui, const World &world)
{
    const std::string &verb = step.words[0];
    if (verb == "click") click(step, ui, world);
    else if (verb == "drag") drag(step, ui, world);
    else if (verb == "type") type(step, ui);
    else if (verb == "key") press_keys(step);
    else if (verb == "wheel") turn_wheel(step, world);
    else if (verb == "wait") wait(step);
    else if (verb == "size") resize(step);
    else if (verb == "drop") drop(step);
    else if (verb == "see") see(step, ui);
    else {
        pending_shot_ = step.words[1];
        frames_.push_back(still());
        // A picture takes no time.
        frames_.back().elapsed_s = 0;
    }
}

// Where a widget is; scrolls its panel where it is out of sight.
Box Player::reach(const Step &step, const std::string &name, const Ui &ui)
{
    const Widget *widget = ui.find(name);
    if (!widget) {
        std::string names;
        for (const Widget &one : ui.widgets()) names += (names.empty() ? "" : ", ") + one.name;
        fail(step, "there is no widget '" + name + "' in sight; there are: " + names);
    }
    const Box &box = widget->box, &clip = widget->clip;
    const float middle = (box.y0 + box.y1) / 2, high = box.y1 - box.y0;
    // Any place of a tall one may be meant, so all of it has to be in sight.
    const float above = high > 4 * ui.em() && high < (clip.y1 - clip.y0) / 2 ? high / 2 : 0;
    if (middle - above > clip.y0 && middle + above < clip.y1) return box;
    if (++scrolls_ > most_scrolls) fail(step, "the widget '" + name + "' cannot be scrolled into sight");
    move((clip.x0 + clip.x1) / 2, (clip.y0 + clip.y1) / 2);
    frames_.push_back(still());
    frames_.back().wheel = middle + above >= clip.y1 ? -1.0f : 1.0f;
    frames_.push_back(still());
    again_ = true;
    return box;
}

void Player::move(float x, float y) { now_.mouse_x = x, now_.mouse_y = y; }

void Player::press(float x, float y, Button button)
{
    move(x, y);
    frames_.push_back(still());
    now_.buttons[button] = true;
    frames_.push_back(still());
    now_.buttons[button] = false;
    // A panel that grows by the click gets a scroll bar in the frame after.
    for (int k = 0; k < 3; ++k) frames_.push_back(still());
}

void Player::click(const Step &step, const Ui &ui, const World &world)
{
    if (step.words.size() == 3 && step.words[1] != "person") fail(step, "a click is on a widget, or on person NUMBER");
    if (step.words.size() == 3) {
        float x = 0, y = 0;
        const auto person = static_cast<uint32_t>(number(step, 2, 1, 1e9));
        if (!world.point_on(person, x, y)) fail(step, "person " + step.words[2] + " is nowhere in the picture");
        return press(x, y, left_button);
    }
    const Box box = reach(step, step.words[1], ui);
    if (!again_) press((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, left_button);
}

void Player::drag(const Step &step, const Ui &ui, const World &world)
{
    const bool on_view = step.words[1] == "view";
    const bool across = step.words.size() == 4;
    if (step.words.size() == 5 || (!on_view && step.words.size() > 6))
        fail(step, "a drag has two places: FROM TO, or X0 Y0 X1 Y1");
    const Box box = on_view ? Box{0, 0, static_cast<float>(world.width()), static_cast<float>(world.height())}
                            : reach(step, step.words[1], ui);
    if (again_) return;
    float from[2] = {0, 0.5f}, to[2] = {0, 0.5f};
    for (size_t k = 0; k < (across ? 1u : 2u); ++k) {
        from[k] = static_cast<float>(number(step, 2 + k, 0, 1));
        to[k] = static_cast<float>(number(step, (across ? 3u : 4u) + k, 0, 1));
    }
    const Button button = step.words.size() == 7 ? button_named(step, step.words[6]) : left_button;
    const Widget *widget = on_view ? nullptr : ui.find(step.words[1]);
    const auto place = [&](float t) {
        if (across && widget && widget->round) return turn_to(box, from[0], to[0], t);
        move(box.x0 + (box.x1 - box.x0) * (from[0] + (to[0] - from[0]) * t),
             box.y0 + (box.y1 - box.y0) * (from[1] + (to[1] - from[1]) * t));
        frames_.push_back(still());
    };
    place(0);
    now_.buttons[button] = true;
    for (int k = 0; k <= drag_frames; ++k) place(static_cast<float>(k) / drag_frames);
    now_.buttons[button] = false;
    place(1);
    place(1);
}

// On a circle, onwards from one place to another; across its top where the second place comes first.
void Player::turn_to(const Box &box, float from, float to, float t)
{
    const double angle = 6.283185307179586 * static_cast<double>(from + (to + (to < from ? 1 : 0) - from) * t);
    const double radius = 0.42 * static_cast<double>(box.x1 - box.x0);
    move((box.x0 + box.x1) / 2 + static_cast<float>(radius * std::sin(angle)),
         (box.y0 + box.y1) / 2 - static_cast<float>(radius * std::cos(angle)));
    frames_.push_back(still());
}

void Player::type(const Step &step, const Ui &ui)
{
    const Box box = reach(step, step.words[1], ui);
    if (again_) return;
    press((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, left_button);
    Input all = still();
    all.control = true;
    all.keys['A'] = true;
    frames_.push_back(all);
    frames_.push_back(still());
    frames_.push_back(still());
    frames_.back().text = step.words[2];
    frames_.push_back(still());
}

void Player::press_keys(const Step &step)
{
    std::string name = step.words[1];
    Input held = still();
    for (size_t plus = name.find('+'); plus != std::string::npos && plus > 0; plus = name.find('+')) {
        const std::string with = name.substr(0, plus);
        if (with != "shift" && with != "ctrl") fail(step, "'" + with + "' is no key to hold: shift or ctrl");
        (with == "shift" ? held.shift : held.control) = true;
        name.erase(0, plus + 1);
    }
    held.keys[static_cast<size_t>(key_named(step, name))] = true;
    const double seconds = step.words.size() > 2 ? number(step, 2, 0, 600) : 0;
    const int frames = std::max(1, static_cast<int>(std::lround(seconds * script_.frames_per_s)));
    for (int k = 0; k < frames; ++k) frames_.push_back(held);
    frames_.push_back(still());
}

void Player::turn_wheel(const Step &step, const World &world)
{
    const double notches = number(step, 1, -1000, 1000);
    const float width = static_cast<float>(world.width()), height = static_cast<float>(world.height());
    if (now_.mouse_x < 0 || now_.mouse_x >= width || now_.mouse_y >= height) move(width / 2, height / 2);
    frames_.push_back(still());
    frames_.push_back(still());
    frames_.back().wheel = static_cast<float>(notches);
    frames_.push_back(still());
}

void Player::wait(const Step &step)
{
    const double seconds = number(step, 1, 0, 3600);
    const bool counted = step.words.size() > 2;
    const long frames = std::lround(counted ? number(step, 2, 1, 1e6) : seconds * script_.frames_per_s);
    for (long k = 0; k < frames; ++k) {
        frames_.push_back(still());
        if (counted) frames_.back().elapsed_s = seconds / static_cast<double>(frames);
    }
}

void Player::resize(const Step &step)
{
    const std::string &text = step.words[1];
    const size_t x = text.find('x');
    Step sides = step;
    sides.words = {text.substr(0, x), x == std::string::npos ? "" : text.substr(x + 1)};
    now_.width = static_cast<int>(number(sides, 0, 1, most_width_));
    now_.height = static_cast<int>(number(sides, 1, 1, most_height_));
    frames_.push_back(still());
    frames_.push_back(still());
}

void Player::drop(const Step &step)
{
    frames_.push_back(still());
    frames_.back().dropped = step.words[1];
    frames_.push_back(still());  // panels of what is shown now
    frames_.push_back(still());
}

void Player::see(const Step &step, const Ui &ui) const
{
    std::string all;
    for (const Widget &text : ui.texts()) {
        if (text.name.find(step.words[1]) != std::string::npos) return;
        all += (all.empty() ? "" : " / ") + text.name;
    }
    fail(step, "the panels do not say '" + step.words[1] + "' but: " + all);
}

}  // namespace view
