// [[people]] of a scenario (docs/scenarios.md): single individuals, each with a place, colours and a role.
#pragma once

#include <cstdint>

#include "samples/scenes/placement.h"
#include "samples/scenes/roles/role.h"

namespace scenes::roles
{

struct Person {
    std::string character;  // in a scenario by the number of its class
    Placement placement;    // of its file
    size_t member = 0;
    std::array<double, 3> at = {0, 0, 0};
    std::array<float, 4> orientation = {0, 0, 0, 1};
    float scale = 1;
    uint64_t seed = 0;
    std::string textures;                         // a texture set; empty: the character's own
    std::vector<std::array<uint8_t, 3>> colours;  // by zone; empty: by chance
    Role role;
    std::string at_file;  // in the scenario, for messages
};

// A scenario of these people, which stand on level ground: what read_people reads.
std::string text_of(const std::string &name, const std::vector<Person> &people, const std::string &camera);

}  // namespace scenes::roles
