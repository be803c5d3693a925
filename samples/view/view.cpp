#include "samples/view/view.h"

#include <chrono>

#include "samples/view/loading.h"
#include "samples/view/rates.h"
#include "samples/view/saved.h"
#include "samples/view/script.h"
#include "samples/view/serve/window.h"
#include "samples/view/session.h"
#include "samples/view/tiles/tile_crew.h"

namespace view
{
namespace
{

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// What drew the picture besides this process.
std::string help_of(const Request &request, const std::unique_ptr<tiles::TileCrew> &crew)
{
    if (!crew) return "";
    std::string words = ", by " + std::to_string(request.processes) + " processes";
    if (crew->lost() > 0) words += ", of which " + std::to_string(crew->lost()) + " ended";
    return words;
}

void run_script(const Request &request, Script script, const std::unique_ptr<tiles::TileCrew> &crew)
{
    if (!request.rates.empty() && !request.now)
        throw scenes::Failure(request.script_file + " has no `measured = true`, which --rates needs");
    const size_t steps = script.steps.size();
    Player player(std::move(script), request.width, request.height);
    const auto surface = make_offscreen_surface(request.context, request.width, request.height);
    Session session(*surface, request.open, request.switches, request.scale, request.now);
    session.paint_by(crew.get());
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
    if (!request.rates.empty())
        request.save_text(request.rates, rates.json(surface->name(), request.processes, crew ? crew->lost() : 0));
    request.conclude(std::to_string(steps) + " steps, " + std::to_string(frames) + " frames, " +
                     std::to_string(saved.pictures()) + " pictures, " + surface->name() + help_of(request, crew));
}

std::unique_ptr<Window> window_of(const Request &request)
{
    if (!request.serve) return open_window(request.title, request.width, request.height);
    return serve::open_window(*request.serve, request.title, request.context, request.width, request.height,
                              request.say);
}

void run_window(const Request &request, const std::unique_ptr<tiles::TileCrew> &crew)
{
    auto window = window_of(request);
    const double start = steady_s();
    std::optional<Loaded> loaded = load_in(*window, request);
    if (!loaded) return;
    const double ready = steady_s();
    Session session(*window, request.open, std::move(*loaded), request.switches, request.scale, request.now);
    session.paint_by(crew.get());
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
                     window->name() + help_of(request, crew));
}

}  // namespace

void begin(const Request &request, Session &session)
{
    session.on_drop(request.drop);
    session.model().ground.mechanisms = request.mechanisms;
    if (request.colours.empty()) return;
    session.put_on(request.colours);
    session.model().designer.history = {};
}

void run(const Request &asked)
{
    asked.progress("preparing");
    Request request = asked;
    std::optional<Script> script;
    if (!request.script_file.empty()) script = read_script(request.script, request.script_file);
    if (!script || script->measured) request.now = steady_s;
    // Before this process has threads and a context.
    std::unique_ptr<tiles::TileCrew> crew;
    if (request.processes > 1) crew = std::make_unique<tiles::TileCrew>(request);
    if (script) run_script(request, std::move(*script), crew);
    else run_window(request, crew);
}

}  // namespace view
