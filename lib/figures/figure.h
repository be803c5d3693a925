// The built-in characters, made by code without any file: a body from profile tables, dressed, unwrapped, painted in
// three dimensions, bound to one skeleton, with clips of its own. Used at start-up only; every call gives the same
// bytes.
#pragma once

#include <vector>

#include "lib/model/model.h"

namespace claque::figures
{

// All people have the same twenty-three clips, in this order, with their lengths in seconds:
//   stand 6, walk 1.1, applaud 2.4, cheer 2; sit 7, sit_lean 9, sit_look 8, sit_talk 8.5, sit_applaud 5.5,
//   sit_cheer 4.5, sit_laugh 5, sit_wave 4; rise 2, sit_down 2.1; stand_wave 4, stand_laugh 5,
//   stand_applaud 5, stand_cheer 4; jog 0.73, walk_slow 1.2, turn 1; stand_look 7, stand_shift 8.
// Seated clips expect a seat whose top is 0.43 m above the ground under the feet and whose front edge is 0.17 m behind
// the origin, and stay within 0.31 m to either side. Each begins and ends in the same neutral pose, so that any of them
// may follow any other at phase 0. rise and sit_down are not loops: rise goes from that pose to the beginning of stand,
// where the stand_* clips begin and end too, and sit_down goes back.

// A Roman citizen in a girded tunic: 1.75 m tall (in metres, Y up, facing +Z, standing on y = 0, the origin between the
// feet), 1092 triangles, 33 nodes, and the clips above. One 512 x 512 image whose alpha holds the keys of eight
// zones (skin, hair, eyes, lips, tunic, belt, border, sandals). Throws base::Error if the model breaks a rule of
// model::check.
model::Model citizen();

// A patrician: a rich woman in a stola to the ankles, girded under the breast, with a palla round hips and left
// shoulder and her hair dressed high. Ten zones: those of the citizen, outer (the palla) and jewellery.
model::Model patrician_woman();

// A decurion: an older, stout town councillor in a toga to the shins over a tunic. Nine zones: those of the citizen
// without the belt, outer (the toga) and jewellery (a signet ring).
model::Model decurion_man();

// A plebeian: a lean young working man in an exomis, right shoulder bare, girded with a rope above bare knees, with a
// cloak folded over the left shoulder. Nine zones: those of the citizen and outer (the cloak).
model::Model plebeian_man();

// A winged youth with trumpet and scroll who flies over towns: rigid parts on 13 Skeleton nodes with 19 degrees of
// freedom, five levels of detail (S0 7.1). 1.6 m from crown to toes, wings 3.5 m across, the origin in the middle of
// the body. 1354 triangles at the finest level, 30 from 400 m on. Ten zones. Clips: fly 2 s, glide 4, hover 2.
model::Model winged_herald();

// A broad brown owl that carries a letter, with the same nodes, degrees of freedom and clips; its feet are arm_left and
// arm_right, its tail is legs. 1.6 m from tufts to tail, wings 3.1 m across. Eight zones.
model::Model letter_owl();

constexpr uint32_t max_clips = 2000;

// Adds variants of a person's own clips until there are `clip_count` clips: "sit_talk.03" and so on (clips/variant.h).
void add_variants(model::Model &person, uint32_t clip_count);

struct Builtin {
    const char *name;
    model::Model (*make)();
};
const std::vector<Builtin> &people();    // those with the shared skeleton and the twenty-three clips
const std::vector<Builtin> &builtins();  // all built-in characters

}  // namespace claque::figures
