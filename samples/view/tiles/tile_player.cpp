#include "samples/view/tiles/tile_player.h"

#include <ctime>

#include "samples/processes/machine_share.h"
#include "samples/view/designer/files.h"
#include "samples/view/gl_calls.h"

namespace view::tiles
{
namespace
{

double cpu_ms()
{
    timespec now = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

processes::Reply TilePlayer::answer(const std::string &text)
{
    const Task task = task_of(text);
    if (!session_) load();
    if (task.kind == Task::Kind::renew) session_->renew();
    return text_of(task.kind == Task::Kind::frame ? draw(task) : Done());
}

void TilePlayer::load()
{
    processes::take_mesa_threads(request_.cores_each);
    surface_ = make_offscreen_surface(request_.context, canvas_.width, canvas_.height);
    session_.emplace(*surface_, request_.open, request_.switches, request_.scale, request_.now);
    begin(request_, *session_);
}

Done TilePlayer::draw(const Task &task)
{
    const double begun_ms = cpu_ms();
    Session &session = *session_;
    session.model().film = task.film;
    session.show_tile(task);
    session.frame(task.input);
    take_wishes();
    Done done;
    done.fingerprint = session.fingerprint();
    done.stats = session.model().cost.drawn;
    const World &world = session.world();
    const processes::Tile tile = scaled(task, world.width());
    done.drawn = world.width() <= canvas_.width && world.height() <= canvas_.height;
    if (done.drawn && tile.x1 > tile.x0)
        read_columns(tile, task.input.height - world.height(), world.height(), canvas_.rgb, canvas_.width);
    done.cpu_ms = cpu_ms() - begun_ms;
    return done;
}

// What the window's process saves; the model must follow all the same.
void TilePlayer::take_wishes()
{
    Session &session = *session_;
    Model &model = session.model();
    const auto save_text = [](const std::string &, const std::string &) {};
    const auto save_picture = [](const std::string &, const std::vector<uint8_t> &, int, int) {};
    keep_designs(model.designer, session.world().context(), request_.folder, save_text, model.message);
    keep_zones(model.designer, request_.folder, save_picture, save_text, model.message);
    model.wishes.picture = model.wishes.save_path = model.ground.save_scenario = false;
}

}  // namespace view::tiles
