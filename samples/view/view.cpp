#include "samples/view/view.h"

#include <chrono>

#include "samples/view/loading.h"
#include "samples/view/rates.h"
#include "samples/view/saved.h"
#include "samples/view/script.h"
#include "samples/view/serve/window.h"
#include "samples/view/session.h"

namespace view
{
namespace
{

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Everything that a request asks of a new session.
void begin(const Request &request, Session &session)
{
    session.on_drop(request.drop);
    if (request.colours.empty()) return;
    session.put_on(request.colours);
    session.model().designer.history = {};
}

void run_script(const Request &request)
{
    Script script = read_script(request.script, request.script_file);
    const Now now = script.measured ? steady_s : nullptr;
    if (!request.rates.empty() && !now)
        throw scenes::Failure(request.script_file + " has no `measured = true`, which --rates needs");
    const size_t steps = script.steps.size();
    Player player(std::move(script), request.width, request.height);
    const auto surface = make_offscreen_surface(request.context, request.width, request.height);
    Session session(*surface, request.open, request.switches, request.scale, now);
    begin(request, session);
    Saved saved(request);
    Input input;
    uint64_t frames = 0;
    Rates rates;
    while (player.next(input, session.ui(), session.world())) {
        const double start = steady_s();
        session.frame(input);
        rates.add(steady_s() - start, session.model());
        saved.wishes(*surface, input, session.world(), session.model());
        if (!player.shot().empty()) saved.picture(*surface, 0, input.width, input.height, player.shot());
        ++frames;
    }
    saved.end_film();
    if (!request.rates.empty()) request.save_text(request.rates, rates.json(surface->name()));
    request.conclude(std::to_string(steps) + " steps, " + std::to_string(frames) + " frames, " +
                     std::to_string(saved.pictures()) + " pictures, " + surface->name());
}

std::unique_ptr<Window> window_of(const Request &request)
{
    if (!request.serve) return open_window(request.title, request.width, request.height);
    return serve::open_window(*request.serve, request.title, request.context, request.width, request.height,
                              request.say);
}

void run_window(const Request &request)
{
    auto window = window_of(request);
    const double start = steady_s();
    std::optional<Loaded> loaded = load_in(*window, request);
    if (!loaded) return;
    const double ready = steady_s();
    Session session(*window, request.open, std::move(*loaded), request.switches, request.scale, steady_s);
    begin(request, session);
    Saved saved(request);
    Input input;
    uint64_t frames = 0;
    double first = ready;
    while (window->next(input)) {
        if (input.width < 1 || input.height < 1) continue;
        session.frame(input);
        saved.wishes(*window, input, session.world(), session.model());
        window->show();
        if (frames == 0) first = steady_s();
        ++frames;
    }
    saved.end_film();
    request.conclude("loaded in " + fixed(ready - start, 1) + " s, first picture " + fixed((first - ready) * 1000, 0) +
                     " ms later; " + std::to_string(frames) + " frames, " +
                     fixed(static_cast<double>(frames) / std::max(1e-3, steady_s() - first), 1) + " a second, " +
                     window->name());
}

}  // namespace

void run(const Request &request)
{
    request.progress("preparing");
    if (request.script_file.empty()) run_window(request);
    else run_script(request);
}

}  // namespace view
