// Every call that is recorded, each with a crowd in which it succeeds.
#pragma once

#include <functional>
#include <string>

#include "tests/api/record_fixture.h"

namespace records
{

// A crowd in which every call can succeed.
struct Stage {
    TestWorld world;
    clq_crowd *crowd = world.new_crowd();
    clq_actor actor, member, other;
    clq_group group, empty;
    clq_attachment attachment;
    clq_layer layer;
    clq_colour_map *map = nullptr;
    saved::Bytes state;

    Stage();
    ~Stage() { clq_colour_map_destroy(map); }
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;
};

using Recorded = std::pair<std::string, std::function<clq_status(Stage &)>>;
std::vector<Recorded> recorded_calls();

}  // namespace records
