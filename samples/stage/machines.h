// The machines of a scenario, each a file, with the scenario's places.
#pragma once

#include <claque/stage.h>

#include <map>

#include "samples/stage/people.h"

namespace staged
{

struct Machine {
    clq_machine id = {};
    bool goes = false;                // it has the action `go`: its agents walk
    std::vector<std::string> states;  // with those round them: "visits.stands"
};

// Adds each file once, for all characters that run it; by path. Throws Failure with the machine's place.
std::map<std::string, Machine> add_machines(clq_stage *stage, const scenes::Staging &described, const People &people);

}  // namespace staged
