// A window by SDL2, and its events as input.
#include <chrono>

#include "samples/scenes/check.h"
#include "samples/scenes/gl.h"
#include "samples/view/input_queue.h"
#include "samples/view/sdl.h"
#include "samples/view/surface.h"

namespace view
{
namespace
{

double clock_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

int key_of(SDL_Keycode code)
{
    static const std::pair<SDL_Keycode, int> named[] = {
        {SDLK_LEFT, key::left}, {SDLK_RIGHT, key::right},    {SDLK_UP, key::up},
        {SDLK_DOWN, key::down}, {SDLK_PAGEUP, key::page_up}, {SDLK_PAGEDOWN, key::page_down},
        {SDLK_HOME, key::home}, {SDLK_END, key::end},        {SDLK_KP_ENTER, key::enter}};
    for (const auto &[sdl_code, ours] : named)
        if (code == sdl_code) return ours;
    if (code >= 'a' && code <= 'z') return code - 'a' + 'A';
    return code > 0 && code < 128 ? code : 0;
}

int button_of(Uint8 button)
{
    return button == SDL_BUTTON_LEFT     ? left_button
           : button == SDL_BUTTON_RIGHT  ? right_button
           : button == SDL_BUTTON_MIDDLE ? middle_button
                                         : -1;
}

class SdlWindow final : public Window
{
public:
    SdlWindow(const std::string &title, int width, int height)
    {
        const Sdl &s = sdl();
        s.SetMainReady();
        if (s.Init(SDL_INIT_VIDEO) != 0) refuse("no window could be opened");
        // Without a screen SDL draws into nothing.
        const char *driver = s.GetCurrentVideoDriver();
        const std::string screen = driver ? driver : "";
        if (screen.empty() || screen == "dummy" || screen == "offscreen") {
            s.Quit();
            throw scenes::Failure("no window could be opened, as there is no screen: --script needs none");
        }
        s.GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
        s.GL_SetAttribute(SDL_GL_STENCIL_SIZE, 8);
        s.GL_SetAttribute(SDL_GL_ALPHA_SIZE, 8);
        s.GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
        window_ = s.CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                 SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
        if (window_) context_ = s.GL_CreateContext(window_);
        if (!context_) {
            const std::string why = s.GetError();
            close();
            throw scenes::Failure("no window with OpenGL could be opened: " + why);
        }
        s.SetWindowMinimumSize(window_, 480, 320);
        s.GL_SetSwapInterval(1);
        s.StartTextInput();
        name_ = described();
        last_s_ = clock_s();
    }
    ~SdlWindow() override { close(); }

    GetProcAddress get_proc_address() const override
    {
        return [](void *, const char *name) {
            return reinterpret_cast<contexts::GlFunction>(sdl().GL_GetProcAddress(name));
        };
    }
    void *user() const override { return nullptr; }
    const std::string &name() const override { return name_; }
    void read(int below, int width, int height, std::vector<uint8_t> &out) override;
    void show() override { sdl().GL_SwapWindow(window_); }
    void renew() override
    {
        if (context_) sdl().GL_DeleteContext(context_);
        context_ = sdl().GL_CreateContext(window_);
        if (!context_) refuse("the OpenGL context is lost, and another could not be made");
    }
    bool next(Input &input) override;

private:
    [[noreturn]] static void refuse(const std::string &what) { throw scenes::Failure(what + ": " + sdl().GetError()); }
    void close()
    {
        if (context_) sdl().GL_DeleteContext(context_);
        if (window_) sdl().DestroyWindow(window_);
        sdl().Quit();
    }
    std::string described() const
    {
        const auto get = reinterpret_cast<const unsigned char *(*)(unsigned)>(sdl().GL_GetProcAddress("glGetString"));
        if (!get) throw scenes::Failure("this OpenGL context lacks glGetString");
        const auto *words = get(scenes::gl::version);
        return words ? "OpenGL " + std::string(reinterpret_cast<const char *>(words)) : "OpenGL";
    }
    void take(const SDL_Event &event);
    void take_key(const SDL_Event &event);

