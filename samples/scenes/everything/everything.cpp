// The scene `everything`: a few figures that have, together, whatever a renderer of crowds has to draw, for tests of
// other renderers (docs/parity.md). Every third one is mirrored. A sun, a lamp and a spot light them, in fog.
#include <algorithm>
#include <cmath>

#include "samples/scenes/everything/figure.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/studio_ground.h"

namespace scenes
{
namespace
{

constexpr Daylight dusk = {{-0.35f, 0.60f, 0.72f}, {0.34f, 0.33f, 0.32f}, {0.26f, 0.28f, 0.33f}, {0.08f, 0.07f, 0.06f}};
constexpr float haze[4] = {0.40f, 0.43f, 0.50f, 1};
constexpr double across_m = 1.15, deep_m = 1.5;
constexpr uint32_t mirrored_every = 3;

class Everything final : public Scene
{
public:
    Everything(Library &library, const CrowdOptions &crowd_options)
        : scene_crowd_(library, crowd_options), figure_(everything::figure_of(library))
    {
        columns_ = static_cast<uint32_t>(std::ceil(std::sqrt(1.4 * crowd_options.count)));
        for (uint32_t i = 0; i < crowd_options.count; ++i) enter(i, crowd_options);
        lay_studio_ground(ground_, 0, 0, -deep_m, 60, 40);
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return {figure_}; }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const double wide = across_m * columns_;
        if (shot == Shot::close) return look({0.5, 1.5, 3.6}, {0.1, 1.0, 0}, 40, aspect, 0.1, 100);
        return look({0.1 * wide, 1.7 + 0.35 * wide, 2.0 + 1.05 * wide}, {0, 0.75, -0.25 * wide}, 38, aspect, 0.2, 200);
    }

    void place(double) override {}
    void prepare(const Gl &gl) override { shadows_.prepare(gl); }

    void set_light(const Gl &g, const Eye &eye) const override
    {
        set_lights(g, dusk, eye);
        light_lamp(g);
        light_spot(g);
        g.ClearColor(haze[0], haze[1], haze[2], 1);
        g.Clear(gl::color_buffer_bit);
        g.Fogfv(gl::fog_color, haze);
        g.Fogi(gl::fog_mode, gl::exp2);
        g.Fogf(gl::fog_density, 0.06f);
        g.Enable(gl::fog);
    }

    void draw_environment(const Gl &g, const Eye &) const override
    {
        ground_.draw(g);
        g.Disable(gl::lighting);
        shadows_.draw(g);
        g.Enable(gl::lighting);
    }

private:
    void enter(uint32_t index, const CrowdOptions &crowd_options)
    {
        const uint32_t row = index / columns_, column = index % columns_;
        const uint32_t here = std::min(columns_, crowd_options.count - row * columns_);
        const double x = (column - (here - 1) / 2.0) * across_m + (row % 2 == 1 ? 0.3 : 0);
        const double turn = random_between(crowd_options.seed, index, Purpose::heading, -2.4, 2.4);
        const float scale = static_cast<float>(random_between(crowd_options.seed, index, Purpose::size, 0.85, 1.1));
        clq_transform place = stand(x, 0, -deep_m * row, std::sin(turn), std::cos(turn), scale);
        if (index % mirrored_every == 1) mirror(place);
        clq_play play = {};
        play.clip = 0, play.speed = 1;
        play.phase_s = static_cast<float>(random_between(crowd_options.seed, index, Purpose::phase, 0, 2.4));
        scene_crowd_.enter({figure_, place, play});
        const float rim_m = 0.42f * std::fabs(place.scale);
        shadows_.ring(static_cast<float>(x), 0, static_cast<float>(-deep_m * row), rim_m, rim_m);
    }

    // A negative scale turns the figure over in a point; half a turn about x leaves left and right exchanged.
    static void mirror(clq_transform &place)
    {
        const float y = place.orientation_xyzw[1], w = place.orientation_xyzw[3];
        place.scale = -place.scale;
        place.orientation_xyzw[0] = w, place.orientation_xyzw[1] = 0;
        place.orientation_xyzw[2] = -y, place.orientation_xyzw[3] = 0;
    }

    // A lamp on the left, whose light falls off.
    void light_lamp(const Gl &g) const
    {
        const float at[4] = {-1.6f, 1.5f, 0.9f, 1}, colour[4] = {1.0f, 0.72f, 0.38f, 1}, none[4] = {0, 0, 0, 1};
        const float constant = 1, linear = 0.1f, quadratic = 0.25f;
        g.Lightfv(gl::light0 + 2, gl::position, at);
        g.Lightfv(gl::light0 + 2, gl::ambient, none);
        g.Lightfv(gl::light0 + 2, gl::diffuse, colour);
        g.Lightfv(gl::light0 + 2, gl::specular, none);
        g.Lightfv(gl::light0 + 2, gl::constant_attenuation, &constant);
        g.Lightfv(gl::light0 + 2, gl::linear_attenuation, &linear);
        g.Lightfv(gl::light0 + 2, gl::quadratic_attenuation, &quadratic);
        g.Enable(gl::light0 + 2);
    }

    // A narrow cone from above on the right.
    void light_spot(const Gl &g) const
    {
        const float at[4] = {2.6f, 4.2f, 1.4f, 1}, colour[4] = {0.75f, 0.95f, 1.1f, 1}, none[4] = {0, 0, 0, 1};
        const float direction[3] = {-0.42f, -0.88f, -0.5f}, cutoff_deg = 26, exponent = 9;
        g.Lightfv(gl::light0 + 3, gl::position, at);
        g.Lightfv(gl::light0 + 3, gl::ambient, none);
        g.Lightfv(gl::light0 + 3, gl::diffuse, colour);
        g.Lightfv(gl::light0 + 3, gl::specular, none);
        g.Lightfv(gl::light0 + 3, gl::spot_direction, direction);
        g.Lightfv(gl::light0 + 3, gl::spot_cutoff, &cutoff_deg);
        g.Lightfv(gl::light0 + 3, gl::spot_exponent, &exponent);
        g.Enable(gl::light0 + 3);
    }

    SceneCrowd scene_crowd_;
    clq_template *figure_;
    Geometry ground_;
    Shadows shadows_;
    uint32_t columns_ = 1;
};

}  // namespace

std::unique_ptr<Scene> make_everything(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Everything>(library, crowd_options);
}

}  // namespace scenes
