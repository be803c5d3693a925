// What --cache may name: kinds of caches, those of shared key-poses with a size of their own.
#pragma once

#include <claque/crowd.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace cli
{

// Passes all names; those of key-poses also as NAME:N, N of them kept for each template and level.
extern const CLI::Validator cache_choice;

const std::vector<std::string> &cache_names();  // S1 Fig. 8

bool shares_key_poses(const std::string &cache);
// Which picture it shows: the same for all but those of key-poses, whose methods have one each, whatever their size.
std::string picture_of(const std::string &cache);

clq_cache_mode cache_named(const std::string &cache);
// The method that the cache names for everybody; `key_poses` holds size and rate, and the rest, if none is named.
void take_key_poses(const std::string &cache, clq_key_poses &key_poses);

}  // namespace cli
