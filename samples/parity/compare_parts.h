// The groups of measures, one function each: it adds its measures, or says why there are none.
#pragma once

#include "samples/parity/compare.h"

namespace parity
{

struct Pair {
    const Capture &reference, &result;
};

void compare_actors(const Pair &pair, Comparison &out);
void compare_vertices(const Pair &pair, Comparison &out);  // positions and normals
void compare_id_maps(const Pair &pair, Comparison &out);   // individuals, then zones of individuals that both show
void compare_depth(const Pair &pair, Comparison &out);
void compare_colour(const Pair &pair, double pixels_per_degree, Comparison &out);

// "actor 17 (citizen, level 2)" by the reference's table; pixels without an actor are "the background".
std::string actor_text(const Capture &capture, uint32_t id);

// Returns true if both have the array; otherwise notes which folder lacks the file.
template <class Array>
bool both_have(const Array &reference, const Array &result, const char *group, const char *file, Comparison &out)
{
    if (reference && result) return true;
    const char *person = reference ? "the result has" : result ? "the reference has" : "neither has";
    out.not_compared.push_back({group, std::string(person) + (reference || result ? " no " : " ") + file});
    return false;
}

}  // namespace parity
