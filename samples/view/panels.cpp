#include "samples/view/panels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "samples/view/designer/panel.h"
#include "samples/view/ground/ground_panels.h"

namespace view
{

std::string fixed(double value, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string whole(uint64_t value)
{
    std::string text = std::to_string(value);
    for (size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ' ');
    return text;
}

std::string memory(uint64_t bytes)
{
    const double mib = static_cast<double>(bytes) / (1 << 20);
    return mib >= 1 ? fixed(mib, 1) + " MiB" : fixed(mib * 1024, 1) + " KiB";
}

std::string milliseconds(double value) { return value < 0 ? "not measured" : fixed(value, 2) + " ms"; }

Layout layout_of(const Ui &ui, const Model &model, int width, int height)
{
    const float w = static_cast<float>(width), h = static_cast<float>(height);
    const float side = model.panel ? std::min(24 * ui.em(), w * 0.6f) : 0;
    // A long sentence takes more lines of the lower bar.
    constexpr float letter_em = 0.54f;
    const auto room = static_cast<size_t>(std::max(1.0f, (w - 2 * ui.em()) / (letter_em * ui.em())));
    const float lines = static_cast<float>(line_count(status(model, room), room));
    const float high = std::min((6 + 1.1f * std::max(0.0f, lines - 1)) * ui.em(), h / 2);
    const float x = std::floor(w - side), y = std::floor(h - high);
    return {{x, 0, w, y}, {0, y, w, h}, std::max(1, static_cast<int>(x)), std::max(1, static_cast<int>(y)), room};
}

void panels(Ui &ui, Model &model, const World &world, const Input &input)
{
    const Layout layout = layout_of(ui, model, input.width, input.height);
    ui.begin_panel("bottom", layout.bottom);
    time_bar(ui, model, layout.letters);
    ui.end_panel();
    if (!model.panel) return;
    ui.begin_panel("side", layout.side);
    if (ui.section("Camera", model.open.camera)) camera_panel(ui, model, world);
    if (ui.section("Person", model.open.person)) person_panel(ui, model, world);
    if (ui.section("Character", model.open.character)) character_panel(ui, model, world);
    if (ui.section("Designer", model.open.designer)) designer_panel(ui, model, world);
    ground_panels(ui, model, world);
    if (ui.section("Frame", model.open.frame)) frame_panel(ui, model, world);
    ui.end_panel();
}

void marks(Ui &ui, const Model &model, const World &world)
{
    level_marks(ui, world);
    Box box;
    if (model.picked.actor.index1 == 0 || !world.outline(model.picked.actor, box)) return;
    const Box picture = {0, 0, static_cast<float>(world.width()), static_cast<float>(world.height())};
    ui.brackets(box, picture, "person " + std::to_string(model.picked.actor.index1));
}

}  // namespace view
