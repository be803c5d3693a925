#include "samples/view/ui.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_impl_opengl2.h>

#include "samples/view/gl_calls.h"

namespace view
{
namespace
{

constexpr float letter_px = 13;  // of ImGui's own font, which is drawn for this size and its multiples

constexpr struct {
    ImGuiKey theirs;
    int ours;
} keys[] = {{ImGuiKey_Tab, key::tab},
            {ImGuiKey_LeftArrow, key::left},
            {ImGuiKey_RightArrow, key::right},
            {ImGuiKey_UpArrow, key::up},
            {ImGuiKey_DownArrow, key::down},
            {ImGuiKey_PageUp, key::page_up},
            {ImGuiKey_PageDown, key::page_down},
            {ImGuiKey_Home, key::home},
            {ImGuiKey_End, key::end},
            {ImGuiKey_Delete, key::del},
            {ImGuiKey_Backspace, key::backspace},
            {ImGuiKey_Space, key::space},
            {ImGuiKey_Enter, key::enter},
            {ImGuiKey_Escape, key::escape},
            {ImGuiKey_A, 'A'},
            {ImGuiKey_C, 'C'},
            {ImGuiKey_V, 'V'},
            {ImGuiKey_X, 'X'},
            {ImGuiKey_Y, 'Y'},
            {ImGuiKey_Z, 'Z'}};

// Dear ImGui took an array of keys up to 1.91.4, and takes events since 1.87.
#if IMGUI_VERSION_NUM < 19150
void set_keys(ImGuiIO &io)
{
    for (const auto &key : keys) io.KeyMap[key.theirs] = key.ours;
}

void put_keys(ImGuiIO &io, const Input &input)
{
    for (int k = 0; k < key::count; ++k) io.KeysDown[k] = input.keys[static_cast<size_t>(k)];
    io.KeyShift = input.shift;
    io.KeyCtrl = input.control;
}
#else
void set_keys(ImGuiIO &io) { io.ConfigInputTrickleEventQueue = false; }  // all keys of a frame count in it

void put_keys(ImGuiIO &io, const Input &input)
{
    io.AddKeyEvent(ImGuiMod_Shift, input.shift);
    io.AddKeyEvent(ImGuiMod_Ctrl, input.control);
    for (const auto &key : keys) io.AddKeyEvent(key.theirs, input.keys[static_cast<size_t>(key.ours)]);
}
#endif

void set_style(float scale)
{
    ImGui::StyleColorsDark();
    ImGuiStyle &style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.FrameRounding = 2;
    style.ItemSpacing = ImVec2(6, 5);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.11f, 1);
    style.Colors[ImGuiCol_Header] = ImVec4(0.20f, 0.24f, 0.28f, 1);
    style.AntiAliasedLinesUseTex = false;
    style.ScaleAllSizes(scale);
}

Box box_of(const ImVec2 &first, const ImVec2 &last) { return {first.x, first.y, last.x, last.y}; }

}  // namespace

Ui::Ui(float scale) : context_(ImGui::CreateContext()), em_(letter_px * std::max(1.0f, std::round(scale)))
{
    ImGui::SetCurrentContext(context_);
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigDragClickToInputText = true;
    set_keys(io);
    set_style(em_ / letter_px);
    ImFontConfig font;
    font.SizePixels = em_;
    font.OversampleH = font.OversampleV = 1;
    font.PixelSnapH = true;
    io.Fonts->AddFontDefault(&font);
    ImGui_ImplOpenGL2_Init();
}

Ui::~Ui()
{
    ImGui::SetCurrentContext(context_);
    for (const auto &[name, uploaded] : pictures_) drop_picture(uploaded.texture);
    ImGui_ImplOpenGL2_Shutdown();
    ImGui::DestroyContext(context_);
}

void Ui::begin(const Input &input)
{
    ImGui::SetCurrentContext(context_);
    ImGuiIO &io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(input.width), static_cast<float>(input.height));
    io.DeltaTime = static_cast<float>(std::clamp(input.elapsed_s, 1e-4, 1.0));
    io.MousePos = ImVec2(input.mouse_x, input.mouse_y);
    for (int k = 0; k < button_count; ++k) io.MouseDown[k] = input.buttons[k];
    io.MouseWheel = input.wheel;
    put_keys(io, input);
    io.AddInputCharactersUTF8(input.text.c_str());
    ImGui_ImplOpenGL2_NewFrame();
    ImGui::NewFrame();
}

