// Fewer triangles for the same look: edges are collapsed onto one of their ends in the order of what that costs, so that
// every vertex that is left is one of the source's, with its influences, normal and place in the texture, and the
// vertices of a level are among those of every finer one.
//
// Seams stay shut: vertices that share a position move together, and an edge is collapsed only where every vertex that
// goes has a partner of its own side at the end that stays. Open borders are collapsed only along themselves; parts that
// touch along theirs are sewn. No triangle turns over, in space or in its texture.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/base/services.h"
#include "lib/lod/quadric.h"
#include "lib/model/model.h"

namespace claque::lod
{

// A part, and where its vertices are at rest in the space that all parts share: what is near on the character is near
// there, whatever node a rigid part hangs on.
struct SourcePart {
    const model::Part *part = nullptr;
    const std::vector<glm::vec3> *rest = nullptr;  // [positions.size()]; null: the part's own positions
};

struct DecimationOptions {
    std::vector<size_t> targets;  // triangles of all parts together, descending strictly
    double turn_deg = 60;         // no triangle may turn further in one collapse
    // What a difference costs beside a distance. An influence that another joint takes: how far the two part over the clips
    // of `model` (sway.h), or so much of the character's size where nothing is known of clips.
    double influence = 0.1;
    double texture = 0.25;  // of the distance on the surface by which a place in the texture moves; 0: none
    // Of the square of the area that a collapse takes away or adds: without it limbs, whose vertices all lie outside of what
    // is between them, become thin, and skin loses to clothes.
    double area = 10;
    // Of half the square of what zones have gained or lost of the surface that is seen.
    double zone_area = 30;
    const model::Model *model = nullptr;  // whose zones and clips; null: nobody's
    double joint_displacement = 1;        // of what influences cost by clips
};

struct Decimated {
    std::vector<model::Part> parts;                      // those of the source, in order; one may have no triangle left
    std::vector<std::vector<uint32_t>> source_vertices;  // of each part, of each vertex: which of the source's it is
    size_t triangles = 0;
    size_t flipped = 0;  // triangles that have turned over in their texture
    size_t non_manifold_triangles =
        0;  // triangles on edges with more than two faces: kept as they are, beyond the target if need be
};

// One for each target, finest first. `parts` have passed model::check. Stops above a target where no lawful collapse is
// left. The same whatever the jobs. Throws base::Error (CLQ_ARGUMENT) where there are no triangles or no targets. Deterministic.
std::vector<Decimated> decimate(const std::vector<SourcePart> &parts, const DecimationOptions &options,
                                const base::Jobs &jobs = {});

}  // namespace claque::lod
