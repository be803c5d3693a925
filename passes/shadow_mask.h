// Shadows without a stencil bit. Triangles are rasterised here into a mask of the viewport's pixels, and new pixels go
// to GL as boxes of whole pixels on the ground. The edges of a box run between pixels, half a pixel from every centre,
// so that GL fills exactly these pixels once, however it rounds.
#pragma once

#include <glm/mat4x4.hpp>

#include "passes/shadow_batch.h"
#include "passes/shadow_plane.h"

namespace claque::passes
{

class ShadowMask
{
public:
    // The mask must have been reserved for these sizes.
    ShadowMask(const float *projection, int32_t width, int32_t height, ShadowArrays &arrays, ShadowBatch &batch);

    void add(const ShadowPlane &plane, const FlattenedMesh &flat);

private:
    void find_window(const FlattenedMesh &flat);
    void add_triangle(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c);
    void draw(const PixelBox &box);
    bool corner(double x, double y, double inner_x, double inner_y, glm::vec3 &out) const;

    glm::dmat4 projection_, inverse_;
    double nearest_w_;  // in clip space
    int32_t width_, height_;
    double slope_x_ = 0, slope_y_ = 0, middle_ = 0;  // of the ground's depth, for the current individual
    ShadowArrays &arrays_;
    ShadowBatch &batch_;
};

}  // namespace claque::passes
