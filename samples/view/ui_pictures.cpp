// Pictures and numbers of panels, and what is asked of the interface as a whole.
#include <algorithm>

#include <imgui.h>

#include "samples/view/gl_calls.h"
#include "samples/view/ui.h"

namespace view
{

void Ui::same_line() { ImGui::SameLine(); }

bool Ui::holds() const { return ImGui::IsAnyItemActive(); }

bool Ui::number(const char *name, float &value, float low, float high, const char *format, float step)
{
    const float label = ImGui::CalcTextSize(name).x + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::max(em_ * 3, ImGui::GetContentRegionAvail().x - label));
    const bool used = ImGui::DragFloat(name, &value, step, low, high, format, ImGuiSliderFlags_AlwaysClamp);
    Box &box = mark(name, used).box;
    box.x1 = std::max(box.x0, box.x1 - label);
    return used;
}

bool Ui::picture(const char *name, const uint8_t *rgba, int side_px, uint64_t number, float side, float &u, float &v)
{
    Uploaded &uploaded = pictures_[name];
    if (uploaded.texture == 0 || uploaded.number != number || uploaded.side_px != side_px)
        uploaded = {put_picture(uploaded.texture, side_px, rgba), number, side_px};
    const ImVec2 low = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
    ImGui::InvisibleButton(name, ImVec2(side, side));
    // Names of textures are passed in a pointer's place, or as numbers since Dear ImGui 1.91.4.
    ImGui::GetWindowDrawList()->AddImage(ImTextureID(uintptr_t(uploaded.texture)), low,
                                         ImVec2(low.x + side, low.y + side));
    u = std::clamp((mouse.x - low.x) / side, 0.0f, 1.0f);
    v = std::clamp((mouse.y - low.y) / side, 0.0f, 1.0f);
    const bool used = ImGui::IsItemActive();
    mark(name, used);
    return used;
}

}  // namespace view
