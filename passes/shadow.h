// Options of shadows on the ground (S1 9, S3 1), and the statistics of drawing them.
#pragma once

#include <cstdint>
#include <limits>

namespace claque::passes
{

// The height of the plane that receives an individual's shadow, along `up`.
enum class ShadowGround : uint8_t { reference = 0, plane = 1, host = 2 };

struct ShadowOptions {
    double light[4] = {0, 1, 0, 0};  // in the world. Last 0: the direction to a distant light; 1: its position
    double up[3] = {0, 1, 0};        // unit
    ShadowGround ground = ShadowGround::reference;
    double plane_height = 0;                                      // ShadowGround::plane
    double (*height)(void *user, const double *point) = nullptr;  // ShadowGround::host
    void *user = nullptr;
    double lift = 0.01;  // above that height, world units
    float rgb[3] = {0, 0, 0};
    float darkness = 0.5f;     // share of rgb that is taken away
    int32_t stencil_bit = -1;  // lent by the host, or -1
    // Eye distance from which an ellipse replaces the shadow.
    float blob_from_m = std::numeric_limits<float>::infinity();
    float none_from_m = std::numeric_limits<float>::infinity();
};

struct ShadowStats {
    uint32_t individuals = 0;  // shadows drawn
    uint32_t blobs = 0;        // of these, as ellipses
    uint32_t shadow_only = 0;  // of these, shadow casters that are not drawn
    uint32_t draws = 0;        // glDrawElements calls
    uint32_t triangles = 0;    // sent to GL
    uint64_t vertices = 0;     // read from the caches
};

}  // namespace claque::passes
