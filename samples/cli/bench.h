// What `bench` measures, and how it is said.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

struct BenchArguments {
    SceneArguments setup;
    std::string subject;
    std::vector<uint32_t> counts = {100, 500, 1000};
    std::vector<std::string> strategies = strategy_names(), caches = cache_names();
    std::vector<std::string> lods = {"off"};
    std::vector<std::string> culls = {"actor", "traditional"};
    std::vector<std::string> shadows;  // empty: as the scene paints them, and caches and varieties are compared
    std::string save;
    std::string operations;  // file for `claque cost --measured`
    int frames = 25;
    bool json = false, markdown = false;
};

// A crowd of each size, frame by frame from the same camera. "runs": one per count, cache and variety.
Json bench_by_count(const BenchArguments &arguments);
void print_counts(const Json &report);

// The sections of a camera path (S1 7). "sections": who is in view; "runs": one per section, cache and variety.
Json bench_along_path(const BenchArguments &arguments);
void print_sections(const Json &report);
// The same as a paragraph and a table for a README.
std::string markdown_of(const Json &report);

// Scenes of actors: update and draw in each cull mode, with what every phase was asked (S0 7.2).
Json bench_actors(const BenchArguments &arguments);
void print_actors(const Json &report);

// Writes the counts of a scene of actors to `operations`.
void write_operations(const BenchArguments &arguments);

// How an update grows with the number of actors: a chart of lines, with its table in "runs".
Json bench_growth(const BenchArguments &arguments);
void print_growth(const Json &report);

// Shared key-poses (S3), each a chart of lines with its table in "runs"; the subject says which.
bool is_of_key_poses(const BenchArguments &arguments);
Json bench_key_poses(const BenchArguments &arguments);
void print_key_poses(const Json &report);
std::string markdown_of_key_poses(const Json &report);

// Shadows on the ground, of one kind and another.
Json bench_shadows(const BenchArguments &arguments);
void print_shadows(const Json &report);

// Floats against packed vertices.
Json bench_vertex_format(const BenchArguments &arguments);
void print_vertex_format(const Json &report);

// Throws scenes::Failure unless `now` is what the variants before it drew; `what` names what was drawn.
void expect_same_picture(std::string &before, const std::string &now, const std::string &what);

}  // namespace cli
