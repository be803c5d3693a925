#include "samples/scenes/scene_renderer.h"

#include "samples/scenes/quiet_gl.h"

namespace scenes
{
namespace
{

// Triangles of people between two flushes: about as many as GL paints while as many are prepared.
constexpr uint32_t often = 16384;

}  // namespace

SceneRenderer::SceneRenderer(Library &library, const SceneOptions &options) : library_(library), options_(options)
{
    if (options_.shot == Shot::path && !options_.path)
        throw Failure("the scene '" + options_.scene + "' has no camera path, which was requested");
    std::string why_not;
    offscreen_ = contexts::make_offscreen(options.context, options.width, options.height, options.format, why_not,
                                          options.multisample);
    if (!offscreen_) throw Failure("no OpenGL context: " + why_not);
    if (!options_.flush_triangles) options_.flush_triangles = offscreen_->flushes_cheaply() ? often : 0;
    if (!load(gl_, offscreen_->get_proc_address(), offscreen_->user(), why_not))
        throw Failure("this OpenGL context lacks " + why_not);
    scene_ = options.make ? options.make(library, options.crowd_options)
                          : make_scene(options.scene, library, options.crowd_options, options.character);
    if (!options_.viewpoint.empty()) expect_viewpoint();
    scene_->prepare(gl_);
    clq_view *view = nullptr;
    check(clq_view_create(scene_->crowd(), &view));
    view_.reset(view);
    check(clq_view_set_height(view, static_cast<float>(options.height)));
    check(clq_view_set_cull_scale(view, options.cull_scale));
    if (options.cull_scale < 1) scene_->cull_by(static_cast<double>(options.cull_scale));
    if (options.shadows.form != ShadowChoice::Form::painted) take_shadows();
    use_strategy(options.strategy);
    x1_ = options_.width;
}

void SceneRenderer::show_tile(int x0, int x1)
{
    x0_ = x0, x1_ = x1;
    if (!scene_->can_cull_by_tile() || options_.show == Show::spheres) return;
    const float width = static_cast<float>(options_.width);
    const float tile[4] = {static_cast<float>(x0) / width, 0, static_cast<float>(x1) / width, 1};
    check(clq_view_set_tile(view_.get(), tile));
}

void SceneRenderer::expect_viewpoint() const
{
    std::string names;
    for (const std::string &name : scene_->viewpoints()) {
        if (name == options_.viewpoint) return;
        names += ", " + name;
    }
    throw Failure("the scene '" + options_.scene + "' has no camera '" + options_.viewpoint +
                  "'; there are: overview, close" + names);
}

void SceneRenderer::take_shadows()
{
    if (!scene_->take_shadows(shadows_))
        throw Failure("the scene '" + options_.scene + "' has no ground that shadows could fall on");
    shadows_.stencil_bit = options_.shadows.stencil ? 0 : -1;
    shadows_.blob_distance_m = options_.shadows.form == ShadowChoice::Form::blob ? 0.0f : options_.shadows.blob_from_m;
    if (options_.shadows.form == ShadowChoice::Form::none) return;
    // Extended by the length of a person's shadow: people out of view may throw one into it.
    constexpr double tall_m = 2.2;
    float fall[3];
    for (int k = 0; k < 3; ++k) fall[k] = static_cast<float>(-shadows_.light[k] / shadows_.light[1] * tall_m);
    check(clq_view_set_shadow(view_.get(), fall));
}

SceneRenderer::~SceneRenderer()
{
    // Textures are freed with their owner, which needs their context current.
    if (offscreen_) offscreen_->make_current();
}

void SceneRenderer::make_current()
{
    if (!offscreen_->make_current()) throw Failure("the OpenGL context could not be made current");
}

void SceneRenderer::use_strategy(clq_draw_strategy strategy)
{
    Own<clq_renderer> &renderer = renderers_.at(static_cast<size_t>(strategy));
    if (!renderer) {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = offscreen_->get_proc_address();
        def.user = offscreen_->user();
        if (options_.tells_parts) def.get_proc_address = quiet_proc_address, def.user = offscreen_.get();
        def.strategy = strategy;
        def.linear_clean = options_.linear_clean, def.smooth_levels = options_.smooth_levels;
        def.multisample = options_.multisample > 1;
        def.close_texture_bytes = options_.close_texture_bytes;
        def.close_distance_m = options_.close_distance_m;
        def.flush_triangles = *options_.flush_triangles;
        def.flat_triangles = options_.flat_triangles;
        clq_renderer *made = nullptr;
        check(clq_renderer_create(library_.context(), &def, &made));
        renderer.reset(made);
        for (clq_template *tmpl : scene_->templates()) check(clq_renderer_prepare(made, tmpl));
    }
    renderer_ = renderer.get();
}

clq_prepared_info SceneRenderer::prepared(const clq_template *tmpl) const
{
    clq_prepared_info info = clq_prepared_info_init();
    check(clq_renderer_get_prepared(renderer_, tmpl, &info));
    return info;
}

clq_camera SceneRenderer::camera_at(double time_s) const
{
    if (standing_) return *standing_;
    const double aspect = static_cast<double>(options_.width) / options_.height;
    if (!options_.viewpoint.empty()) return scene_->camera_from(options_.viewpoint, aspect, time_s);
    return options_.shot == Shot::path ? options_.path->camera(time_s, aspect)
                                       : scene_->camera(options_.shot, aspect, time_s);
}

void SceneRenderer::update(double time_s)
{
    const double crowd_s = held_s_.value_or(time_s);
    scene_->place(crowd_s);
    clq_camera camera = camera_at(time_s);
    // Divided by the distance in front of the eye, which is -z.
    camera.projection[8] -= static_cast<float>(2 * moved_px_[0] / options_.width);
    camera.projection[9] -= static_cast<float>(2 * moved_px_[1] / options_.height);
    eye_ = eye_of(camera);
    check(clq_view_set_camera(view_.get(), &camera));
    clq_view *views[] = {view_.get()};
    check(clq_crowd_update(scene_->crowd(), crowd_s, views, 1));
    if (options_.show != Show::levels) return;
    tint_by_level(scene_->crowd(), scene_->actors());
    check(clq_crowd_update(scene_->crowd(), crowd_s, views, 1));
}

void SceneRenderer::begin_picture()
{
    gl_.Viewport(0, 0, options_.width, options_.height);
    gl_.DepthMask(1);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Disable(gl::scissor_test);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    if (x0_ > 0 || x1_ < options_.width) {
        gl_.Enable(gl::scissor_test);
        gl_.Scissor(x0_, 0, x1_ - x0_, options_.height);
    }
    scene_->set_light(gl_, eye_);
}

bool SceneRenderer::has_claques_shadows() const
{
    return options_.shadows.form != ShadowChoice::Form::painted && options_.shadows.form != ShadowChoice::Form::none;
}

std::array<SceneRenderer::Part, 3> SceneRenderer::order() const
{
    if (scene_->hides_people() || has_claques_shadows()) return {Part::environment, Part::shadows, Part::crowd};
    return {Part::crowd, Part::environment, Part::shadows};
}

void SceneRenderer::send(Part part)
{
    if (part == Part::environment) scene_->draw_environment(gl_, eye_);
    if (part == Part::crowd) {
        drawn_ = clq_draw_stats_init();
        check(clq_renderer_draw(renderer_, view_.get(), &drawn_));
    }
    if (part == Part::shadows) {
        darkened_ = clq_shadow_stats_init();
        if (has_claques_shadows()) check(clq_renderer_draw_shadows(renderer_, view_.get(), &shadows_, &darkened_));
    }
}

void SceneRenderer::draw(Part part)
{
    send(part);
    gl_.Finish();
}

void SceneRenderer::draw_environment() { draw(Part::environment); }

clq_shadow_stats SceneRenderer::draw_shadows()
{
    draw(Part::shadows);
    return darkened_;
}

clq_draw_stats SceneRenderer::draw_crowd()
{
    draw(Part::crowd);
    return drawn_;
}

void SceneRenderer::draw_crowd_up_to(DrawPart last)
{
    quieten(last == DrawPart::claque);
    if (last == DrawPart::and_vertices) gl_.Enable(gl::scissor_test), gl_.Scissor(0, 0, 0, 0);
    draw_crowd();
    if (last == DrawPart::and_vertices) gl_.Disable(gl::scissor_test);
    quieten(false);
}

void SceneRenderer::frame(double time_s)
{
    update(time_s);
    draw_frame();
}

void SceneRenderer::draw_frame()
{
    begin_picture();
    for (const Part part : order()) {
        send(part);
        if (*options_.flush_triangles != 0) gl_.Flush();
    }
    draw_show();
    gl_.Finish();
}

void SceneRenderer::draw_show()
{
    scene_->draw_things(gl_, eye_);
    if (options_.show == Show::spheres) draw_spheres(gl_, eye_, scene_->crowd(), scene_->actors());
    if (options_.cull_scale < 1) draw_frustum(gl_, options_.cull_scale);
}

const std::vector<uint8_t> &SceneRenderer::read()
{
    offscreen_->read_rgb(x0_, x1_, rgb_);
    return rgb_;
}

const std::vector<uint8_t> &SceneRenderer::picture(double time_s)
{
    frame(time_s);
    return read();
}

clq_crowd_stats SceneRenderer::crowd_stats() const
{
    clq_crowd_stats stats = clq_crowd_stats_init();
    check(clq_crowd_get_stats(scene_->crowd(), &stats));
    return stats;
}

clq_view_stats SceneRenderer::view_stats() const
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view_.get(), &stats));
    return stats;
}

uint64_t SceneRenderer::view_hash() const { return clq_view_get_hash(view_.get()); }

uint64_t hash_of(const uint8_t *bytes, size_t size)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}

}  // namespace scenes
