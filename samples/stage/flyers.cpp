#include "samples/stage/flyers.h"

#include <cmath>

#include "samples/scenes/check.h"
#include "samples/stage/run.h"

namespace staged
{

using namespace scenes;

namespace
{

const double *corner(const ScenarioFlyer &flyer, size_t number)
{
    return flyer.path.data() + 3 * (number % (flyer.path.size() / 3));
}

void add_flyer(Library &library, clq_crowd *crowd, const ScenarioFlyer &flyer, std::vector<clq_template *> &templates)
{
    clq_template *tmpl = library.builtin(flyer.character);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl;
    def.transform.scale = static_cast<float>(flyer.scale);
    for (int k = 0; k < 3; ++k) def.transform.position[k] = flyer.path[static_cast<size_t>(k)];
    def.play.clip = clq_template_find_clip(tmpl, flyer.clip.c_str());
    if (def.play.clip == CLQ_NONE)
        throw Failure(flyer.at + ": the character '" + flyer.character + "' has no clip '" + flyer.clip + "'");
    clq_actor actor;
    check(clq_actor_create(crowd, &def, &actor), flyer.at);
    // In model space: round the first corner, in the actor's own size.
    std::vector<float> positions;
    for (size_t i = 0; i < flyer.path.size(); ++i)
        positions.push_back(static_cast<float>((flyer.path[i] - flyer.path[i % 3]) / flyer.scale));
    clq_root_path_def path = clq_root_path_def_init();
    path.count = static_cast<uint32_t>(positions.size() / 3), path.positions = positions.data();
    path.duration_s = static_cast<float>(lap_s(flyer));
    clq_root_path_play play = clq_root_path_play_init();
    check(clq_crowd_add_root_path(crowd, &path, &play.path), flyer.at);
    check(clq_actor_play_root_path(crowd, actor, &play), flyer.at);
    templates.push_back(tmpl);
}

// Tells people what flies near them.
class Flights final : public Service
{
public:
    explicit Flights(const Staging &stage) : flyers_(stage.flyers), sent_(flyers_.size(), 0) {}

    std::vector<std::string> actions() const override { return {"flee"}; }

    // The event "flee" comes back, with a place on the other side of the caller than the nearest flyer.
    void serve(Run &run, size_t, const Call &call) override
    {
        constexpr double flight_m = 6;
        const std::array<double, 3> at = run.place_of(call.person);
        std::array<double, 3> away = {1, 0, 0};
        double nearest = HUGE_VAL;
        for (const ScenarioFlyer &flyer : flyers_) {
            const std::array<double, 3> place = place_in_flight(flyer, call.time_s);
            const double x = at[0] - place[0], z = at[2] - place[2], distance = std::hypot(x, z);
            if (distance >= nearest || distance < 1e-6) continue;
            nearest = distance, away = {x / distance, 0, z / distance};
        }
        for (const double turn : {0.0, 0.7, -0.7, 1.4, -1.4}) {
            const double s = std::sin(turn), c = std::cos(turn);
            const double to[3] = {at[0] + flight_m * (c * away[0] - s * away[2]), at[1],
                                  at[2] + flight_m * (s * away[0] + c * away[2])};
            double found_at[3];
            bool found = false;
            check(clq_navigation_find_nearest(run.navigation(), to, 1.5, found_at, &found));
            if (found) return run.send(call.person, "flee", found_at);
        }
        run.send(call.person, "flee", at.data());
    }

    void before_tick(Run &run, double end_s) override
    {
        for (size_t i = 0; i < flyers_.size(); ++i) {
            const ScenarioFlyer &flyer = flyers_[i];
            const auto due = static_cast<uint64_t>(std::max(0.0, end_s / flyer.every_s));
            if (flyer.sends.empty() || due <= sent_[i]) continue;
            sent_[i] = due;
            clq_stage_event event = clq_stage_event_init();
            event.name = flyer.sends.c_str(), event.at_s = end_s, event.radius_m = static_cast<float>(flyer.radius_m);
            const std::array<double, 3> place = place_in_flight(flyer, end_s);
            std::copy(place.begin(), place.end(), event.position);
            check(clq_stage_send(run.handle(), &event), flyer.at);
        }
    }

    void put(BytesOut &out) const override
    {
        for (const uint64_t sent : sent_) out.put(sent);
    }
    void take(Run &, BytesIn &in) override
    {
        for (uint64_t &sent : sent_) sent = in.take<uint64_t>();
    }

private:
    std::vector<ScenarioFlyer> flyers_;
    std::vector<uint64_t> sent_;
};

}  // namespace

Flyers::Flyers(Library &library, clq_crowd *crowd, const Staging &stage)
{
    for (const ScenarioFlyer &flyer : stage.flyers) add_flyer(library, crowd, flyer, templates_);
}

double lap_s(const ScenarioFlyer &flyer)
{
    double length = 0;
    for (size_t i = 0; i < flyer.path.size() / 3; ++i) {
        const double *a = corner(flyer, i), *b = corner(flyer, i + 1);
        length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return std::max(length, 1e-3) / flyer.speed_m_s;
}

std::array<double, 3> place_in_flight(const ScenarioFlyer &flyer, double time_s)
{
    const size_t count = flyer.path.size() / 3;
    const double lap = time_s / static_cast<double>(static_cast<float>(lap_s(flyer)));
    const double at = (lap - std::floor(lap)) * static_cast<double>(count);
    const auto i = std::min(static_cast<size_t>(at), count - 1);
    const double t = at - static_cast<double>(i);
    std::array<double, 3> out{};
    for (size_t k = 0; k < 3; ++k) {  // Catmull-Rom
        const double p0 = corner(flyer, i + count - 1)[k], p1 = corner(flyer, i)[k];
        const double p2 = corner(flyer, i + 1)[k], p3 = corner(flyer, i + 2)[k];
        out[k] = p1 + t / 2 * (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
    }
    return out;
}

std::unique_ptr<Service> make_flights(const Staging &stage) { return std::make_unique<Flights>(stage); }

}  // namespace staged
