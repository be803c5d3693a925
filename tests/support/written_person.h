// The person that several written characters are made of: bones, surfaces, clips.
#pragma once

#include "tests/support/written_encoding.h"
#include "tests/support/written_motion.h"

namespace claque::testing
{

struct PersonBone {
    const char *name;
    int parent;  // of the bones, -1: the armature
    Triple offset;
};

const std::vector<PersonBone> &person_bones();
Triple place_of_bone(size_t bone);  // in the rest pose, under the armature

// Joints are numbers of bones.
Surface person_skin();      // head and arms
Surface person_tunic();     // body, up to four influences
Surface person_trousers();  // legs

// The armature, which turns, moves and enlarges, and the bones below it; returns the armature's node. The bones follow
// it in their order.
int add_person_nodes(Maker &maker);

// Moves points of the rest pose to the bone and then by `factor`: the inverse bind of surfaces that are stored smaller
// by `factor` and by `centre` from the middle.
std::vector<float> inverse_binds(const std::vector<size_t> &bones, float factor = 1, const Triple &centre = {0, 0, 0});

// A skin of these bones; returns its number.
int add_person_skin(Maker &maker, int armature, const std::vector<size_t> &bones, int inverse_bind_accessor);
std::vector<size_t> all_bones();

// "walk" from 0.25 s on (linear), "wave" (splines, steps, a single key) and "stand" of no length.
void add_person_clips(Maker &maker, int armature);

// A picture of 32 x 32 texels: skin, cloth and a chequered corner with holes.
Bytes person_picture();

}  // namespace claque::testing
