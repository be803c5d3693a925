// The options of a renderer and the statistics of a draw.
#pragma once

#include <cstdint>

namespace claque::passes
{

enum class Strategy : uint8_t { fused = 0, binned = 1, per_zone = 2 };
enum class Guard : uint8_t { full = 0, minimal = 1, none = 2 };
enum class ColourFormat : uint8_t { ubyte = 0, real = 1 };

// `equal` is the papers' test (S1 3). It works with the per-zone strategy only, and only where alpha keeps all its
// bits.
enum class KeyTest : uint8_t { greater_equal = 0, equal = 1 };

struct RendererOptions {
    Strategy strategy = Strategy::fused;
    Guard guard = Guard::full;
    ColourFormat colours = ColourFormat::ubyte;
    KeyTest key_test = KeyTest::greater_equal;
    bool linear_clean = false;       // filter clean triangles where that mixes no zones (linear_clean.h)
    uint32_t flush_triangles = 0;    // glFlush after this many, so that GL starts on them; 0: never
    uint32_t batch_triangles = 128;  // levels of at most this many are drawn in batches
    uint32_t flat_triangles = 64;    // batched levels of at most this many are drawn GL_FLAT (flat.h)
    uint64_t close_bytes = 0;        // of textures of individuals near the eye (close_textures.h); 0: none
    float close_distance_m = 0;      // individuals from here on show none; 0: measured (close_distance.h)
    uint32_t close_per_draw = 0;     // the most that one draw makes; 0: all that it wants
    bool multisample = false;        // GL_MULTISAMPLE as the host has it, otherwise off
    bool smooth_levels = false;      // coarser levels show smoothed images (smooth_levels.h)
    bool close_nearest = false;      // GL_NEAREST and one mip level, to compare them with the template's textures
};

// How far the two ways of sampling differ along edges between a filtered and an unfiltered triangle, in the finest
// level.
struct LuminanceStep {
    uint32_t linear_triangles = 0, triangles = 0, edges = 0;
    float mean = 0, max = 0;  // of 255
};

struct DrawStats {
    uint32_t individuals = 0;
    uint32_t parts = 0;              // parts of levels that were drawn (S0 4.2, phase 3)
    uint32_t matrices = 0;           // glMultMatrixf calls (S0 6.2.2, fTrack)
    uint32_t draws = 0;              // glDrawElements calls
    uint32_t triangles = 0;          // sent to GL, in every pass
    uint64_t vertices = 0;           // of the arrays given to GL, once per individual
    uint32_t close_individuals = 0;  // that showed a texture of their own
    uint32_t close_made = 0;         // textures made for individuals
    uint64_t close_bytes = 0;        // of all such textures that GL holds
    uint32_t state_changes = 0;      // GL calls that changed per-surface state: alpha test, texture, culling
};

}  // namespace claque::passes
