// What a picture of individuals shows, by one ray a pixel through all triangles: a second implementation, in double
// precision, that shares nothing with the library.
#pragma once

#include <claque/visibility.h>

#include <array>
#include <vector>

namespace visibility_test
{

using Point = std::array<double, 3>;

// The triangles of an individual of the draw list, in eye space.
struct Body {
    clq_drawn_actor drawn = clq_drawn_actor_init();
    struct Triangle {
        std::array<uint32_t, 3> corners;
        std::array<Point, 3> eye;
        uint32_t zone;  // CLQ_NONE: several
        bool double_sided;
    };
    std::vector<Triangle> triangles;  // in the order of clq_template_get_triangles
};
std::vector<Body> bodies_of(const clq_view *view);

struct Hit {
    uint32_t body = CLQ_NONE, triangle = 0;
    Point weights = {0, 0, 0}, eye = {0, 0, 0};
    double window_depth = 1;  // [0, 1] as GL's depth buffer
    // Pixels from the nearest edge of any triangle that is at most as far away; and the smallest difference to another
    // triangle's depth here.
    double edge_px = 1e9, step = 1e9;
};
Hit hit_at(const std::vector<Body> &bodies, const clq_camera &camera, int width, int height, int x, int y);

// An eye space point in the picture, in pixels from the lower left corner.
std::array<double, 2> pixel_of(const clq_camera &camera, int width, int height, const Point &eye);

}  // namespace visibility_test
