// The body of all benchmarks: 650 vertices on 33 bones; two clips of 1.1 s and 0.8 s with keys at 30 Hz.
#pragma once

#include <memory>

#include "lib/model/template.h"

namespace claque::bench
{

constexpr uint32_t vertex_count = 650, joint_count = 33;
constexpr double clip_lengths_s[] = {1.1, 0.8};

// Vertices follow neighbouring bones with random weights, in the order that meshsplit leaves: about 33 groups of 20 on
// the same bones, so that blocks of eight lanes are filled to four fifths.
model::Level make_level(uint32_t influences);

// A whole template of one such level. Its clips are kept in rows at the rate of their keys.
std::unique_ptr<model::Template> make_body(uint32_t influences);

}  // namespace claque::bench
