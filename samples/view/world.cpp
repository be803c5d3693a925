#include "samples/view/world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace view
{
namespace
{

constexpr float third = 3;

scenes::CrowdOptions with(scenes::CrowdOptions options, const Switches &switches)
{
    if (switches.cache == 3) {
        options.key_poses.band_count = 1;
        options.key_poses.bands[0] = {0, CLQ_KEY_POSE_INTERPOLATED};
    } else options.cache = static_cast<clq_cache_mode>(switches.cache);
    options.cull = static_cast<clq_cull_mode>(switches.cull);
    options.vertex_format = static_cast<clq_vertex_format>(switches.format);
    options.lod = switches.levels > 0 ? scenes::Lod::on : scenes::Lod::off;
    if (switches.levels == 2) options.lod_scale *= third;
    return options;
}

bool makes_anew(const Switches &a, const Switches &b)
{
    return a.cache != b.cache || a.cull != b.cull || a.format != b.format || a.levels != b.levels ||
           a.threads != b.threads;
}

}  // namespace

Loaded load(const Open &open, const Switches &switches, uint32_t people, const std::vector<SharedMap> &maps)
{
    Loaded loaded;
    loaded.library = std::make_unique<scenes::Library>(switches.threads);
    loaded.opened = open(*loaded.library);
    const scenes::SceneOptions &options = loaded.opened.options;
    scenes::CrowdOptions crowd_options = with(options.crowd_options, switches);
    if (people > 0) crowd_options.count = people;
    loaded.painted = paint_templates(*loaded.library, loaded.opened, crowd_options.lod, maps);
    loaded.scene = options.make ? options.make(*loaded.library, crowd_options)
                                : scenes::make_scene(options.scene, *loaded.library, crowd_options, options.character);
    if (loaded.opened.dress) loaded.opened.dress(*loaded.library, *loaded.scene);
    return loaded;
}

World::World(Surface &surface, Open open, Loaded loaded, const Switches &switches, Now now)
    : surface_(surface), open_(std::move(open)), now_(now)
{
    std::string missing;
    if (!scenes::load(gl_, surface.get_proc_address(), surface.user(), missing))
        throw scenes::Failure("this OpenGL context lacks " + missing);
    show(std::move(loaded), switches);
}

World::~World() { unmake(); }

void World::unmake()
{
    for (auto &renderer : renderers_) renderer.reset();
    renderer_ = nullptr;
    dresser_.forget();
    ticks_.clear();
    level_row_.reset();
    findings_.clear();
    index_ = nullptr;  // ends with its crowd
    view_.reset();
    tile_view_.reset();
    scene_.reset();
    workbench_.reset();
    path_.reset();
    opened_ = {};
    painted_ = {};
    library_.reset();
}

void World::make(const Switches &switches)
{
    unmake();
    show(load(open_, switches, people_, maps_), switches);
}

void World::open(const Open &open)
{
    const Open before = std::exchange(open_, open);
    try {
        make(made_);
    } catch (const scenes::Failure &) {
        open_ = before;
        make(made_);
        throw;
    }
}

void World::renew()
{
    unmake();
    surface_.renew();
    std::string missing;
    if (!scenes::load(gl_, surface_.get_proc_address(), surface_.user(), missing))
        throw scenes::Failure("this OpenGL context lacks " + missing);
    context_lost_ = false;
    make(made_);
}

void World::show(Loaded loaded, const Switches &switches)
{
    library_ = std::move(loaded.library);
    opened_ = std::move(loaded.opened);
    painted_ = std::move(loaded.painted);
    scene_ = std::move(loaded.scene);
    get_error_ = reinterpret_cast<unsigned (*)()>(surface_.get_proc_address()(surface_.user(), "glGetError"));
    scene_->prepare(gl_);
    templates_ = scene_->templates();
    path_ = opened_.options.path;
    clq_view *view = nullptr;
    scenes::check(clq_view_create(scene_->crowd(), &view));
    view_.reset(view);
    scenes::check(clq_scene_create(scene_->crowd(), &index_));
    if (now_)
        scenes::check(clq_crowd_set_step_clock(
            scene_->crowd(), [](void *now) { return (*static_cast<Now *>(now))(); }, &now_));
    workbench_ = std::make_unique<Workbench>(*library_, scene_->crowd(), templates_);
    made_ = switches;
    use_renderer(switches);
}

void World::use_renderer(const Switches &switches)
{
    constexpr uint64_t own_texture_bytes = uint64_t(256) << 20;
    constexpr uint32_t made_a_frame = 4;  // 512 x 512 texels take some milliseconds each
    scenes::Own<clq_renderer> &renderer =
        renderers_.at(static_cast<size_t>(switches.strategy + 3 * switches.close_textures));
    if (!renderer) {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = surface_.get_proc_address();
        def.user = surface_.user();
        def.strategy = static_cast<clq_draw_strategy>(switches.strategy);
        def.flush_triangles = surface_.flushes_cheaply() ? 16384 : 0;
        if (switches.close_textures == 1)
            def.close_texture_bytes = own_texture_bytes, def.close_textures_per_draw = made_a_frame;
        clq_renderer *made = nullptr;
        scenes::check(clq_renderer_create(library_->context(), &def, &made));
        renderer.reset(made);
        for (clq_template *tmpl : templates_) scenes::check(clq_renderer_prepare(made, tmpl));
    }
    renderer_ = renderer.get();
    level_row_.reset();  // its template is prepared for the renderers that there are
    made_.strategy = switches.strategy, made_.close_textures = switches.close_textures;
}

void World::follow(Model &model)
{
    const bool other_number = model.designer.people != people_ && !count_people(model.designer.people);
    if (model.designer.wishes.propose) propose(model);
    const bool other_zones = !model.designer.brush.held && model.designer.design.maps != maps_;
    if (other_zones) maps_ = model.designer.design.maps;
    const bool anew = other_zones || other_number || model.wishes.anew || makes_anew(model.switches, made_);
    if (anew) {
        make(model.switches);
        model.ground.roles.clear();
        model.designer.paint_failure = painted_.failure;
    }
    if (model.switches.strategy != made_.strategy || model.switches.close_textures != made_.close_textures)
        use_renderer(model.switches);
    clq_actor_info info = clq_actor_info_init();
    if (model.picked.actor.index1 != 0 && !find(model.picked.actor, info)) {
        model.picked = {};
        if (model.view.mode == CameraMode::follow) model.view.mode = CameraMode::free;
    }
    const bool picture = model.wishes.picture, path = model.wishes.save_path;
    const bool framing = model.wishes.frame_selection;
    const auto pick = model.wishes.pick;
    model.wishes = {};
    model.wishes.picture = picture, model.wishes.save_path = path;  // for the program, after the frame
    model.wishes.frame_selection = framing, model.wishes.pick = pick;
}

void World::place_camera(Model &model, double aspect)
{
    View &view = model.view;
    clq_actor_info info = clq_actor_info_init();
    const bool there = model.picked.actor.index1 != 0 && find(model.picked.actor, info);
    Point at = {};
    double radius = 1;
    if (there) {
        clq_scene_actor seen = clq_scene_actor_init();
        scenes::check(clq_scene_get_actor(index_, model.picked.actor, model.clock.time_s, &seen));
        for (size_t k = 0; k < 3; ++k) at[k] = seen.centre[k];
        radius = seen.radius;
        if (!seen.present && view.mode == CameraMode::follow) view.mode = CameraMode::free;
    } else if (view.mode == CameraMode::follow) view.mode = CameraMode::free;
    if (model.wishes.frame_selection && there) {
        if (view.mode == CameraMode::scene) view.mode = CameraMode::free;
        Point centre = at;
        double tight = radius;
        const bool seen = body(model.picked.actor, centre, tight);
        view.free.frame(seen ? centre : at, seen ? tight : radius);
    }
    model.wishes.frame_selection = false;
    if (view.mode == CameraMode::follow) view.free.target = at;
    if (view.mode != CameraMode::scene) {
        camera_ = view.free.camera(aspect);
        return;
    }
    const auto shot = static_cast<scenes::Shot>(view.shot);
    camera_ = shot == scenes::Shot::path && path_ ? path_->camera(model.clock.time_s, aspect)
                                                  : scene_->camera(shot, aspect, model.clock.time_s);
    // The free camera starts where the scene's is.
    view.free = free_camera_from(camera_, depth_of_ground(camera_, 15));
}

void World::update(Model &model, int width, int height, int below)
{
    width_ = std::max(1, width), height_ = std::max(1, height), below_ = below;
    follow(model);
    time_s_ = model.clock.time_s;
    const auto pick_at = model.wishes.pick;
    model.wishes.pick.reset();
    FrameCost &cost = model.cost;
    double start = now_s();
    scene_->place(time_s_);
    workbench_->touch(model, camera_);
    workbench_->act(model);
    Workbench::watch(model, *scene_);
    cost.place_ms = ms_since(start);
    place_camera(model, static_cast<double>(width_) / height_);
    eye_ = scenes::eye_of(camera_);
    tint(model);
    dress(model);
    scenes::check(clq_view_set_height(view_.get(), static_cast<float>(height_)));
    scenes::check(clq_view_set_camera(view_.get(), &camera_));
    clq_view *views[] = {view_.get(), nullptr};
    if (shows_part()) views[1] = view_of_columns();
    start = now_s();
    scenes::check(clq_crowd_update(scene_->crowd(), time_s_, views, views[1] ? 2 : 1));
    cost.update_ms = ms_since(start);
    show_levels(model);
    if (pick_at) {
        model.picked = pick((*pick_at)[0], (*pick_at)[1]);
        ++model.picks;
    }
    cost.crowd = clq_crowd_stats_init();
    scenes::check(clq_crowd_get_stats(scene_->crowd(), &cost.crowd));
    cost.seen = clq_view_stats_init();
    scenes::check(clq_view_get_stats(view_.get(), &cost.seen));
    cost.steps = clq_update_times_init();
    scenes::check(clq_crowd_get_update_times(scene_->crowd(), &cost.steps));
}

}  // namespace view
