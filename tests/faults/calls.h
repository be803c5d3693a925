// Every call of the C API, with arguments that it accepts.
#pragma once

#include "tests/faults/world.h"

namespace faults
{

enum Trait : uint32_t {
    quiet = 1,    // allocates nothing, ever
    keeps = 2,    // what a failed call has reserved may stay for the next time
    ends = 8,     // destroys what others use: tried last, nothing is seen afterwards
    inside = 16,  // reports under the name of a call that it makes
    grows = 32,   // tried with one actor after the other, until tables have to grow
    counts = 64,  // succeeds without memory for single individuals, counts them in left_out, and shows them next time
};

struct Call {
    std::string name;
    std::function<clq_status(World &)> run;
    uint32_t traits = 0;
    std::function<void(World &)> after = {};  // after success: notes what it made in World::found, and destroys it
    std::string variant = {};                 // of several with one name
    std::function<void(World &)> before = {};
};

const std::vector<Call> &calls();

void note_template(World &w);  // for Call::after

void add_asset_calls(std::vector<Call> &all);
void add_people_calls(std::vector<Call> &all);
void add_record_calls(std::vector<Call> &all);
void add_template_calls(std::vector<Call> &all);
void add_stage_calls(std::vector<Call> &all);
void add_walking_calls(std::vector<Call> &all);
void add_navigation_calls(std::vector<Call> &all);  // with Recast
void add_other_calls(std::vector<Call> &all);

}  // namespace faults
