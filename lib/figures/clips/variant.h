// Makes clips from the built-in ones by varying them as other people would move: faster or slower, wider or narrower,
// earlier or later, with a sway of their own; half of them use the other hand. S1 4 and 8: 150 clips.
//
// Variants keep the properties of their clip: loops close, seated and standing clips begin and end in their shared
// pose, feet stay in place, hands that meet still meet, and hands on the thighs still lie there.
#pragma once

#include <string>

#include "lib/figures/clips/clips.h"

namespace claque::figures
{

enum class Handedness : uint8_t { own, other };

struct Variant {
    uint32_t clip = 0;    // index of figure_clips()
    uint32_t number = 1;  // number among that clip's variants
    int frames = 0;       // length in thirtieths of a second
    float lead = 0;       // of the phase: at most this fraction of a cycle / 2 pi early or late
    float trunk = 1;      // amplitude of back, neck and head about their mean
    float reach = 1;      // scale of the hands' paths, about their meeting point or about their mean
    Handedness handedness = Handedness::own;
    uint64_t seed = 0;  // of its sway
};

// Returns the same on every call. The variants of one clip are spread over the ranges above.
Variant variant_of(uint32_t clip, uint32_t number);
std::string name_of(const Variant &variant);  // "sit_talk.03"

// Poses at 0, 1, ... `frames`. The last key of a loop equals the first to the bit.
std::vector<Pose> poses_of(const Variant &variant);

// Adds variants of all clips in turn until the rig has `clip_count` clips. The rig must have exactly the built-in
// clips. `fit`: that of the figure.
void add_variants(model::Rig &rig, uint32_t clip_count, Fit fit = nullptr);

}  // namespace claque::figures
