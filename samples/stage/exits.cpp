// `call = "exit"`: the event "exit" comes back with the place of an exit. Without widths the exit with the shortest way
// is chosen. With widths the time to leave decides: the longer of the way and of the queue, which is everybody with the
// same choice and a shorter way. `call = "leave"`: the caller leaves the run.
#include <algorithm>
#include <cmath>

#include "samples/stage/run.h"

namespace staged
{
namespace
{

constexpr double speed_m_s = 1.34;      // Weidmann 1993
constexpr double people_per_s_m = 1.5;  // through a full door, as `claque bench doors` measures it
constexpr double kept = 0.6;            // factor on the time by the nearest exit, later by the chosen one
constexpr double closed_m = 1e6;        // an exit behind a closed door is the last choice

class Exits final : public Service
{
public:
    std::vector<std::string> actions() const override { return {"exit", "leave"}; }

    void serve(Run &run, size_t action, const Call &call) override
    {
        if (action == 1) return run.remove(call.person);
        const scenes::ScenarioAgents &agents = run.agents_of(call.person);
        if (agents.exits.empty())
            throw scenes::Failure(agents.at + ": its machine calls 'exit', and it has no 'exits'");
        choices_.resize(run.people().all().size());
        std::vector<Choice> all;
        for (const size_t exit : agents.exits) all.push_back({exit, call.time_s, way_m(run, call.person, exit)});
        const auto nearer = [](const Choice &a, const Choice &b) { return a.way_m < b.way_m; };
        Choice best = *std::min_element(all.begin(), all.end(), nearer);
        if (!agents.exit_widths_m.empty()) {
            const Choice &before = choices_[call.person];
            const uint64_t usual = before.exit == none ? best.exit : before.exit;
            double least_s = HUGE_VAL;
            for (size_t k = 0; k < all.size(); ++k) {
                const double queue_s = queue_before_s(run, call, all[k], people_per_s_m * agents.exit_widths_m[k]);
                const double own_s = std::max(all[k].way_m / speed_m_s, queue_s);
                const double cost_s = own_s * (all[k].exit == usual ? kept : 1);
                if (cost_s < least_s) least_s = cost_s, best = all[k];
            }
        }
        choices_[call.person] = best;
        run.send(call.person, "exit", run.stage().places[best.exit].position.data(), best.way_m);
    }

    void gone(Run &, uint32_t person) override
    {
        if (person < choices_.size()) choices_[person] = Choice();
    }

    void put(BytesOut &out) const override
    {
        out.put<uint64_t>(choices_.size());
        for (const Choice &one : choices_) out.put(one.exit), out.put(one.time_s), out.put(one.way_m);
    }
    void take(Run &run, BytesIn &in) override
    {
        choices_.resize(in.count(run.people().all().size()));
        for (Choice &one : choices_)
            one.exit = in.take<uint64_t>(), one.time_s = in.take<double>(), one.way_m = in.take<double>();
    }

private:
    static constexpr uint64_t none = ~uint64_t(0);
    struct Choice {
        uint64_t exit = none;  // of the places
        double time_s = 0, way_m = 0;
    };

    static double way_m(Run &run, uint32_t person, size_t exit)
    {
        const scenes::Place &place = run.stage().places[exit];
        clq_way way = clq_way_init();
        scenes::check(clq_navigation_find_way(run.navigation(), run.place_of(person).data(), place.position.data(), 0,
                                              nullptr, &way));
        if (way.point_count == 0)
            throw scenes::Failure(run.agents_of(person).at + ": the exit '" + place.name + "' is on no ground");
        return way.length + (way.complete ? 0 : closed_m);
    }

    // The time until everybody nearer has passed the exit: the first arrives, and a full door lets the others through.
    // Ways have become shorter since they were measured.
    double queue_before_s(const Run &run, const Call &call, const Choice &own, double people_per_s) const
    {
        double count = 0, first_m = own.way_m;
        for (const uint32_t person : run.here()) {
            const Choice &other = choices_[person];
            const double left_m = std::max(0.0, other.way_m - speed_m_s * (call.time_s - other.time_s));
            if (person == call.person || other.exit != own.exit || left_m >= own.way_m) continue;
            ++count, first_m = std::min(first_m, left_m);
        }
        return first_m / speed_m_s + count / people_per_s;
    }

    std::vector<Choice> choices_;  // by person
};

}  // namespace

std::unique_ptr<Service> make_exits() { return std::make_unique<Exits>(); }

}  // namespace staged
