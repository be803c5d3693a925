// Citizens on a Roman plaza: rings of talkers, an audience before its speaker, and walkers round them all.
#include <algorithm>

#include "samples/scenes/blocks.h"
#include "samples/scenes/light.h"
#include "samples/scenes/plaza_buildings.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/stone.h"

namespace scenes
{
namespace
{

// The distance of one cycle of the built-in citizen's walk clip at scale 1, so that feet do not slide.
constexpr double citizen_stride_m = 1.24;
constexpr float citizen_height_m = 1.75f, citizen_shadow_width_m = 0.95f;

constexpr float far_m = 34;  // where a column's mouldings are a few pixels

class Plaza final : public Scene
{
public:
    Plaza(Library &library, const CrowdOptions &crowd_options)
        : seed_(crowd_options.seed),
          citizen_(crowd_options.lod == Lod::on ? library.builtin("citizen", {}) : library.builtin("citizen")),
          walk_speed_(walk_speed(citizen_)),
          layout_(lay_out_plaza(crowd_options.count, crowd_options.seed, walk_speed_)),
          scene_crowd_(library, crowd_options),
          light_(crowd_options.light.value_or(Daylight())),
          sky_(crowd_options.seed, Sky::Land::hills)
    {
        for (const Standing &s : layout_.standing) enter(s);
        for (const Walking &w : layout_.walking) enter(w);
        Geometry ground, field;
        Parts stone(plaster_metres);
        pave(ground, layout_, crowd_options.seed);
        grow(field, layout_, crowd_options.seed);
        build(stone, layout_, crowd_options.seed);
        ground_ = Blocks(ground, 12), field_ = Blocks(field, 60),
        stone_ = Blocks(stone, 8, {far_m, light_, plaster_mean});
        rims();
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return {citizen_}; }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const double size = layout_.half_z / 16.5;
        if (shot == Shot::close)
            return look({layout_.close_eye[0], 1.62, layout_.close_eye[1]},
                        {layout_.close_target[0], 1.27, layout_.close_target[1]}, 44, aspect, 0.25, 700 + 300 * size);
        return look({0, 1.6 + 7.9 * size, layout_.half_z + 19.6 * size}, {0, 2.3, -2.0 * size}, 37, aspect, 0.5,
                    700 + 300 * size);
    }

    void place(double time_s) override
    {
        const size_t first = layout_.standing.size();
        for (size_t i = 0; i < layout_.walking.size(); ++i) {
            clq_transform &place = scene_crowd_.places()[first + i];
            place = walked(layout_.walking[i], time_s, place.scale);
        }
        if (!layout_.walking.empty() || !placed_) scene_crowd_.move();
        placed_ = true;
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        paints_people_ = false;
        def = shadows_in(light_);
        return true;
    }

    void cull_by(double share) override { cull_share_ = static_cast<float>(share); }
    void prepare(const Gl &gl) override
    {
        flagstones_.emplace(gl, flagstones(seed_), true, Texture::Filter::bilinear);
        plaster_.emplace(gl, plaster(seed_), true, Texture::Filter::bilinear);
        shadows_.prepare(gl);
    }

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        const Frustum cull(eye, cull_share_);
        g.Enable(gl::cull_face);
        plaster_->use();
        stone_.draw(g, eye, &cull);
        flagstones_->use();
        ground_.draw(g, eye, &cull);
        g.Disable(gl::texture_2d);
        field_.draw(g, eye, &cull);
        sky_.draw(g, eye);
        if (paints_people_)
            shadows_.cast(scene_crowd_.places(), light_.to_sun, citizen_height_m, citizen_shadow_width_m);
        shadows_.draw(g);
    }

private:
    static double walk_speed(const clq_template *citizen)
    {
        clq_clip_info walk = clq_clip_info_init();
        check(clq_template_get_clip(citizen, clq_template_find_clip(citizen, "walk"), &walk));
        return citizen_stride_m / static_cast<double>(walk.duration_s);
    }

    float size_of(size_t person) const
    {
        return static_cast<float>(random_between(seed_, person, Purpose::size, 0.94, 1.06));
    }

    clq_play play(const char *clip, double speed, size_t person) const
    {
        clq_play play = {};
        play.clip = clq_template_find_clip(citizen_, clip);
        play.speed = static_cast<float>(speed);
        clq_clip_info info = clq_clip_info_init();
        if (play.clip != CLQ_NONE && clq_template_get_clip(citizen_, play.clip, &info) == CLQ_OK)
            play.phase_s = static_cast<float>(random_unit(seed_, person, Purpose::phase) * info.duration_s);
        return play;
    }

    const char *clip_of(Standing::Role role, size_t person) const
    {
        const double share = random_unit(seed_, person, Purpose::clip);
        if (role == Standing::Role::speaker) return "cheer";
        if (role == Standing::Role::listener) return share < 0.60 ? "applaud" : share < 0.86 ? "cheer" : "stand";
        return share < 0.90 ? "stand" : "applaud";
    }

    void enter(const Standing &s)
    {
        const size_t person = scene_crowd_.places().size();
        const double speed = random_between(seed_, person, Purpose::speed, 0.9, 1.1);
        scene_crowd_.enter({citizen_, stand(s.x, s.y, s.z, s.facing_x, s.facing_z, size_of(person)),
                            play(clip_of(s.role, person), speed, person)});
    }

    void enter(const Walking &w)
    {
        const size_t person = scene_crowd_.places().size();
        const float size = size_of(person);
        // All walkers of a lane have one speed; short people take more steps for it.
        const double speed = std::abs(layout_.lanes[w.lane].speed) / (walk_speed_ * size);
        scene_crowd_.enter({citizen_, walked(w, 0, size), play("walk", speed, person)});
    }

    clq_transform walked(const Walking &w, double time_s, float size) const
    {
        const Lane &lane = layout_.lanes[w.lane];
        const Step step = lane.way.at(w.start + lane.speed * time_s);
        const double way = lane.speed < 0 ? -1 : 1;
        return stand(step.x, 0, step.z, way * step.dx, way * step.dz, size);
    }

    void rims()
    {
        const float r = static_cast<float>(layout_.fountain_radius) + 0.35f;
        shadows_.ring(static_cast<float>(layout_.fountain[0]) + 0.3f, 0,
                      static_cast<float>(layout_.fountain[1]) - 0.35f, r * 1.45f, r * 1.45f);
        shadows_.ring(static_cast<float>(layout_.rostra[0]) + 0.25f, 0, static_cast<float>(layout_.rostra[1]) - 0.3f,
                      static_cast<float>(layout_.rostra_half[0]) * 1.6f,
                      static_cast<float>(layout_.rostra_half[1]) * 1.7f);
    }

    uint64_t seed_;
    clq_template *citizen_;  // owned by the library
    double walk_speed_;      // metres a second of the walk clip at speed and scale 1
    PlazaLayout layout_;
    SceneCrowd scene_crowd_;
    bool placed_ = false, paints_people_ = true;
    Daylight light_;
    Sky sky_;
    Blocks ground_, field_, stone_;
    float cull_share_ = 1;
    std::optional<Texture> flagstones_, plaster_;
    mutable Shadows shadows_;
};

}  // namespace

std::unique_ptr<Scene> make_plaza(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Plaza>(library, crowd_options);
}

}  // namespace scenes
