// The Flavian Amphitheatre full of people, each on a seat of the plan, in the sun of an hour of the day.
#include <cmath>
#include <optional>

#include "samples/scenes/amphitheatre/awning.h"
#include "samples/scenes/amphitheatre/cavea.h"
#include "samples/scenes/amphitheatre/games.h"
#include "samples/scenes/amphitheatre/grounds.h"
#include "samples/scenes/amphitheatre/pictures.h"
#include "samples/scenes/amphitheatre/surround.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/sky.h"

namespace scenes
{
namespace
{

using namespace amphitheatre;

constexpr double usual_hour = 9.5;

CrowdOptions of_many(CrowdOptions options)
{
    options.lod_scale *= 1.4f;
    if (options.key_poses.band_count == 0) {
        options.key_poses.bands[0] = {30, CLQ_KEY_POSE_INTERPOLATED};
        options.key_poses.bands[1] = {70, CLQ_KEY_POSE_INTERMITTENT};
        options.key_poses.band_count = 2;
        options.key_poses.max_kept = 4096;
    }
    return options;
}

class Amphitheatre final : public Scene
{
public:
    Amphitheatre(Library &library, const CrowdOptions &options)
        : seed_(options.seed),
          plan_(plan_for(options.count)),
          light_(daylight_at(options.hour > 0 ? options.hour : usual_hour)),
          velarium_(plan_, light_),
          exposure_(plan_, velarium_, light_),
          stone_(plan_, exposure_, seed_),
          sky_(seed_, Sky::Land::hills),
          figures_(library, amphitheatre_levels),
          crowd_(library, of_many(options)),
          spectators_(figures_, crowd_, plan_, exposure_, options.count, seed_),
          games_(figures_, crowd_, plan_, exposure_, seed_)
    {
        build_cavea(stone_, plan_);
        build_podium(stone_, plan_);
        build_guest_seats(stone_, plan_);
        build_gallery(stone_, plan_);
        build_masts(stone_, plan_);
        wall_ = outer_wall(plan_, exposure_);
        floor_ = arena_floor(plan_, exposure_);
        paving_ = paving(plan_, exposure_);
        houses_ = houses(plan_, light_, seed_);
        linen_ = linen(plan_, velarium_, light_, seed_);
        ropes_ = ropes(plan_, velarium_);
    }

    clq_crowd *crowd() const override { return crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return figures_.templates(); }
    std::vector<std::string> viewpoints() const override { return {"above", "emperor", "top-row", "arena"}; }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        return from(shot == Shot::close ? "emperor" : "above", aspect);
    }

    clq_camera camera_from(const std::string &viewpoint, double aspect, double) const override
    {
        return from(viewpoint, aspect);
    }

    void place(double time_s) override
    {
        spectators_.act(time_s);
        games_.place(time_s);
    }

    void prepare(const Gl &gl) override
    {
        travertine_.emplace(gl, travertine(seed_), true, Texture::Filter::nearest);
        sand_.emplace(gl, sand(seed_), true);
        front_.emplace(gl, front(seed_), true, Texture::Filter::nearest);
        games_.prepare(gl);
    }

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::lighting);  // the stone has its light in its colours
        g.Enable(gl::cull_face);
        // Near things first: what they hide then costs no texture.
        travertine_->use();
        linen_.draw(g);
        front_->use();
        wall_.draw(g);
        travertine_->use();
        stone_.draw(g, eye);
        sand_->use();
        floor_.draw(g);
        travertine_->use();
        houses_.draw(g);
        paving_.draw(g);
        g.Disable(gl::texture_2d);
        games_.draw_shadows(g);
        sky_.draw(g, eye);
    }

    // Ropes are blended over everything behind them, people too.
    void draw_things(const Gl &g, const Eye &eye) const override
    {
        g.MatrixMode(gl::projection);
        g.LoadMatrixf(eye.projection);
        g.MatrixMode(gl::modelview);
        g.LoadMatrixf(eye.view);
        g.Disable(gl::lighting);
        g.Disable(gl::texture_2d);
        g.Disable(gl::cull_face);
        g.Enable(gl::blend);
        g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
        g.DepthMask(0);
        ropes_.draw(g);
        g.DepthMask(1);
        g.Disable(gl::blend);
        g.Enable(gl::lighting);
    }

private:
    clq_camera from(const std::string &viewpoint, double aspect) const
    {
        const double seat = box_floor_m + 1.75;  // the eyes of a standing person
        if (viewpoint == "emperor") return look({0, seat, arena_short_m + 1.0}, {-4.0, 7.5, -60}, 60, aspect, 0.3, 900);
        if (viewpoint == "top-row") {
            const Spot spot = plan_.oval().at(2.35, 44.6);
            return look({spot.x, plan_.walkways()[tier_count - 1].level_m + 1.7, spot.z}, {9, 6, -8}, 62, aspect, 0.3,
                        900);
        }
        if (viewpoint == "arena") return look({-25, 1.65, 3.5}, {30, 13, 1.5}, 66, aspect, 0.2, 900);
        // Behind the sun, so that the rows opposite are in its light.
        const double sx = static_cast<double>(light_.to_sun.x), sz = static_cast<double>(light_.to_sun.z);
        const double level = std::sqrt(sx * sx + sz * sz);
        const double towards_x = sx / level, towards_z = sz / level + 0.45;
        const double away = std::sqrt(towards_x * towards_x + towards_z * towards_z);
        const double far_m = 108 + 24 * std::abs(towards_x) / away;
        return look({far_m * towards_x / away, 150, far_m * towards_z / away}, {0, 0, 0}, 53, aspect, 5, 1500);
    }

    uint64_t seed_;
    Plan plan_;
    Daylight light_;
    Velarium velarium_;
    Exposure exposure_;
    Masonry stone_;
    Sky sky_;
    Figures figures_;
    SceneCrowd crowd_;
    Spectators spectators_;
    Games games_;
    Geometry wall_, floor_, paving_, houses_, linen_, ropes_;
    std::optional<Texture> travertine_, sand_, front_;
};

}  // namespace

std::unique_ptr<Scene> make_amphitheatre(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Amphitheatre>(library, crowd_options);
}

}  // namespace scenes
