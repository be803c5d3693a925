// A scene in a GL context of its own: library, scene, view and renderer, in the order in which they depend on each
// other. One frame is update, draw, read; each may be timed by itself.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "samples/contexts/offscreen.h"
#include "samples/scenes/camera_path.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/show.h"

namespace scenes
{

// Shadows of people on the ground: as the scene paints them, none, or claque's (claque/shadow.h) as ellipses or from
// the individuals' meshes, with or without a stencil bit.
struct ShadowChoice {
    enum class Form { painted, none, blob, mesh };
    Form form = Form::painted;
    bool stencil = false;
    float blob_from_m = 40;  // for Form::mesh
};

struct SceneOptions {
    std::string scene = "plaza";
    // Makes the scene in place of the list of scenes; `scene` is then its name in messages.
    std::function<std::unique_ptr<Scene>(Library &, const CrowdOptions &)> make;
    CrowdOptions crowd_options;
    Character character;
    Shot shot = Shot::overview;
    std::optional<CameraPath> path;  // for Shot::path, which needs one
    std::string viewpoint;           // of the scene's viewpoints(), in place of the shot; empty: none
    int width = 1024, height = 768;
    contexts::Kind context = contexts::Kind::any;
    contexts::PixelFormat format = contexts::PixelFormat::rgba8888;
    clq_draw_strategy strategy = CLQ_STRATEGY_FUSED;
    bool linear_clean = false;         // clq_renderer_def.linear_clean
    bool smooth_levels = false;        // clq_renderer_def.smooth_levels
    int multisample = 1;               // samples a pixel of the context, which people then have too
    uint64_t close_texture_bytes = 0;  // clq_renderer_def.close_texture_bytes
    float close_distance_m = 0;        // clq_renderer_def.close_distance_m
    // clq_renderer_def.flush_triangles; the environment is then flushed too. None: what is fast with the context.
    std::optional<uint32_t> flush_triangles;
    uint32_t flat_triangles = 64;  // clq_renderer_def.flat_triangles
    bool tells_parts = false;      // needed by draw_crowd_up_to()
    float cull_scale = 1;          // of the culling frustum, relative to the picture's (S0 Fig. 10)
    Show show = Show::nothing;
    ShadowChoice shadows;
};

class SceneRenderer
{
public:
    // Throws Failure; also if Shot::path has no path, or shadows are requested and the scene has no ground for them.
    // Its context is current afterwards.
    SceneRenderer(Library &library, const SceneOptions &options);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer &) = delete;
    SceneRenderer &operator=(const SceneRenderer &) = delete;

    // From now on draws the columns [x0, x1) of the picture alone, with the pixels that they have in the whole picture.
    // read() and picture() then return these columns.
    void show_tile(int x0, int x1);

    // All work without GL: positions of the individuals, and clq_crowd_update.
    void update(double time_s);
    // From now on all individuals stay as at this time, and times move the camera alone.
    void hold_crowd(double time_s) { held_s_ = time_s; }
    // Clears the picture and sets the light for what is drawn next.
    void begin_picture();
    // What is drawn then, in this order. People come first, because their surroundings cost nothing where people hide
    // them, unless the scene hides people; but claque's shadows of people fall on surroundings that are there, and
    // people stand in front of them.
    enum class Part : uint8_t { environment, shadows, crowd };
    std::array<Part, 3> order() const;
    // Draws one part and waits for GL, so that it can be timed. Shadows are drawn if they are claque's.
    void draw(Part part);
    void draw_environment();
    clq_shadow_stats draw_shadows();
    clq_draw_stats draw_crowd();
    // Draws what the scene draws last, and the overlay of SceneOptions::show.
    void draw_show();
    // The same in parts, for a scene with tells_parts: claque's own work, GL's with vertices, GL's with pixels.
    enum class DrawPart { claque, and_vertices, all };
    void draw_crowd_up_to(DrawPart last);
    // A whole frame as a host draws it: all of the above, waiting for GL only at the end.
    void frame(double time_s);
    void draw_frame();  // the same without the update
    // A picture whose parts are drawn one by one; timed(part, draw) calls draw().
    template <class Timed>
    void draw_apart(Timed timed)
    {
        begin_picture();
        for (const Part part : order()) timed(part, [&] { draw(part); });
        draw_show();
    }
    const clq_draw_stats &drawn() const { return drawn_; }          // by the last draw of the crowd
    const clq_shadow_stats &darkened() const { return darkened_; }  // by the last draw of its shadows
    // The same, and read; three bytes a pixel, top row first, valid until the next call.
    const std::vector<uint8_t> &picture(double time_s);
    // The mean of `samples` pictures of one time, each moved by its part of a pixel: anti-aliasing without
    // multisampling (which is off), averaged over stored pixel values. All show the same poses, which are computed
    // once. 1: as picture(). Parts of a pixel are numbered; pictures with other numbers are independent of these.
    const std::vector<uint8_t> &picture(double time_s, uint32_t samples, uint32_t first = 1);
    const std::vector<uint8_t> &read();

    // Another strategy for the same crowd in the same context, from the next draw on. Renderers are kept, so that
    // switching back costs nothing.
    void use_strategy(clq_draw_strategy strategy);
    // For several scenes in turn.
    void make_current();

    // The camera at a time, and the individuals where they are then, for labels of other times; no list is made.
    clq_camera camera_at(double time_s) const;
    // From now on shows what this camera sees, at any time; none: the camera of the options.
    void look_from(const std::optional<clq_camera> &camera) { standing_ = camera; }
    void place(double time_s) { scene_->place(time_s); }
    clq_renderer *renderer() const { return renderer_; }

    clq_prepared_info prepared(const clq_template *tmpl) const;
    clq_crowd_stats crowd_stats() const;
    clq_view_stats view_stats() const;
    uint64_t view_hash() const;
    const std::string &context_name() const { return offscreen_->name(); }
    const Scene &scene() const { return *scene_; }
    clq_view *view() const { return view_.get(); }
    const Eye &eye() const { return eye_; }  // of the last update
    const contexts::Offscreen &offscreen() const { return *offscreen_; }
    const Gl &gl() const { return gl_; }
    const std::optional<CameraPath> &path() const { return options_.path; }

private:
    void set_multisample(bool on);
    void expect_viewpoint() const;
    void take_shadows();
    bool has_claques_shadows() const;
    void send(Part part);

    Library &library_;
    SceneOptions options_;
    std::unique_ptr<contexts::Offscreen> offscreen_;
    Gl gl_;
    std::unique_ptr<Scene> scene_;
    Own<clq_view> view_;
    std::array<Own<clq_renderer>, 3> renderers_;  // by strategy; made when first used
    clq_renderer *renderer_ = nullptr;            // one of them
    clq_shadow_def shadows_ = {};                 // if they are claque's
    Eye eye_ = {};
    clq_draw_stats drawn_ = {};
    clq_shadow_stats darkened_ = {};
    std::optional<double> held_s_;        // the crowd's time, if it is not that of the camera
    std::optional<clq_camera> standing_;  // in place of the options' camera
    double moved_px_[2] = {0, 0};         // of the picture, right and up
    int x0_ = 0, x1_ = 0;                 // the columns that are drawn
    std::vector<uint8_t> rgb_;
};

// A hash of bytes (FNV-1a, 64 bits), for pictures.
uint64_t hash_of(const uint8_t *bytes, size_t size);
inline uint64_t hash_of(const std::vector<uint8_t> &bytes) { return hash_of(bytes.data(), bytes.size()); }

}  // namespace scenes
