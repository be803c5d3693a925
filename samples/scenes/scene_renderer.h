// A scene in a GL context of its own: library, scene, view and renderer in the order in which they need each other.
// One frame is update, draw, read; each may be timed by itself.
#pragma once

#include "samples/contexts/offscreen.h"
#include "samples/scenes/camera_path.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/show.h"

#include <array>
#include <optional>

namespace scenes
{

// Of people on the ground: as the scene paints them, none, or claque's (claque/shadow.h) by ellipses or from what people show,
// with a stencil bit lent or without.
struct ShadowChoice {
    enum class Form { painted, none, blob, mesh };
    Form form = Form::painted;
    bool stencil = false;
    float blob_from_m = 40;  // of Form::mesh
};

struct SceneOptions {
    std::string scene = "plaza";
    CrowdOptions crowd_options;
    Character character;
    Shot shot = Shot::overview;
    std::optional<CameraPath> path;  // of Shot::path, which needs one
    int width = 1024, height = 768;
    contexts::Kind context = contexts::Kind::any;
    contexts::PixelFormat format = contexts::PixelFormat::rgba8888;
    clq_draw_strategy strategy = CLQ_STRATEGY_FUSED;
    bool linear_clean = false;     // clq_renderer_def.linear_clean
    uint32_t flush_triangles = 0;  // clq_renderer_def.flush_triangles; the setting is then flushed too
    uint32_t flat_triangles = 64;  // clq_renderer_def.flat_triangles
    bool tells_parts = false;      // draw_parts() will be asked for
    float cull_scale = 1;          // of the culling pyramid, against the picture's (S0 Fig. 10)
    Show show = Show::nothing;
    ShadowChoice shadows;
};

class SceneRenderer
{
public:
    // Throws Failure, also where Shot::path is asked for and there is none, and where the scene has no ground for shadows. Its context is current afterwards.
    SceneRenderer(Library &library, const SceneOptions &options);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer &) = delete;
    SceneRenderer &operator=(const SceneRenderer &) = delete;

    // Everything that costs no GL: who is where, and clq_crowd_update.
    void update(double time_s);
    void draw_environment();
    // Of people, where they are claque's: after the setting, before the crowd; waits as draw_crowd() does.
    clq_shadow_stats draw_shadows();
    // What StageOptions::show asks for, over all the rest.
    void draw_show();
    // The crowd alone, waiting for GL before and after, so that it can be timed.
    clq_draw_stats draw_crowd();
    // The same in parts, of a stage made with tells_parts: claque's own work, GL's with vertices, GL's with pixels.
    enum class DrawPart { claque, and_vertices, all };
    void draw_crowd_up_to(DrawPart last);
    // A whole frame as a host draws it: all of the above, waiting for GL at the end alone.
    void frame(double time_s);
    // The same, and read; three bytes a pixel, top row first, valid until the next.
    const std::vector<uint8_t> &picture(double time_s);
    // The mean of `samples` pictures of one moment, each moved by its part of a pixel: anti-aliasing where there is no
    // multisampling, over the values that pixels hold. All show the same poses, which are made once. 1: as picture().
    const std::vector<uint8_t> &picture(double time_s, uint32_t samples);
    const std::vector<uint8_t> &read();

    // Another strategy for the same crowd in the same context, from the next draw. What it needs is kept, so that
    // changing to and fro costs nothing.
    void use_strategy(clq_draw_strategy strategy);
    // Where there are several stages in turn.
    void make_current();

    clq_prepared_info prepared(const clq_template *tmpl) const;
    clq_crowd_stats crowd_stats() const;
    clq_view_stats view_stats() const;
    uint64_t view_hash() const;
    const std::string &context_name() const { return offscreen_->name(); }
    const Scene &scene() const { return *scene_; }
    const clq_view *view() const { return view_.get(); }
    const Eye &eye() const { return eye_; }  // of the last update
    const contexts::Offscreen &offscreen() const { return *offscreen_; }
    const Gl &gl() const { return gl_; }
    const std::optional<CameraPath> &path() const { return options_.path; }

private:
    void take_shadows();
    clq_shadow_stats send_shadows();
    clq_draw_stats send_crowd();

    Library &library_;
    SceneOptions options_;
    std::unique_ptr<contexts::Offscreen> offscreen_;
    Gl gl_;
    std::unique_ptr<Scene> scene_;
    Own<clq_view> view_;
    std::array<Own<clq_renderer>, 3> renderers_;  // by variety; made when first used
    clq_renderer *renderer_ = nullptr;            // one of them
    clq_shadow_def shadows_ = {};                 // where they are claque's
    Eye eye_ = {};
    double moved_px_[2] = {0, 0};  // the picture, right and up
    std::vector<uint8_t> rgb_;
};

// A fingerprint of bytes (FNV-1a, 64 bits), for pictures.
uint64_t hash_of(const std::vector<uint8_t> &bytes);

}  // namespace scenes
