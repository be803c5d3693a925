// What an individual that decides is at (docs/stage.md), for those who watch it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scenes
{

struct Mind {
    std::string machine;              // its file
    std::vector<std::string> states;  // of the machine, in its order; within others: "visits.stands"
    std::string state;                // the innermost one that it is in, as the stage names it
    double entered_s = 0;
    double decided_s = 0;  // all is decided up to then
    uint64_t transitions = 0;
    bool walks = false;
};

}  // namespace scenes
