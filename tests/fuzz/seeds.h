// Inputs that are whole and legal, made by the project's own writers. They follow changes of formats, which files of a
// corpus do not.
#pragma once

#include "tests/fuzz/fuzzer.h"

namespace fuzzing
{

struct Seed {
    std::string fuzzer, name;
    Bytes bytes;
};

void add_character_seeds(std::vector<Seed> &out);  // gltf, bvh, prepared
void add_picture_seeds(std::vector<Seed> &out);    // image
void add_folder_seeds(std::vector<Seed> &out);     // npy, parity
void add_people_seeds(std::vector<Seed> &out);     // trajectories, area
void add_record_seeds(std::vector<Seed> &out);     // record
std::vector<Seed> seeds();

}  // namespace fuzzing
