// The files of a parity folder by their numbers in an input (files.h).
#pragma once

namespace fuzzing
{

constexpr const char *parity_files[] = {"capture.json", "actors.npy", "sizes.npy", "positions.npy", "normals.npy",
                                        "colour.npy",   "depth.npy",  "actor.npy", "zone.npy"};
constexpr unsigned parity_file_count = sizeof parity_files / sizeof *parity_files;

}  // namespace fuzzing
