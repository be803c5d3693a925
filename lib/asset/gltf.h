// Reads glTF 2.0 and GLB into a Model, or throws an error that says what to change. The bytes may be anything.
//
// It reads scenes, nodes, meshes with morph targets, skins, animations, base colours, emission and their textures, and
// the extras of zones (zone_extras.h), nodes (node_extras.h) and animations (clip_extras.h). Everything else (cameras,
// lights, the rest of a material) is ignored together with its errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/asset/near_colours.h"

namespace claque::asset
{

enum class Blend : uint8_t { unset = 0, opaque = 1, mask = 2 };  // clq_blend

struct LoadOptions {
    std::string base_folder;                // of external buffers and images; if it is empty they are refused
    std::vector<std::string> hidden_nodes;  // parts of these nodes and of their descendants get Part::hidden
    int scene = -1;                         // -1: the file's default, else scene 0, else all root nodes
    // Limit of all memory that is kept or used while loading, images included. Below it two more rules hold: everything
    // but images takes at most a small multiple of the input's size (budget.h), and images have a rule of their own
    // (image.h).
    uint64_t memory_limit_bytes = 1ull << 30;
    uint32_t max_image_px = 16384;  // width and height
    bool strict = false;  // a picture whose file is missing fails; else the base colour is shown, with a warning
    Colours colours = Colours::near;  // of zones without zone keys
    Blend blend = Blend::unset;
    double motion_unit_m = 1;  // metres (model units) per unit of a BVH file, which has none of its own
};

// The first bytes decide between GLB and JSON. Throws base::Error:
//   CLQ_FORMAT       the file breaks a rule of glTF; the text says where
//   CLQ_UNSUPPORTED  the file is legal but needs a feature that claque lacks; the text names it
//   CLQ_LIMIT        a limit of the options, or more memory than the file's size justifies
//   CLQ_IO           an external file cannot be read
// and std::bad_alloc. Model::warnings has one sentence for each thing that is shown differently from the file.
//   own_turn_deg   the turn about y that the file's format asks for: 180 for VRM 0.x, which faces -z by its
//                  specification, else 0; may be null
model::Model load_gltf(const uint8_t *bytes, size_t size, const LoadOptions &options, double *own_turn_deg = nullptr);

}  // namespace claque::asset
