// glTF 2.0 and GLB to a Model, or a refusal that a person can act on. The bytes may be anything.
//
// What is read: scenes, nodes, meshes with morph targets, skins, animations, base colours and their textures, extras of
// zones (zone_extras.h), of nodes (node_extras.h) and of animations (clip_extras.h). What is not (cameras, lights, the rest of a material) is passed over, and its faults with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/model/model.h"

namespace claque::asset
{

struct LoadOptions {
    std::string base_folder;                // for external buffers and images; empty: they are refused
    std::vector<std::string> hidden_nodes;  // parts of these and of what hangs on them get Part::hidden
    int scene = -1;                         // -1: the file's default, else scene 0, else all root nodes
    // Of everything kept or made on the way, images included. Below it there is a second rule: all but images takes at
    // most a small multiple of the bytes that came (budget.h), and images have one of their own (image.h).
    uint64_t memory_limit_bytes = 1ull << 30;
    uint32_t max_image_px = 16384;  // either side
    double motion_unit_m = 1;       // of BVH files, which do not say: metres (model units) a unit of theirs
};

// Whose way over the ground a file wants taken out of a clip (clip_extras.h, meshsplit/root_motion.h): nodes and clips of the
// model's rig.
struct RootMotionRequest {
    uint32_t clip = 0, node = 0;
};

// GLB or JSON is decided by the first bytes. Throws base::Error:
//   CLQ_FORMAT       something that is read breaks the rules of glTF; the text says where
//   CLQ_UNSUPPORTED  legal, but needs a feature that claque lacks; named
//   CLQ_LIMIT        a limit of the options, or more memory than the file's size justifies
//   CLQ_IO           an external file cannot be read
// and std::bad_alloc. Model::warnings says in one sentence each what was shown otherwise than the file has it.
// root_motions: filled unless null.
model::Model load_gltf(const uint8_t *bytes, size_t size, const LoadOptions &options,
                       std::vector<RootMotionRequest> *root_motions = nullptr);

}  // namespace claque::asset
