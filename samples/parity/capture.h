// A result in a parity folder, as docs/parity.md describes it.
#pragma once

#include <memory>
#include <optional>

#include "samples/parity/map.h"
#include "samples/parity/npy.h"

namespace parity
{

// Those of a template, which its meshes and actors share.
using ZoneNames = std::shared_ptr<const std::vector<std::string>>;

struct Actor {
    uint32_t id = 0;
    std::string kind;  // template and level of detail: "citizen, level 2"
    ZoneNames zones;
    size_t first_vertex = 0, vertex_count = 0;
    double size_m = 0;  // 0: the folder has no sizes.npy
};

struct Capture {
    std::string folder, renderer, scene;
    int width = 0, height = 0;
    double time_s = 0;
    std::optional<std::vector<Actor>> actors;              // ascending by id
    std::optional<std::vector<float>> positions, normals;  // three numbers a vertex, of all actors
    std::optional<Picture> colour;
    std::optional<Map<float>> depth;
    std::optional<Map<uint32_t>> actor;
    std::optional<Map<uint16_t>> zone;
};

// Reads the files that are there; arrays may be absent. Throws Unreadable if there is no folder, no capture.json or
// one of another version, or if arrays are broken, of another type, or of a size that contradicts capture.json.
Capture read_capture(const std::string &folder);

}  // namespace parity
