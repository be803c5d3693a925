// What a run does for its people when their machines call it by name: `call = "ACTION"`. A service answers with events
// whose place is the answer (`go = "sender"` in a machine leads there), by removing the caller, or by opening doors.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "samples/scenes/scenario/scenario.h"
#include "samples/stage/bytes.h"
#include "samples/stage/doors.h"

namespace staged
{

class Run;

struct Call {
    uint32_t person = 0;  // of People::all()
    double time_s = 0, value = 0;
};

class Service
{
public:
    virtual ~Service() = default;

    virtual std::vector<std::string> actions() const = 0;
    // In the flow of decisions, after the tick in which a person has called actions()[action], in the order of calls.
    virtual void serve(Run &run, size_t action, const Call &call) = 0;
    // In the same flow, before the tick that ends at end_s.
    virtual void before_tick(Run &, double /*end_s*/) {}
    // A person was removed from the run.
    virtual void gone(Run &, uint32_t /*person*/) {}

    // The doors that it has counted, for reports.
    virtual void tell(std::vector<DoorCount> &) const {}

    // What it remembers, for Run::save. take() throws Failure where the bytes are not what put() wrote.
    virtual void put(BytesOut &) const {}
    virtual void take(Run &, BytesIn &) {}
};

// The services that a scenario needs: one line for each kind.
std::vector<std::unique_ptr<Service>> make_services(const scenes::Scenario &scenario);

std::unique_ptr<Service> make_exits();
std::unique_ptr<Service> make_doors(const scenes::Staging &stage);
std::unique_ptr<Service> make_flights(const scenes::Staging &stage);
std::unique_ptr<Service> make_market(const scenes::ScenarioTown &town);
std::unique_ptr<Service> make_ushers(const scenes::Scenario &scenario);  // `scenario` has a theatre

}  // namespace staged