void Ui::forget_context()
{
    ImGui::SetCurrentContext(context_);
    ImGui_ImplOpenGL2_DestroyDeviceObjects();
    pictures_.clear();
}

void Ui::draw() { ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData()); }

void Ui::close()
{
    ImGui::Render();
    widgets_ = std::move(drawn_);
    texts_ = std::move(said_);
    drawn_.clear();
    said_.clear();
}

void Ui::begin_panel(const char *name, const Box &box)
{
    ImGui::SetNextWindowPos(ImVec2(box.x0, box.y0));
    ImGui::SetNextWindowSize(ImVec2(box.x1 - box.x0, box.y1 - box.y0));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
}

void Ui::end_panel() { ImGui::End(); }

Widget Ui::placed(const std::string &name, bool used) const
{
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float bar = ImGui::GetScrollMaxY() > 0 ? ImGui::GetStyle().ScrollbarSize : 0;
    return {name,
            box_of(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()),
            {at.x, at.y, at.x + size.x - bar, at.y + size.y},
            used};
}

Widget &Ui::mark(const std::string &name, bool used)
{
    drawn_.push_back(placed(name, used));
    return drawn_.back();
}

bool Ui::note(const std::string &name, bool used) { return mark(name, used).used; }

bool Ui::section(const char *name, bool &open)
{
    ImGui::SetNextItemOpen(open);
    const bool now = ImGui::CollapsingHeader(name);
    note(name, now != open);
    open = now;
    return now;
}

bool Ui::button(const char *name, bool on_this_line)
{
    if (on_this_line) ImGui::SameLine();
    const bool used = ImGui::Button(name);
    return note(name, used);
}

bool Ui::toggle(const char *name, bool &value, bool on_this_line)
{
    if (on_this_line) ImGui::SameLine();
    const bool used = ImGui::Checkbox(name, &value);
    return note(name, used);
}

void Ui::rest_of_line(float width_em)
{
    ImGui::SameLine();
    next_width_em_ = width_em;
}

bool Ui::slider(const char *name, float &value, float low, float high, const char *format, bool logarithmic)
{
    const float label = ImGui::CalcTextSize(name).x + ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - label;
    ImGui::SetNextItemWidth(std::max(em_ * 3, next_width_em_ > 0 ? next_width_em_ * em_ : room));
    next_width_em_ = 0;
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const bool used = ImGui::SliderFloat(name, &value, low, high, format, flags);
    note(name, used);
    Box &box = drawn_.back().box;  // without the name: a place on it is a value
    box.x1 = std::max(box.x0, box.x1 - label);
    return used;
}

bool Ui::choice(const char *name, int &value, const std::vector<std::string> &items)
{
    bool used = false;
    ImGui::AlignTextToFramePadding();
    text(name);
    ImGui::PushID(name);
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    float at = ImGui::GetItemRectMax().x;
    for (size_t i = 0; i < items.size(); ++i) {
        const ImGuiStyle &style = ImGui::GetStyle();
        const float wide = ImGui::CalcTextSize(items[i].c_str()).x + 2 * style.FramePadding.x;
        if (at + style.ItemSpacing.x + wide <= right) ImGui::SameLine();
        const bool chosen = value == static_cast<int>(i);
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        const bool here = ImGui::Button(items[i].c_str());
        if (chosen) ImGui::PopStyleColor();
        mark(std::string(name) + ": " + items[i], here).chosen = chosen;
        at = ImGui::GetItemRectMax().x;
        if (!here) continue;
        value = static_cast<int>(i);
        used = true;
    }
    ImGui::PopID();
    return used;
}

bool Ui::text_field(const char *name, std::string &value)
{
    char letters[256] = {};
    value.copy(letters, sizeof letters - 1);
    const float label = ImGui::CalcTextSize(name).x + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::max(em_ * 3, ImGui::GetContentRegionAvail().x - label));
    const bool used = ImGui::InputText(name, letters, sizeof letters);
    note(name, used);
    if (used) value = letters;
    return used;
}

bool Ui::takes_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Ui::takes_keys() const { return ImGui::GetIO().WantTextInput; }

const Widget *Ui::find(const std::string &name) const
{
    for (const Widget &widget : widgets_)
        if (widget.name == name) return &widget;
    return nullptr;
}

}  // namespace view
