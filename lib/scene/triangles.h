// The first triangle of one drawn individual that a ray meets.
#pragma once

#include "lib/draw/draw_list.h"
#include "lib/scene/questions.h"

namespace claque::scene
{

struct TriangleHit {
    bool found = false;
    uint32_t part = 0, zone = model::none;
    uint32_t vertices[3] = {0, 0, 0};
    double barycentric[3] = {0, 0, 0};
    double distance = 0;  // in lengths of the ray's direction
};

// As drawing shows it: without parts that phase 3 left out, backs of single-sided surfaces, and holes. The ray is in
// the individual's own space.
TriangleHit first_triangle(const draw::Item &item, const draw::Vertices &vertices, const Ray &ray);

}  // namespace claque::scene
