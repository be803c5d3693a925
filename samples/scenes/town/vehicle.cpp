// The scene `vehicle`: omnibuses full of people drive through a small town. Each omnibus with its passengers is one
// group, which is moved and culled as one (S0 4.3).
#include <optional>

#include "samples/scenes/scene.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/stone.h"
#include "samples/scenes/town/passengers.h"

namespace scenes
{
namespace
{

constexpr Rgb paints[] = {{0.62f, 0.14f, 0.13f}, {0.14f, 0.36f, 0.27f}, {0.15f, 0.27f, 0.50f}, {0.80f, 0.52f, 0.16f}};
constexpr float person_m = 1.75f, shadow_width_m = 0.95f;

class Vehicle final : public Scene
{
public:
    Vehicle(Library &library, const CrowdOptions &crowd_options)
        : seed_(crowd_options.seed), town_(crowd_options.seed), passengers_(library, crowd_options, town_)
    {
        for (const Rgb &paint : paints) omnibuses_.emplace_back(paint);
    }

    clq_crowd *crowd() const override { return passengers_.crowd(); }
    std::vector<clq_actor> actors() const override { return passengers_.cast().actors(); }
    std::vector<clq_template *> templates() const override { return passengers_.templates(); }

    // close: beside the street on the square, as an omnibus comes by. overview: over the roofs.
    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const town::SquarePlan square = town::square_plan(town_.plan());
        const auto at = [&](double u, double v, double above) {
            const town::Point p = town_.plan().at(u, v);
            return std::array<double, 3>{p.x, town_.height(p.x, p.z) + above, p.z};
        };
        const auto from_to = [&](const std::array<double, 3> &e, const std::array<double, 3> &t, double fov,
                                 double near_m) {
            return look({e[0], e[1], e[2]}, {t[0], t[1], t[2]}, fov, aspect, near_m, 5500);
        };
        const town::Block &block = town_.plan().square();
        if (shot == Shot::close)
            return from_to(at(block.u1 - 2.6, square.fountain_v - 3, 2.0),
                           at(block.u1 + 6.2, square.fountain_v + 5.4, 1.35), 50, 0.3);
        return from_to(at(square.fountain_u + 60, square.fountain_v + 185, 78),
                       at(square.fountain_u - 2, square.fountain_v - 30, 4), 44, 2);
    }

    void place(double time_s) override { passengers_.drive(time_s); }

    void prepare(const Gl &gl) override
    {
        town_.prepare(gl);
        paint_.emplace(gl, plaster(seed_), true);
        shadows_.prepare(gl);
    }

    void set_light(const Gl &g, const Eye &eye) const override { town_.set_light(g, eye); }
    void draw_environment(const Gl &gl, const Eye &eye) const override
    {
        const Frustum cull(eye, cull_share_);
        town_.draw(gl, eye, &cull);
        shade(gl);
        gl.Enable(gl::cull_face);
        paint_->use();
        for (size_t i = 0; i < passengers_.poses().size(); ++i) {
            const town::Omnibus &omnibus = omnibuses_[i % omnibuses_.size()];
            const town::VehiclePose &pose = passengers_.poses()[i];
            if (cull.meets(in_world(omnibus.sphere(), pose))) omnibus.draw(gl, eye, pose);
        }
        gl.Disable(gl::texture_2d);
    }

    void cull_by(double share) override { cull_share_ = static_cast<float>(share); }

private:
    static Sphere in_world(const Sphere &s, const town::VehiclePose &at)
    {
        const auto axis = [&](size_t i) {
            return static_cast<float>(at.position[i] + static_cast<double>(s.centre.x) * at.right_hand_x[i] +
                                      static_cast<double>(s.centre.y) * at.up[i] +
                                      static_cast<double>(s.centre.z) * at.forward[i]);
        };
        return {{axis(0), axis(1), axis(2)}, s.radius};
    }

    void shade(const Gl &gl) const
    {
        Vec3 to_sun = town::Town::light().to_sun;
        shadows_.cast(passengers_.standing(), to_sun, person_m, shadow_width_m);
        wheels_.clear();
        for (const town::VehiclePose &pose : passengers_.poses()) town::Omnibus::shade(wheels_, pose, to_sun);
        gl.PolygonOffset(-2, -4);
        gl.Enable(gl::polygon_offset_fill);
        shadows_.draw(gl, wheels_);
        gl.Disable(gl::polygon_offset_fill);
    }

    uint64_t seed_;
    town::Town town_;
    town::Passengers passengers_;
    std::vector<town::Omnibus> omnibuses_;
    std::optional<Texture> paint_;
    mutable Shadows shadows_;
    mutable Geometry wheels_;
    float cull_share_ = 1;
};

}  // namespace

std::unique_ptr<Scene> make_vehicle(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Vehicle>(library, crowd_options);
}

}  // namespace scenes
