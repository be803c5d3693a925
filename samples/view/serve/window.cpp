#include "samples/view/serve/window.h"

#include <chrono>
#include <thread>

#include "samples/view/serve/server.h"

namespace view::serve
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr double watched_s = 1.0 / 30, unwatched_s = 0.2;  // from one frame to the next

class ServedWindow final : public Window
{
public:
    ServedWindow(const Options &options, const std::string &title, contexts::Kind context, int width, int height)
        : surface_(make_offscreen_surface(context, width, height)),
          server_(options, title, width, height, queue_),
          name_(surface_->name() + ", served"),
          last_(Clock::now())
    {
        input_.width = width, input_.height = height;
    }

    GetProcAddress get_proc_address() const override { return surface_->get_proc_address(); }
    void *user() const override { return surface_->user(); }
    const std::string &name() const override { return name_; }
    void read(int below, int width, int height, std::vector<uint8_t> &out) override
    {
        surface_->read(below, width, height, out);
    }
    void renew() override { surface_->renew(); }
    bool next(Input &input) override
    {
        const double pace_s = server_.watching() > 0 ? watched_s : unwatched_s;
        const Clock::time_point due =
            last_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pace_s));
        std::this_thread::sleep_until(due);
        const Clock::time_point now = Clock::now();
        input_.elapsed_s = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        queue_.next(input_);
        input = input_;
        return true;
    }
    void show() override
    {
        std::vector<uint8_t> rgb;
        surface_->read(0, input_.width, input_.height, rgb);
        server_.show(std::move(rgb));
    }
    const Server &server() const { return server_; }

private:
    std::unique_ptr<Surface> surface_;
    InputQueue queue_;
    Server server_;
    std::string name_;
    Input input_;
    Clock::time_point last_;
};

}  // namespace

std::unique_ptr<Window> open_window(const Options &options, const std::string &title, contexts::Kind context, int width,
                                    int height, const std::function<void(const std::string &)> &say)
{
    auto window = std::make_unique<ServedWindow>(options, title, context, width, height);
    const int port = window->server().port();
    const std::string number = std::to_string(port);
    say("the window is at " + place_text(options.address, port) + ", its password is " +
        (options.password.empty() ? window->server().password() : "that of the file"));
    if (is_loopback(options.address))
        say("from another machine: ssh -L " + number + ":" + place_text(options.address, port) +
            " THIS_MACHINE, and there a VNC viewer at 127.0.0.1:" + number);
    else say("others can reach it, and VNC does not encrypt: 127.0.0.1 with ssh -L does");
    say("ctrl+C ends it");
    return window;
}

}  // namespace view::serve
