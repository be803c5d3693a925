// The measurements of `claque bench`, and how they are printed.
#pragma once

#include "samples/cli/reader_law.h"
#include "samples/cli/scene_arguments.h"

namespace cli
{

struct BenchArguments {
    SceneArguments setup;
    std::string subject;
    std::vector<uint32_t> counts = {100, 500, 1000};
    std::vector<std::string> strategies = strategy_names(), caches = cache_names();
    std::vector<std::string> lods = {"on"};
    std::vector<std::string> culls = {"actor", "traditional"};
    std::vector<std::string> shadows;  // empty: shadows as the scene paints them; caches and strategies are compared
    std::vector<int> processes;        // empty: caches and strategies are compared
    std::string save;
    std::string operations;      // file for `claque cost --measured`
    std::string clock = "wall";  // or "processor"
    readers::Law reader_law;
    int frames = 25;
    unsigned seeds = 5;  // of halls
    bool json = false, markdown = false;
};

// A crowd of each size, frame by frame from the same camera. "runs": one for each count, cache and strategy.
Json bench_by_count(const BenchArguments &arguments);
void print_counts(const Json &report);

// The sections of a camera path (S1 7). "sections": how many people are in view; "runs": one for each section, cache
// and strategy.
Json bench_along_path(const BenchArguments &arguments);
void print_sections(const Json &report);
// The report as a paragraph and a table in Markdown.
std::string markdown_of(const Json &report);

// Scenes of actors: update and draw in each cull mode, with the number of tests in each phase (S0 7.2).
Json bench_actors(const BenchArguments &arguments);
void print_actors(const Json &report);

// Writes the operation counts of a scene of actors to the file `operations`.
void write_operations(const BenchArguments &arguments);

// How the cost of an update grows with the number of actors: a line chart, with its table in "runs".
Json bench_growth(const BenchArguments &arguments);
void print_growth(const Json &report);

// Shared key-poses (S3): a line chart with its table in "runs"; the subject selects the experiment.
bool is_of_key_poses(const BenchArguments &arguments);
Json bench_key_poses(const BenchArguments &arguments);
void print_key_poses(const Json &report);
std::string markdown_of_key_poses(const Json &report);

// People on tracks against the same people in place (docs/tracks.md).
bool is_of_tracks(const BenchArguments &arguments);
Json bench_tracks(const BenchArguments &arguments);
void print_tracks(const Json &report);

// A city of up to a million people: a line chart of times, or of memory, with the table in "runs".
bool is_of_cities(const BenchArguments &arguments);
Json bench_cities(const BenchArguments &arguments);
void print_cities(const Json &report);

// Kinds of shadows on the ground.
Json bench_shadows(const BenchArguments &arguments);
void print_shadows(const Json &report);

// One picture by several processes: a line chart with its table in "runs", and a model of more of them.
Json bench_processes(const BenchArguments &arguments);
void print_processes(const Json &report);

// How much a picture flickers past a crowd that stands still.
bool is_of_flicker(const BenchArguments &arguments);
Json bench_flicker(const BenchArguments &arguments);
void print_flicker(const Json &report);

// Floating-point against packed vertices.
Json bench_vertex_format(const BenchArguments &arguments);
void print_vertex_format(const Json &report);

// Textures of single individuals against shared ones.
Json bench_close_textures(const BenchArguments &arguments);
void print_close_textures(const Json &report);

// Reading and splitting files at a tenth of and at the limit of each element that they count: a table in "runs".
bool is_of_readers(const BenchArguments &arguments);
Json bench_readers(const BenchArguments &arguments);
void print_readers(const Json &report);

// Walkers who leave halls (doors), and who walk round in a corridor (walking): a line chart with its table in "runs".
Json bench_halls(const BenchArguments &arguments);
void print_halls(const Json &report);

// Throws scenes::Failure unless `now` is the picture of the variants before it; `what` names the frame.
void expect_same_picture(std::string &before, const std::string &now, const std::string &what);

}  // namespace cli
