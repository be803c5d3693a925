#include "samples/view/designer/widgets.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <imgui.h>

namespace view
{
namespace
{

constexpr float turn = 6.2831853f;

ImU32 hsb_colour(float hue_deg, float saturation, float brightness, float dim = 1)
{
    float rgb[3];
    rgb_of({hue_deg, hue_deg, saturation, saturation, brightness, brightness}, rgb);
    return ImGui::ColorConvertFloat4ToU32(ImVec4(rgb[0] * dim, rgb[1] * dim, rgb[2] * dim, 1));
}

struct Dial {
    ImVec2 middle;
    float outer, inner;

    ImVec2 at(float degrees, float radius) const
    {
        const float angle = degrees / 360 * turn;
        return ImVec2(middle.x + radius * std::sin(angle), middle.y - radius * std::cos(angle));
    }
    float degrees_of(const ImVec2 &point) const
    {
        const float degrees = std::atan2(point.x - middle.x, middle.y - point.y) / turn * 360;
        return degrees < 0 ? degrees + 360 : degrees;
    }
};

bool within_arc(float degrees, const clq_hsb_range &range)
{
    return range.hue_min_deg <= range.hue_max_deg ? degrees >= range.hue_min_deg && degrees <= range.hue_max_deg
                                                  : degrees >= range.hue_min_deg || degrees <= range.hue_max_deg;
}

// A part of the ring from `first` to `last`, as two triangles of one colour.
void ring_part(ImDrawList &list, const Dial &dial, float first, float last, ImU32 colour)
{
    const ImVec2 corners[4] = {dial.at(first, dial.inner), dial.at(first, dial.outer), dial.at(last, dial.outer),
                               dial.at(last, dial.inner)};
    list.PrimReserve(6, 4);
    const auto base = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
    for (const int k : {0, 1, 2, 0, 2, 3}) list.PrimWriteIdx(static_cast<ImDrawIdx>(base + k));
    for (const ImVec2 &corner : corners) list.PrimWriteVtx(corner, ImGui::GetFontTexUvWhitePixel(), colour);
}

void draw_arc(const Dial &dial, const clq_hsb_range &range, float line)
{
    ImDrawList &list = *ImGui::GetWindowDrawList();
    constexpr float step = 2;
    for (float hue = 0; hue < 360; hue += step)
        ring_part(list, dial, hue, hue + step, hsb_colour(hue, 1, 1, within_arc(hue + step / 2, range) ? 1.0f : 0.28f));
    for (const float end : {range.hue_min_deg, range.hue_max_deg}) {
        const ImVec2 inner = dial.at(end, dial.inner - 2 * line), outer = dial.at(end, dial.outer);
        list.AddLine(inner, outer, IM_COL32(0, 0, 0, 255), 3 * line);
        list.AddLine(inner, outer, IM_COL32(255, 255, 255, 255), line);
    }
}

void frame_box(ImDrawList &list, const ImVec2 &a, const ImVec2 &b, float line)
{
    list.AddRect(a, b, IM_COL32(0, 0, 0, 255), 0, 0, 3 * line);
    list.AddRect(a, b, IM_COL32(255, 255, 255, 255), 0, 0, line);
}

void draw_shades(const ImVec2 &low, float side, const clq_hsb_range &range, float line)
{
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 high(low.x + side, low.y + side);
    const ImU32 hue = hsb_colour(middle_hue_deg(range), 1, 1), white = IM_COL32(255, 255, 255, 255);
    const ImU32 clear = IM_COL32(0, 0, 0, 0), black = IM_COL32(0, 0, 0, 255), shade = IM_COL32(0, 0, 0, 150);
    list.AddRectFilledMultiColor(low, high, white, hue, hue, white);
    list.AddRectFilledMultiColor(low, high, clear, clear, black, black);
    const ImVec2 a(std::floor(low.x + side * range.saturation_min),
                   std::floor(low.y + side * (1 - range.brightness_max)));
    const ImVec2 b(std::ceil(low.x + side * range.saturation_max),
                   std::ceil(low.y + side * (1 - range.brightness_min)));
    list.AddRectFilled(low, ImVec2(high.x, a.y), shade);
    list.AddRectFilled(ImVec2(low.x, b.y), high, shade);
    list.AddRectFilled(ImVec2(low.x, a.y), ImVec2(a.x, b.y), shade);
    list.AddRectFilled(ImVec2(b.x, a.y), ImVec2(high.x, b.y), shade);
    frame_box(list, a, b, line);
}

float hundredth(float share) { return std::round(std::clamp(share, 0.0f, 1.0f) * 100) / 100; }

}  // namespace

void arc_of(const Sweep &sweep, float &from_deg, float &to_deg)
{
    const auto whole = [](float degrees) { return std::fmod(std::round(degrees) + 720, 360.0f); };
    from_deg = whole(sweep.swept < 0 ? sweep.start + sweep.swept : sweep.start);
    to_deg = whole(sweep.swept < 0 ? sweep.start : sweep.start + sweep.swept);
    // All hues; also where both ends are rounded to one degree after nearly a turn.
    if (std::fabs(sweep.swept) >= 360 || (std::fabs(sweep.swept) > 180 && from_deg == to_deg))
        from_deg = 0, to_deg = 360;
}

bool hue_arc(Ui &ui, const char *name, float side, Sweep &sweep, clq_hsb_range &range)
{
    const ImVec2 low = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
    const Dial dial = {ImVec2(low.x + side / 2, low.y + side / 2), side / 2, side * 0.34f};
    ImGui::InvisibleButton(name, ImVec2(side, side));
    bool used = false;
    if (ImGui::IsItemActivated()) {
        sweep.start = sweep.last = dial.degrees_of(mouse);
        sweep.swept = 0;
    } else if (ImGui::IsItemActive()) {
        const float now = dial.degrees_of(mouse);
        float moved = now - sweep.last;
        if (moved > 180) moved -= 360;
        if (moved < -180) moved += 360;
        sweep.last = now;
        sweep.swept += moved;
        // A click alone, or a hand that trembles, is no range.
        if (moved != 0 && std::fabs(sweep.swept) >= 2) {
            const clq_hsb_range before = range;
            arc_of(sweep, range.hue_min_deg, range.hue_max_deg);
            used = !same(before, range);
        }
    }
    draw_arc(dial, range, std::max(1.0f, ui.em() / 13));
    ui.mark(name, used).round = true;
    return used;
}

bool shade_box(Ui &ui, const char *name, float side, clq_hsb_range &range)
{
    const ImVec2 low = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
    ImGui::InvisibleButton(name, ImVec2(side, side));
    bool used = false;
    const ImVec2 start = ImGui::GetIO().MouseClickedPos[0];
    const bool moved = std::max(std::fabs(mouse.x - start.x), std::fabs(mouse.y - start.y)) >= 3;
    if (ImGui::IsItemActive() && moved) {
        const clq_hsb_range before = range;
        const float s[2] = {hundredth((start.x - low.x) / side), hundredth((mouse.x - low.x) / side)};
        const float b[2] = {hundredth(1 - (start.y - low.y) / side), hundredth(1 - (mouse.y - low.y) / side)};
        range.saturation_min = std::min(s[0], s[1]), range.saturation_max = std::max(s[0], s[1]);
        range.brightness_min = std::min(b[0], b[1]), range.brightness_max = std::max(b[0], b[1]);
        used = !same(before, range);
    }
    draw_shades(low, side, range, std::max(1.0f, ui.em() / 13));
    ui.mark(name, used);
    return used;
}

bool palette_bar(Ui &ui, const char *name, const std::vector<clq_palette_entry> &palette, size_t &chosen)
{
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = 1.4f * ui.em();
    ImGui::InvisibleButton(name, ImVec2(width, high));
    const bool pressed = ImGui::IsItemClicked();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    float all = 0, before = 0;
    for (const clq_palette_entry &one : palette) all += one.weight;
    bool used = false;
    ImVec2 marked[2] = {low, low};
    for (size_t k = 0; k < palette.size(); ++k) {
        const ImVec2 a(std::floor(low.x + width * before / all), low.y);
        before += palette[k].weight;
        const ImVec2 b(std::floor(low.x + width * before / all), low.y + high);
        float rgb[3];
        rgb_of(palette[k].range, rgb);
        list.AddRectFilled(a, b, ImGui::ColorConvertFloat4ToU32(ImVec4(rgb[0], rgb[1], rgb[2], 1)));
        if (pressed && ImGui::GetIO().MousePos.x >= a.x && ImGui::GetIO().MousePos.x < b.x && k != chosen) {
            chosen = k;
            used = true;
        }
        if (k == chosen) marked[0] = a, marked[1] = b;
    }
    frame_box(list, marked[0], marked[1], std::max(1.0f, ui.em() / 13));
    ui.mark(name, used);
    return used;
}

std::string show(float value)
{
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

bool read_pair(const std::string &text, float most, bool ordered, float &first, float &second)
{
    float values[2];
    const char *at = text.c_str();
    for (float &value : values) {
        char *end = nullptr;
        value = static_cast<float>(std::strtod(at, &end));
        if (end == at || !(value >= 0 && value <= most)) return false;
        at = end;
        while (*at == ' ' || *at == ',') ++at;
    }
    if (*at != 0 || (ordered && values[0] > values[1])) return false;
    first = values[0], second = values[1];
    return true;
}

bool pair_field(Ui &ui, const char *name, float &first, float &second, float most, bool ordered)
{
    std::string text = show(first) + " " + show(second);
    float typed[2] = {first, second};
    if (!ui.text_field(name, text) || !read_pair(text, most, ordered, typed[0], typed[1])) return false;
    if (typed[0] == first && typed[1] == second) return false;
    first = typed[0], second = typed[1];
    return true;
}

}  // namespace view
