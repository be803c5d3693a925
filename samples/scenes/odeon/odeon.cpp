// The odeon: three classes of Roman society in a theatre on a bright day (S1 7, S2 5.3).
#include "samples/scenes/light.h"
#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/odeon/touch.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/stone.h"

#include <fstream>
#include <optional>
#include <sstream>

namespace scenes
{
namespace
{

// The sun stands over the stage house and lights the faces of those who look at it.
constexpr Daylight afternoon = {
    {-0.30f, 0.62f, 0.72f}, {0.82f, 0.74f, 0.60f}, {0.39f, 0.41f, 0.45f}, {0.13f, 0.11f, 0.09f}};
constexpr Rgb paving = {0.86f, 0.82f, 0.74f};

Theatre theatre_of(const Casting &casting)
{
    if (casting.theatre_file.empty()) return read_theatre(odeon_description(), "odeon.toml");
    std::ifstream file(casting.theatre_file, std::ios::binary);
    std::stringstream text;
    if (file) text << file.rdbuf();
    if (!file || !text) throw Failure(casting.theatre_file + ": cannot be read");
    return read_theatre(text.str(), casting.theatre_file);
}

class Odeon final : public Scene
{
public:
    Odeon(Library &library, const Casting &casting)
        : seed_(casting.seed),
          theatre_(theatre_of(casting)),
          audience_(library, theatre_, casting),
          shadows_(audience_.seats(), audience_.sitters()),
          sky_(casting.seed, Sky::Land::hills)
    {
        build_cavea(stone_, theatre_, seed_);
        build_stage(stone_, theatre_);
        const float reach = static_cast<float>(theatre_.rows.back().radius_m + theatre_.rows.back().depth_m);
        ground_.disc(0, 0, 0, reach + 8, 96, paving);
    }

    clq_crowd *crowd() const override { return audience_.crowd(); }
    std::vector<clq_template *> templates() const override { return audience_.templates(); }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        if (shot == Shot::close) return look({-2.3, 6.15, -9.5}, {-4.3, 5.15, -14}, 49, aspect, 0.2, 600);
        return look({-2.4, 12.4, 9.4}, {0.3, 4.2, -9}, 62, aspect, 0.3, 900);
    }

    void place(double time_s) override { audience_.act(time_s); }

    void prepare(const Gl &gl) override
    {
        flagstones_.emplace(gl, flagstones(seed_), true);
        plaster_.emplace(gl, plaster(seed_), true);
        shadows_.prepare(gl);
    }

    void draw_setting(const Gl &g, const Eye &eye) const override
    {
        sky_.draw(g, eye);
        shine(g, afternoon, eye);
        g.Enable(gl::cull_face);
        flagstones_->use();
        ground_.draw(g);
        plaster_->use();
        stone_.draw(g);
        shadows_.draw(g);
    }

private:
    uint64_t seed_;
    Theatre theatre_;
    Audience audience_;
    TouchShadows shadows_;
    Sky sky_;
    Geometry ground_ = Geometry(flagstone_metres), stone_ = Geometry(plaster_metres);
    std::optional<Texture> flagstones_, plaster_;
};

}  // namespace

std::unique_ptr<Scene> make_odeon(Library &library, const Casting &casting, const Character &)
{
    return std::make_unique<Odeon>(library, casting);
}

}  // namespace scenes
