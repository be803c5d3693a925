#include "samples/view/session.h"

#include <algorithm>

#include "samples/scenes/odeon/toml_table.h"
#include "samples/view/designer/files.h"
#include "samples/view/gl_calls.h"

namespace view
{
namespace
{

const Switches &with_gl(Surface &surface, const Switches &switches)
{
    std::string missing;
    if (!load_gl_calls(surface.get_proc_address(), surface.user(), missing))
        throw scenes::Failure("this OpenGL context lacks " + missing);
    return switches;
}

// Frames and switches of the last ten seconds.
void remember(Model &model)
{
    model.cost.at_s = model.real_s;
    model.history.push_back(model.cost);
    const double first_s = model.real_s - history_s;
    while (model.history.front().at_s < first_s) model.history.pop_front();
    while (!model.switched.empty() && model.switched.front().at_s < first_s) model.switched.pop_front();
}

std::string list_of(const Point &p)
{
    return "[" + fixed(p[0], 4) + ", " + fixed(p[1], 4) + ", " + fixed(p[2], 4) + "]";
}

}  // namespace

Session::Session(Surface &surface, Open open, const Switches &switches, float scale, Now now)
    : Session(surface, open, load(open, switches), switches, scale, now)
{
}

Session::Session(Surface &surface, Open open, Loaded loaded, const Switches &switches, float scale, Now now)
    : surface_(surface),
      now_(now),
      world_(surface, std::move(open), std::move(loaded), with_gl(surface, switches), now),
      ui_(scale)
{
    model_.switches = switches;
    take_times();
}

void Session::renew()
{
    ui_.forget_context();
    if (painter_) painter_->renew();
    world_.renew();
    with_gl(surface_, model_.switches);
    model_.ground.roles.clear();
    model_.message = "the OpenGL context was lost, and is made anew";
}

void Session::take_times()
{
    model_.clock.first_s = model_.clock.time_s = world_.first_s();
    model_.clock.last_s = world_.last_s();
    if (world_.begins_on_path()) model_.view.shot = 2;
}

void Session::put_on(const std::string &colours)
{
    Designer &designer = model_.designer;
    load_design(designer, world_.context(), colours);
    designer.file = colours;
    model_.open.designer = true;
}

void Session::take_drop(const std::string &path)
{
    const std::string name = path.substr(path.rfind('/') + 1);
    if (!drop_) return;
    try {
        const Dropped dropped = drop_(path);
        if (!dropped.colours.empty()) {
            put_on(dropped.colours);
            model_.message = name + " is worn";
            return;
        }
        world_.open(dropped.open);
    } catch (const scenes::Failure &failure) {
        model_.message = failure.what();
        return;
    }
    model_.picked = {};
    model_.ground.roles.clear();
    model_.view.mode = CameraMode::scene;
    model_.view.shot = 0;
    take_times();
    model_.message = name + " is shown";
}

void Session::frame(const Input &input)
{
    Clock &clock = model_.clock;
    if (painter_) painter_->begin(input, model_);
    if (!input.dropped.empty()) take_drop(input.dropped);
    model_.real_s += input.elapsed_s;
    if (!clock.paused) clock.time_s += input.elapsed_s * static_cast<double>(clock.speed);
    const double start = now_ ? now_() : 0;
    ui_.begin(input);
    panels(ui_, model_, world_, input);
    // The rest of the window is the picture.
    const Layout layout = layout_of(ui_, model_, input.width, input.height);
    Input on_picture = input;
    on_picture.width = layout.picture_width, on_picture.height = layout.picture_height;
    hands_.act(model_, on_picture, !ui_.takes_mouse(), !ui_.takes_keys());
    Designer &designer = model_.designer;
    if (designer.wishes.undo) undo(designer);
    if (designer.wishes.redo) redo(designer);
    designer.wishes.undo = designer.wishes.redo = false;
    designer.brush.held = designer.brush.held && ui_.holds();
    const double middle = now_ ? now_() : 0;
    if (tile_) world_.show_columns(tiles::scaled(*tile_, on_picture.width));
    world_.update(model_, on_picture.width, on_picture.height, input.height - on_picture.height);
    const double updated = now_ ? now_() : 0;
    marks(ui_, model_, world_);
    ui_.close();
    const double closed = now_ ? now_() : 0;
    if (painter_) painter_->paint(world_, model_, fingerprint());
    else world_.draw(model_);
    remember(model_);
    if (world_.context_lost()) return renew();
    const double drawn = now_ ? now_() : 0;
    if (!tile_) ui_.draw();
    if (!now_) return;
    world_.finish();
    model_.cost.interface_ms = (closed - updated + middle - start) * 1000;
    model_.cost.interface_gl_ms = model_.cost.crowd_ms < 0 ? -1 : (now_() - drawn) * 1000;
}

uint64_t Session::fingerprint() const
{
    std::vector<uint8_t> all;
    const auto add = [&all](const auto &value) {
        const auto *bytes = reinterpret_cast<const uint8_t *>(&value);
        all.insert(all.end(), bytes, bytes + sizeof value);
    };
    for (const Widget &one : ui_.widgets()) {
        all.insert(all.end(), one.name.begin(), one.name.end());
        for (const float side : {one.box.x0, one.box.y0, one.box.x1, one.box.y1}) add(side);
    }
    const clq_camera &camera = world_.camera();
    add(camera.eye), add(camera.rotation_xyzw), add(camera.projection);
    for (const int size : {world_.width(), world_.height()}) add(size);
    add(model_.clock.time_s), add(model_.picked.actor.index1), add(model_.picked.zone);
    return scenes::hash_of(all);
}

std::string path_text(const View &view)
{
    std::string text = "far_m = 6000.0\n";
    for (const View::Key &key : view.path) {
        text += "\n[[keys]]\ntime_s = " + fixed(std::max(0.0, key.time_s), 4) + "\neye = " + list_of(key.camera.eye()) +
                "\ntarget = " + list_of(key.camera.target) +
                "\nfov_deg = " + fixed(std::clamp(key.camera.fov_rad * 57.29577951308232, 5.0, 120.0), 3) +
                "\nnear_m = " + fixed(std::clamp(key.camera.distance_m * 0.02, 0.02, 2.0), 3) + "\n";
    }
    return text;
}

}  // namespace view
