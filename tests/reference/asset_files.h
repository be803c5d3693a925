// Which real files the reference is held against.
#pragma once

#include <claque/base.h>

#include <string>
#include <vector>

namespace claque::reference
{

// The folder of real characters, with a slash behind it; "" where it does not exist.
std::string assets_folder();

// Paths of the .gltf and .glb files below that folder, sorted, except those in hostile/: what has to load, and what is
// refused for a reason. Never empty: where there are no assets they hold one "", so that a test is there to say that it
// was skipped.
std::vector<std::string> loadable_files();
std::vector<std::string> refused_files();

// Letters, digits and underscores only, as names of test cases must be.
std::string case_name(const std::string &file);

// What claque does not read, and says so; asset_files.cpp gives the reasons.
struct Refusal {
    const char *file;
    clq_status status;  // CLQ_OK: this build reads it
    const char *named;  // what the message has to name
};

// nullptr where the file has to load.
const Refusal *refusal_of(const std::string &file);

}  // namespace claque::reference
