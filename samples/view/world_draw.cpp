// A world's picture, or a part of it, in GL.
#include "samples/view/gl_calls.h"
#include "samples/view/world.h"

namespace view
{
namespace
{

constexpr unsigned context_is_lost = 0x0507;  // GL_CONTEXT_LOST of KHR_robustness

}  // namespace

clq_view *World::view_of_columns()
{
    if (!tile_view_) {
        clq_view *view = nullptr;
        scenes::check(clq_view_create(scene_->crowd(), &view));
        tile_view_.reset(view);
    }
    const auto width = static_cast<float>(width_);
    const float tile[4] = {static_cast<float>(columns_->x0) / width, 0, static_cast<float>(columns_->x1) / width, 1};
    scenes::check(clq_view_set_height(tile_view_.get(), static_cast<float>(height_)));
    scenes::check(clq_view_set_camera(tile_view_.get(), &camera_));
    scenes::check(clq_view_set_tile(tile_view_.get(), tile));
    return tile_view_.get();
}

void World::clear() const
{
    gl_.Viewport(0, below_, width_, height_);
    gl_.DepthMask(1);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
}

void World::look_for_loss() { context_lost_ = get_error_ && get_error_() == context_is_lost; }

void World::put(const uint8_t *rgb, int row_px)
{
    clear();
    draw_rows(width_, height_, rgb, row_px);
    look_for_loss();
}

void World::draw(Model &model)
{
    model.cost.drawn = clq_draw_stats_init();
    if (columns_ && !shows_part()) return;
    double start = now_s();
    if (columns_) {
        gl_.Enable(scenes::gl::scissor_test);
        gl_.Scissor(columns_->x0, below_, columns_->x1 - columns_->x0, height_);
    }
    clear();
    scene_->set_light(gl_, eye_);
    // Waiting for GL between the parts tells what each takes, and makes the whole slower.
    const bool apart = now_ && model.open.frame;
    // People who are near get textures of their own from all of the picture.
    const bool part = columns_ && made_.close_textures == 0;
    scenes::check(clq_renderer_draw(renderer_, part ? tile_view_.get() : view_.get(), &model.cost.drawn));
    if (level_row_) scenes::check(clq_renderer_draw(renderer_, level_row_->view(), nullptr));
    if (apart) gl_.Finish();
    else if (surface_.flushes_cheaply()) gl_.Flush();
    model.cost.crowd_ms = apart ? ms_since(start) : -1;
    start = now_s();
    // People come first: surroundings cost nothing where people hide them.
    scene_->draw_environment(gl_, eye_);
    workbench_->draw_ground(gl_, eye_, time_s_);
    if (apart) gl_.Finish();
    model.cost.surroundings_ms = apart ? ms_since(start) : -1;
    look_for_loss();
    scene_->draw_things(gl_, eye_);
    workbench_->draw_things(gl_, eye_, model);
    if (model.spheres) scenes::draw_spheres(gl_, eye_, scene_->crowd(), everyone());
    if (columns_) gl_.Disable(scenes::gl::scissor_test);
}

}  // namespace view