    SDL_Window *window_ = nullptr;
    SDL_GLContext context_ = nullptr;
    std::string name_;
    Input now_;
    bool closed_ = false;
    InputQueue queue_;
    double last_s_ = 0;
};

void SdlWindow::take(const SDL_Event &event)
{
    if (event.type == SDL_QUIT) closed_ = true;
    if (event.type == SDL_MOUSEMOTION) {
        int width = 1, height = 1;
        sdl().GetWindowSize(window_, &width, &height);
        queue_.push(
            {Event::Kind::move,
             static_cast<float>(event.motion.x) * static_cast<float>(now_.width) / static_cast<float>(width),
             static_cast<float>(event.motion.y) * static_cast<float>(now_.height) / static_cast<float>(height)});
    }
    if (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP) {
        const int button = button_of(event.button.button);
        if (button >= 0) queue_.push({Event::Kind::button, 0, 0, button, event.type == SDL_MOUSEBUTTONDOWN});
    }
    if (event.type == SDL_MOUSEWHEEL) queue_.push({Event::Kind::wheel, 0, static_cast<float>(event.wheel.y)});
    if (event.type == SDL_TEXTINPUT) queue_.push({Event::Kind::text, 0, 0, 0, false, event.text.text});
    if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) take_key(event);
    if (event.type == SDL_DROPFILE) {
        queue_.push({Event::Kind::drop, 0, 0, 0, false, event.drop.file});
        sdl().free(event.drop.file);
    }
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST)
        for (int code = 0; code < key::count; ++code)
            if (now_.keys[static_cast<size_t>(code)]) queue_.push({Event::Kind::key, 0, 0, code, false});
}

void SdlWindow::take_key(const SDL_Event &event)
{
    const int code = key_of(event.key.keysym.sym);
    if (event.key.repeat != 0) return;
    if (code == 'Q' && (event.key.keysym.mod & KMOD_CTRL) != 0) closed_ = true;
    queue_.push({Event::Kind::key, 0, 0, code, event.type == SDL_KEYDOWN});
}

bool SdlWindow::next(Input &input)
{
    const Sdl &s = sdl();
    s.GL_GetDrawableSize(window_, &now_.width, &now_.height);
    for (SDL_Event event; s.PollEvent(&event) != 0;) take(event);
    queue_.next(now_);
    const SDL_Keymod held = s.GetModState();
    now_.shift = (held & KMOD_SHIFT) != 0;
    now_.control = (held & KMOD_CTRL) != 0;
    const double t = clock_s();
    now_.elapsed_s = t - last_s_;
    last_s_ = t;
    input = now_;
    return !closed_;
}

void SdlWindow::read(int below, int width, int height, std::vector<uint8_t> &out)
{
    using Read = void (*)(int, int, int, int, unsigned, unsigned, void *);
    using Store = void (*)(unsigned, int);
    constexpr unsigned pack_alignment = 0xD05, rgb = 0x1907;
    const auto read_pixels = reinterpret_cast<Read>(sdl().GL_GetProcAddress("glReadPixels"));
    const auto pixel_store = reinterpret_cast<Store>(sdl().GL_GetProcAddress("glPixelStorei"));
    if (!read_pixels || !pixel_store) throw scenes::Failure("this OpenGL context lacks glReadPixels");
    const size_t row = 3 * static_cast<size_t>(width);
    std::vector<uint8_t> upwards(row * static_cast<size_t>(height));
    pixel_store(pack_alignment, 1);
    read_pixels(0, below, width, height, rgb, scenes::gl::unsigned_byte, upwards.data());
    out.clear();
    for (size_t y = static_cast<size_t>(height); y-- > 0;)
        out.insert(out.end(), upwards.begin() + static_cast<std::ptrdiff_t>(row * y),
                   upwards.begin() + static_cast<std::ptrdiff_t>(row * (y + 1)));
}

}  // namespace

std::unique_ptr<Window> open_window(const std::string &title, int width, int height)
{
    return std::make_unique<SdlWindow>(title, width, height);
}

}  // namespace view
