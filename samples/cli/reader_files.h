// Files for `claque bench readers`: each has a number of one countable element of its format, and little else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/scenes/library.h"

namespace cli
{

// Milliseconds of processor time, and the name of the status or "ok"; the second of what is built from what was read.
struct Reading {
    double load_ms = 0, build_ms = 0;
    std::string loaded = "ok", built = "-";
};

constexpr uint32_t most_elements = 100000;

struct ReaderElement {
    const char *format, *element;
    uint32_t limit;  // the most that a file may have, and at most most_elements
    std::string (*make)(uint32_t count);
    Reading (*read)(scenes::Library &library, const std::string &bytes);
};

// Of all formats; then those of each source. Machines are there where libclaque-stage is.
std::vector<ReaderElement> reader_elements();
std::vector<ReaderElement> reader_elements_of_assets();
std::vector<ReaderElement> reader_elements_of_saves();
std::vector<ReaderElement> reader_elements_of_records();
std::vector<ReaderElement> reader_elements_of_pictures();
std::vector<ReaderElement> reader_elements_of_captures();
std::vector<ReaderElement> reader_elements_of_tracks();
std::vector<ReaderElement> reader_elements_of_areas();
std::vector<ReaderElement> reader_elements_of_machines();
std::vector<ReaderElement> reader_elements_of_others();

// Files that other formats are made from.
std::string gltf_with_nodes(uint32_t count);
std::string gltf_with_triangles(uint32_t count);
std::string gltf_with_keys(uint32_t count);
std::string gltf_with_channels(uint32_t count);
std::string gltf_with_animations(uint32_t count);
std::string gltf_with_markers(uint32_t count);
std::string gltf_with_morph_targets(uint32_t count);
std::string gltf_with_degrees_of_freedom(uint32_t count);
std::string gltf_with_pixels(uint32_t count);

double processor_ms();
std::string outcome_of(clq_status status);
Reading read_asset(scenes::Library &library, const std::string &bytes);
Reading read_clips(scenes::Library &library, const std::string &bytes);  // which are nothing to build

}  // namespace cli
