// The values of --cache: kinds of caches; key-pose caches may name a size.
#pragma once

#include <claque/crowd.h>

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace cli
{

// Accepts all names; those of key-poses also as NAME:N, with N key-poses for each template and level.
extern const CLI::Validator cache_choice;

const std::vector<std::string> &cache_names();  // S1 Fig. 8

bool shares_key_poses(const std::string &cache);
// The kind of picture a cache shows: the same for all caches without key-poses, and one for each key-pose mode,
// whatever its size.
std::string picture_of(const std::string &cache);

clq_cache_mode cache_named(const std::string &cache);
// Sets the mode that the cache names for all actors; `key_poses` holds the rate, and the size if the cache names none.
void take_key_poses(const std::string &cache, clq_key_poses &key_poses);

}  // namespace cli
