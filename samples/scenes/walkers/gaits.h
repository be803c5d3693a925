// The clips by which a character walks and stands: its own, or those of the built-in citizen.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/library.h"
#include "samples/scenes/social_classes.h"

namespace scenes::walkers
{

struct Member;

// The clip whose name is one of these words, alone, after a separator or after a word with which most clips begin
// ("Man_Walk"), whatever the case; CLQ_NONE: there is none.
uint32_t find_clip(const clq_template *tmpl, const std::vector<std::string> &words);

// The clips that the class names, or those with usual names; CLQ_NONE: it has none, but it has a walk. Throws Failure
// with the names of the clips that a character lacks.
struct GaitClips {
    uint32_t walk = CLQ_NONE, run = CLQ_NONE, slow_walk = CLQ_NONE, turn = CLQ_NONE;
    std::vector<uint32_t> idles;
};
GaitClips gait_clips(const Member &member);

// Adds the citizen's gaits to the asset of a file without a walk, with a warning, if ten of its joints can be bound.
// `options`: those that the asset was loaded with.
void borrow_gaits(Library &library, const SocialClass &one, const clq_asset_options &options, clq_asset *asset);

// Warns of a walk that was cut from the middle of a way: its people walk beside their paths.
void warn_of_offset_walk(Library &library, const Member &member);

}  // namespace scenes::walkers
