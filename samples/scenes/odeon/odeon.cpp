// The odeon: three classes of Roman society in a theatre on a bright day (S1 7, S2 5.3).
#include "samples/scenes/light.h"
#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/sky.h"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace scenes
{
namespace
{

// Afternoon: the sun stands over the stage house, to the audience's right, and lights their faces.
constexpr Daylight afternoon = {
    {-0.42f, 0.60f, 0.68f}, {0.78f, 0.70f, 0.56f}, {0.36f, 0.38f, 0.43f}, {0.14f, 0.12f, 0.09f}};

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
        : theatre_(theatre_of(casting)), audience_(library, theatre_, casting), sky_(casting.seed, Sky::Land::hills)
    {
        for (const SeatRow &row : theatre_.rows) {
            const float r = float(row.radius_m), y = float(row.seat_y_m), s = float(row.step_y_m),
                        d = float(row.depth_m);
            for (double a = row.first_deg; a < row.last_deg; a += 2) {
                const auto p = [&](float radius, float h, double at) {
                    at *= 0.0174532925;
                    return Vec3{radius * float(std::sin(at)), h, -radius * float(std::cos(at))};
                };
                stone_.quad({p(r, s, a), p(r, s, a + 2), p(r, y, a + 2), p(r, y, a)}, {0.8f, 0.77f, 0.7f});
                stone_.quad({p(r, y, a), p(r, y, a + 2), p(r + d, y, a + 2), p(r + d, y, a)}, {0.85f, 0.82f, 0.75f});
            }
        }
        stone_.disc(0, 0, 0, 15, 40, {0.7f, 0.65f, 0.6f});
    }

    clq_crowd *crowd() const override { return audience_.crowd(); }
    std::vector<clq_template *> templates() const override { return audience_.templates(); }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        if (shot == Shot::close) return look({-1.6, 2.75, -4.6}, {-3.4, 2.35, -8.4}, 46, aspect, 0.2, 600);
        return look({0, 11.0, 9.0}, {0, 4.4, -10}, 58, aspect, 0.3, 900);
    }

    void place(double time_s) override { audience_.act(time_s); }

    void prepare(const Gl &) override {}

    void draw_setting(const Gl &g, const Eye &eye) const override
    {
        sky_.draw(g, eye);
        shine(g, afternoon, eye);
        stone_.draw(g);
    }

private:
    Theatre theatre_;
    Audience audience_;
    Sky sky_;
    Geometry stone_;
};

}  // namespace

std::unique_ptr<Scene> make_odeon(Library &library, const Casting &casting, const Character &)
{
    return std::make_unique<Odeon>(library, casting);
}

}  // namespace scenes
