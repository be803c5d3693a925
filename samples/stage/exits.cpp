// `call = "exit"`: the event "exit" comes back, and its place is the exit with the shortest way. `call = "leave"`: the
// caller leaves the run.
#include <cmath>

#include "samples/stage/run.h"

namespace staged
{
namespace
{

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
        const std::array<double, 3> from = run.place_of(call.person);
        const double *nearest = nullptr;
        double least = HUGE_VAL;
        for (const size_t exit : agents.exits) {
            const scenes::Place &place = run.stage().places[exit];
            clq_way way = clq_way_init();
            scenes::check(
                clq_navigation_find_way(run.navigation(), from.data(), place.position.data(), 0, nullptr, &way));
            if (way.point_count == 0)
                throw scenes::Failure(agents.at + ": the exit '" + place.name + "' is on no ground");
            // An exit behind a closed door is the last choice.
            const double length = way.length + (way.complete ? 0 : 1e6);
            if (length < least) least = length, nearest = place.position.data();
        }
        run.send(call.person, "exit", nearest, least);
    }
};

}  // namespace

std::unique_ptr<Service> make_exits() { return std::make_unique<Exits>(); }

}  // namespace staged
