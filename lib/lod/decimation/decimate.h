// Decimates a character by half-edge collapses in order of cost. Every remaining vertex is a vertex of the source, with
// its influences, normal and texture coordinates. The vertices of a level are a subset of those of every finer level.
//
// Seams stay closed: vertices that share a position move together, and an edge collapses only if every vertex that is
// removed has a partner on its own side at the end that stays. Open borders collapse only along themselves; parts that
// touch along open borders are sewn. No triangle flips, in space or in its texture.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/lod/surface/source_part.h"

namespace claque::lod
{

struct DecimationOptions {
    std::vector<size_t> targets;  // triangles of all parts together, strictly descending
    double turn_deg = 60;         // the largest rotation of a triangle's normal in one collapse

    // The weights below set what a difference costs compared with a distance. This one is the cost of an influence that
    // moves to another joint: by how far the two joints separate over the clips of `model` (joint_displacement.h), or,
    // without clips, this fraction of the character's size.
    double influence = 0.1;
    double texture = 0.25;  // of the distance on the surface by which texture coordinates move; 0: none

    // Weight of the squared area that a collapse removes or adds. Without it limbs become thin, because their vertices
    // all lie on the outside, and skin loses area to clothes.
    double area = 10;
    // Weight of half the square of the change of each zone's visible area.
    double zone_area = 45;
    const model::Model *model = nullptr;  // provides zones and clips; null: none
    double joint_displacement = 1;        // weight of the influence cost that comes from clips
};

struct Decimated {
    std::vector<model::Part> parts;  // the parts of the source, in order; one may have no triangle left
    std::vector<std::vector<uint32_t>> source_vertices;  // [parts][vertices] index in the source part
    size_t triangles = 0;
    size_t flipped = 0;  // triangles that are flipped in texture space

    // Triangles on edges with more than two faces. They are kept unchanged, even beyond the target.
    size_t non_manifold_triangles = 0;
};

// Returns one level for each target, finest first. `parts` must have passed model::check. Where no legal collapse is
// left, that level stays above its target and is the last. Throws base::Error (CLQ_ARGUMENT) if there are no triangles
// or no targets. Deterministic.
std::vector<Decimated> decimate(const std::vector<SourcePart> &parts, const DecimationOptions &options);

// The same by OpenMesh's quadric alone, on the parts welded by position: the baseline for comparison. Seams, borders,
// zones, influences and textures cost nothing and are not kept. When a vertex moves onto another, each face corner
// takes the corner of its own part there with the nearest texture coordinates; without one, it takes only the position.
std::vector<Decimated> decimate_quadric_only(const std::vector<SourcePart> &parts, const std::vector<size_t> &targets);

}  // namespace claque::lod
