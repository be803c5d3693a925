#include "tests/unit/track/made_tracks.h"

#include <cmath>
#include <map>

#include "lib/figures/figure.h"
#include "meshsplit/build.h"

namespace claque::test
{

namespace
{

struct Walker {
    explicit Walker(const std::string &figure)
        : tmpl(std::pmr::get_default_resource()), locomotion(std::pmr::get_default_resource())
    {
        for (const figures::Builtin &builtin : figures::builtins())
            if (figure == builtin.name) meshsplit::build(builtin.make(), {}, tmpl);
        track::LocomotionClips clips;
        clips.walk = tmpl.rig.find_clip("walk"), clips.run = tmpl.rig.find_clip("jog");
        clips.slow = tmpl.rig.find_clip("walk_slow"), clips.turn = tmpl.rig.find_clip("turn");
        for (const char *name : {"stand", "stand_look", "stand_shift"})
            clips.idles[clips.idle_count++] = tmpl.rig.find_clip(name);
        track::measure(tmpl, clips, locomotion);
    }
    model::Template tmpl;
    track::Locomotion locomotion;
};

double noise(uint64_t i) { return double((i * 0x9e3779b97f4a7c15u) >> 40) / double(1 << 24) - 0.5; }

}  // namespace

const track::Locomotion &locomotion_of(const std::string &figure)
{
    static std::map<std::string, std::unique_ptr<Walker>> made;
    std::unique_ptr<Walker> &walker = made[figure];
    if (!walker) walker = std::make_unique<Walker>(figure);
    return walker->locomotion;
}

std::vector<track::Point> points_of(double rate_hz, double length_s, const std::function<glm::dvec2(double)> &way)
{
    std::vector<track::Point> points;
    for (int i = 0; i <= static_cast<int>(length_s * rate_hz + 0.5); ++i) {
        const double t = i / rate_hz;
        const glm::dvec2 p = way(t);
        points.push_back({t, glm::dvec3(p.x, 0, p.y), std::nan("")});
    }
    return points;
}

std::unique_ptr<track::Track> track_of(const std::vector<track::Point> &points, const std::string &figure,
                                       const track::BuildSettings &settings)
{
    auto out = std::make_unique<track::Track>(std::pmr::get_default_resource());
    track::build(locomotion_of(figure), {points.data(), static_cast<uint32_t>(points.size())}, settings, *out);
    return out;
}

std::vector<Way> ways()
{
    const auto ahead = [](double speed) { return [speed](double t) { return glm::dvec2(0, speed * t); }; };
    const auto stop_and_go = [](double t) {
        const double within = std::fmod(t, 6), walked = within < 3 ? within : 3;
        return glm::dvec2(0, 1.2 * (3 * std::floor(t / 6) + walked));
    };
    const auto sway = [](double t) {
        return glm::dvec2(0.04 * std::sin(2 * M_PI * 0.9 * t), 1.3 * t + 0.01 * noise(uint64_t(t * 100)));
    };
    const auto corner = [](double t) { return t < 5 ? glm::dvec2(0, 1.2 * t) : glm::dvec2(1.2 * (t - 5), 6); };
    const auto circle = [](double t) { return glm::dvec2(std::cos(t), std::sin(t)); };
    const auto to_and_fro = [](double t) { return glm::dvec2(0, 2.5 * std::sin(0.5 * t)); };
    return {{"ahead at 0.2 m/s", points_of(10, 20, ahead(0.2))},
            {"ahead at 0.6 m/s", points_of(10, 20, ahead(0.6))},
            {"ahead at 1.1 m/s", points_of(10, 20, ahead(1.1))},
            {"ahead at 1.6 m/s", points_of(10, 20, ahead(1.6))},
            {"ahead at 2.6 m/s", points_of(10, 20, ahead(2.6))},
            {"a circle of 1 m", points_of(10, 20, circle)},
            {"a corner", points_of(25, 10, corner)},
            {"to and fro", points_of(5, 30, to_and_fro)},
            {"stop and go", points_of(25, 24, stop_and_go)},
            {"a swaying head", points_of(25, 15, sway)}};
}

}  // namespace claque::test
