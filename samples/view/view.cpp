#include "samples/view/view.h"

#include <chrono>

#include "samples/view/designer/files.h"
#include "samples/view/script.h"
#include "samples/view/session.h"

namespace view
{
namespace
{

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// What the person asked to be saved, under the first number that this run has not used.
class Saved
{
public:
    explicit Saved(const Request &request) : request_(request) {}

    void picture(Surface &surface, int below, int width, int height, const std::string &name)
    {
        surface.read(below, width, height, rgb_);
        request_.save_picture(request_.folder + "/" + name, rgb_, width, height);
        ++pictures_;
    }
    void wishes(Surface &surface, const Input &input, const World &world, Model &model)
    {
        keep_designs(model.designer, world.context(), request_.folder, request_.save_text, model.message);
        try {
            if (model.wishes.picture) {
                const std::string name = named(model) + ".png";
                picture(surface, input.height - world.height(), world.width(), world.height(), name);
                model.message = name + " is saved";
            }
            if (model.wishes.save_path) {
                const std::string name = named(model) + ".toml";
                request_.save_text(request_.folder + "/" + name, path_text(model.view));
                model.message = name + " is saved";
            }
        } catch (const scenes::Failure &failure) {
            model.message = failure.what();
        }
        model.wishes.picture = model.wishes.save_path = false;
    }
    int pictures() const { return pictures_; }

private:
    std::string named(const Model &model)
    {
        if (model.saved_as.empty() || model.saved_as.find('/') != std::string::npos)
            throw scenes::Failure("'" + model.saved_as + "' is no name for a file: it needs letters, and no slash");
        return model.saved_as + "-" + std::to_string(++number_);
    }

    const Request &request_;
    std::vector<uint8_t> rgb_;
    int number_ = 0, pictures_ = 0;
};

// The people wear a map's colours from the first frame on.
void put_on(const Request &request, Session &session)
{
    if (request.colours.empty()) return;
    Designer &designer = session.model().designer;
    load_design(designer, session.world().context(), request.colours);
    designer.history = {};
    designer.file = request.colours;
    session.model().open.designer = true;
}

void run_script(const Request &request)
{
    Script script = read_script(request.script, request.script_file);
    const Now now = script.measured ? steady_s : nullptr;
    const size_t steps = script.steps.size();
    Player player(std::move(script), request.width, request.height);
    const auto surface = make_offscreen_surface(request.context, request.width, request.height);
    Session session(*surface, request.open, request.switches, request.scale, now);
    put_on(request, session);
    Saved saved(request);
    Input input;
    uint64_t frames = 0;
    while (player.next(input, session.ui(), session.world())) {
        session.frame(input);
        saved.wishes(*surface, input, session.world(), session.model());
        if (!player.shot().empty()) saved.picture(*surface, 0, input.width, input.height, player.shot());
        ++frames;
    }
    request.conclude(std::to_string(steps) + " steps, " + std::to_string(frames) + " frames, " +
                     std::to_string(saved.pictures()) + " pictures, " + surface->name());
}

void run_window(const Request &request)
{
    const auto window = open_window(request.title, request.width, request.height);
    Session session(*window, request.open, request.switches, request.scale, steady_s);
    put_on(request, session);
    Saved saved(request);
    Input input;
    uint64_t frames = 0;
    const double start = steady_s();
    while (window->next(input)) {
        if (input.width < 1 || input.height < 1) continue;
        session.frame(input);
        saved.wishes(*window, input, session.world(), session.model());
        window->show();
        ++frames;
    }
    request.conclude(std::to_string(frames) + " frames, " +
                     fixed(static_cast<double>(frames) / std::max(1e-3, steady_s() - start), 1) + " a second, " +
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
