#include "samples/view/loading.h"

#include <future>
#include <thread>

#include "samples/view/gl_calls.h"
#include "samples/view/panels.h"

namespace view
{
namespace
{

using namespace std::chrono_literals;

void show_loading(Ui &ui, const scenes::Gl &gl, const Input &input, const std::string &words)
{
    const auto width = static_cast<float>(input.width), height = static_cast<float>(input.height);
    gl.Viewport(0, 0, input.width, input.height);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
    ui.begin(input);
    ui.begin_panel("loading", {0, std::max(0.0f, height - 3 * ui.em()), width, height});
    ui.text(words);
    ui.end_panel();
    ui.end();
}

}  // namespace

std::optional<Loaded> load_in(Window &window, const Request &request)
{
    std::string missing;
    scenes::Gl gl;
    if (!load_gl_calls(window.get_proc_address(), window.user(), missing) ||
        !scenes::load(gl, window.get_proc_address(), window.user(), missing))
        throw scenes::Failure("this OpenGL context lacks " + missing);
    // At its end it waits for the thread, also where the window was closed.
    std::future<Loaded> loading =
        std::async(std::launch::async, [&request] { return load(request.open, request.switches); });
    Ui ui(request.scale);
    Input input;
    double waited_s = 0;
    while (loading.wait_for(20ms) != std::future_status::ready) {
        if (!window.next(input)) return std::nullopt;
        waited_s += input.elapsed_s;
        if (input.width < 1 || input.height < 1) continue;
        const std::string words = "loading " + request.title + ", " + fixed(waited_s, 0) + " s";
        request.progress(words);
        show_loading(ui, gl, input, words);
        window.show();
    }
    return loading.get();
}

}  // namespace view
