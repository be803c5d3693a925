// Clips made from the figures' own by varying them: as fast or slow, as wide or narrow, as early or late, and with as
// much of a sway of its own, as another person would do the same; half of them with the other hand. S1 4 and 8: 150
// clips for everybody.
//
// What holds for a clip holds for its variants: loops close, seated and standing ones begin and end in their common
// pose, feet stay where they are, hands that meet meet, and hands that lie on the thighs lie there.
#pragma once

#include <string>

#include "lib/figures/clips/clips.h"

namespace claque::figures
{

enum class Handedness : uint8_t { own, other };

struct Variant {
    uint32_t clip = 0;    // of figure_clips()
    uint32_t number = 1;  // of that clip's variants
    int frames = 0;       // length in thirtieths of a second
    float lead = 0;       // of the phase, at most so much of a cycle / 2 pi ahead of time or behind
    float trunk = 1;      // amplitude of back, neck and head about their mean
    float reach = 1;      // of the hands' ways: about where they meet, or about their mean
    Handedness handedness = Handedness::own;
    uint64_t seed = 0;  // of its sway
};

// The same on every call. Variants of one clip spread over the ranges above.
Variant variant_of(uint32_t clip, uint32_t number);
std::string name_of(const Variant &variant);  // "sit_talk.03"

// Poses at 0, 1, ... `frames`; the last key of a loop is the first one, to the bit.
std::vector<Pose> poses_of(const Variant &variant);

// Adds variants of all clips in turn until the rig has so many clips. It has to have the figures' own alone.
void add_variants(model::Rig &rig, uint32_t clip_count);

}  // namespace claque::figures
