// Files that take much more than they hold, made here: each grows with a count of one of its elements.
#pragma once

#include <vector>

#include "../asset/maker.h"

namespace claque::testing
{

struct Attack {
    const char *name;
    Bytes (*make)(size_t count);
    bool bvh = false;
};

// Files that readers once took the square of their size for.
const std::vector<Attack> &reader_attacks();

// `nodes` nodes in a row, each turned or moved by every one of `clips` clips, with keys at 0, 0.001 and `length_s`.
Bytes long_clips(size_t nodes, size_t clips, float length_s);
// `wheels` rings of `corners` corners, each on a node that turns through half a turn until `length_s`.
Bytes turning_wheels(size_t wheels, size_t corners, float length_s);
// A triangle on `count` materials of different colours, which share one image of `side` by `side` texels.
Bytes tinted_images(size_t count, uint32_t side);
// One clip of `count` channels, each for a node of its own, that share `count` keys.
Bytes shared_keys(size_t count);
// `count` short clips, each of which moves one of as many nodes.
Bytes clips_of_a_node_each(size_t count);
// A triangle on `count` materials, each with an image of its own on the same bytes: a square of `side` texels. With
// `extras`, which may tell images apart.
Bytes images_on_one_view(size_t count, uint32_t side, bool extras);
// One clip of `length_s` seconds, from which root motion is asked.
Bytes long_root_motion(float length_s);

}  // namespace claque::testing
