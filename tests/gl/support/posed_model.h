// A template with vertices to draw, for tests: made by hand, so that drawing is tested independently of meshsplit.
#pragma once

#include <memory>
#include <vector>

#include "lib/draw/draw_list.h"

namespace gltest
{

namespace model = claque::model;

struct Mesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<std::array<uint8_t, 4>> colours;  // or empty
    // Of each triangle; empty: all 0. Surfaces here differ only in being drawn apart.
    std::vector<uint32_t> parts, surfaces;
    uint32_t part_count = 1, surface_count = 1;
};

constexpr uint16_t hole = 0xffff;

// The zone of every texel, or `hole`.
struct ZoneMap {
    uint32_t side = 0;
    uint32_t zone_count = 0;
    std::vector<uint16_t> zones;  // [side * side], row v = 0 first
};

struct PosedModel {
    std::unique_ptr<model::Template> tmpl;
    std::vector<float> positions, normals;  // level 0, copies included
    glm::vec3 centre = glm::vec3(0);
    float radius = 1;
    uint32_t texture_set = 0;  // the set that it shows
};

// One template of one level; the caller adds parts, spheres, influences and rig.
// Splits by the simplest conservative rule: a triangle touches every zone in the bounding box of its texels.
PosedModel make_posed(const Mesh &mesh, const ZoneMap &map);

// The template's own positions, with copies added.
PosedModel take_posed(std::unique_ptr<model::Template> tmpl);

// Computes the centre and radius of the bounding box of the positions.
void measure(PosedModel &posed);

// A sheet of cells x cells quads in the xy plane from -1 to 1, with waves in z; uv from 0 to 1.
Mesh sheet(uint32_t cells, float waves);

// Left half: vertical bands, one per zone. Right half: squares of `square` texels with mixed zones, finer than
// triangles.
ZoneMap torture_map(uint32_t side, uint32_t zone_count, uint32_t square);

// White texture RGB, so that a fragment shows its zone's colour alone.
void whiten(model::Template &tmpl);

// A light texture with varied, non-grey texels.
void paint(model::Template &tmpl);

// Colours that differ in the five bits per channel that RGB565 keeps. 3 per zone.
std::vector<uint8_t> zone_colours(uint32_t zone_count);

}  // namespace gltest
