// What panels say and show, without being used.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "samples/view/ui.h"

namespace view
{

std::string in_lines(const std::string &words, size_t letters)
{
    std::string out = words;
    size_t line = 0, space = std::string::npos;
    for (size_t at = 0; at < out.size(); ++at) {
        if (out[at] == '\n') line = at + 1, space = std::string::npos;
        if (out[at] == ' ' && at > line) space = at;
        if (at - line < letters || space == std::string::npos || out[at] == ' ') continue;
        out[space] = '\n';
        line = space + 1;
        space = std::string::npos;
    }
    return out;
}

size_t line_count(const std::string &words, size_t letters)
{
    const std::string lines = in_lines(words, letters) + '\n';
    size_t count = 0;
    for (size_t from = 0, to = 0; (to = lines.find('\n', from)) != std::string::npos; from = to + 1)
        count += std::max<size_t>(1, (to - from + letters - 1) / letters);
    return count;
}

void Ui::text(const std::string &words)
{
    // All letters of the font are equally wide. What has no space is broken by ImGui.
    const float room = ImGui::GetContentRegionAvail().x / ImGui::CalcTextSize("0").x;
    const std::string lines = in_lines(words, static_cast<size_t>(std::max(1.0f, room)));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopTextWrapPos();
    said_.push_back(placed(words, false));
}

void Ui::faint(const std::string &words)
{
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.62f, 0.66f, 0.70f, 1));
    text(words);
    ImGui::PopStyleColor();
}

void Ui::warning(const std::string &words)
{
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.75f, 0.35f, 1));
    text(words);
    ImGui::PopStyleColor();
}

void Ui::row(const char *name, const std::string &value)
{
    const float start = ImGui::GetCursorPosX();
    faint(name);
    ImGui::SameLine(std::max(start + em_ * 7, ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + em_ / 2));
    text(value);
}

void Ui::swatch(const float (&rgb)[3], const std::string &words)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + 1.6f * em_, at.y + em_),
                                              ImGui::ColorConvertFloat4ToU32(ImVec4(rgb[0], rgb[1], rgb[2], 1)));
    ImGui::Dummy(ImVec2(1.6f * em_, em_));
    ImGui::SameLine();
    text(words);
}

void Ui::plot(const char *name, const std::vector<float> &values, const std::string &words,
              const std::vector<float> &marks)
{
    text(words);
    const float highest = values.empty() ? 1 : *std::max_element(values.begin(), values.end());
    ImGui::PushID(name);
    ImGui::PlotLines("", values.data(), static_cast<int>(values.size()), 0, nullptr, 0, std::max(highest * 1.1f, 1e-3f),
                     ImVec2(ImGui::GetContentRegionAvail().x, 3 * em_));
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    for (const float mark : marks) {
        const float x = std::floor(low.x + mark * (high.x - low.x)) + 0.5f;
        ImGui::GetWindowDrawList()->AddLine(ImVec2(x, low.y), ImVec2(x, high.y), IM_COL32(255, 214, 80, 255));
    }
}

void Ui::space() { ImGui::Spacing(); }

void Ui::mark(float x, float y, const std::string &words)
{
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const ImVec2 at(std::floor(x - size.x / 2), std::floor(y + em_ / 3));
    list->AddRectFilled(ImVec2(at.x - em_ / 4, at.y), ImVec2(at.x + size.x + em_ / 4, at.y + size.y),
                        IM_COL32(0, 0, 0, 170));
    list->AddText(at, IM_COL32(255, 255, 255, 255), words.c_str());
}

void Ui::brackets(const Box &box, const Box &within, const std::string &words)
{
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    list->PushClipRect(ImVec2(within.x0, within.y0), ImVec2(within.x1, within.y1));
    const ImU32 dark = IM_COL32(0, 0, 0, 170), light = IM_COL32(255, 214, 80, 255);
    const float away = em_ * 0.35f;
    const float x[2] = {box.x0 - away, box.x1 + away}, y[2] = {box.y0 - away, box.y1 + away};
    const float arm = std::min({em_, (x[1] - x[0]) / 3, (y[1] - y[0]) / 3});
    for (const auto &[colour, wide] : {std::pair(dark, em_ * 0.3f), std::pair(light, em_ * 0.14f)})
        for (int corner = 0; corner < 4; ++corner) {
            const bool right = (corner & 1) != 0, low = (corner & 2) != 0;
            const float cx = x[right], cy = y[low];
            const ImVec2 line[3] = {ImVec2(cx + (right ? -arm : arm), cy), ImVec2(cx, cy),
                                    ImVec2(cx, cy + (low ? -arm : arm))};
            list->AddPolyline(line, 3, colour, 0, wide);
        }
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    // Above the body, but always within the picture.
    const float edge = em_ * 0.4f;
    const float left = std::min((x[0] + x[1] - size.x) / 2, within.x1 - size.x - edge);
    const float top = std::min(y[0] - size.y - edge, within.y1 - size.y - edge);
    const ImVec2 at(std::floor(std::max(left, within.x0 + edge)), std::floor(std::max(top, within.y0 + edge)));
    list->AddRectFilled(ImVec2(at.x - em_ / 4, at.y), ImVec2(at.x + size.x + em_ / 4, at.y + size.y), dark);
    list->AddText(at, light, words.c_str());
    list->PopClipRect();
}

}  // namespace view
