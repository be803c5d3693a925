// What a ray meets first in the picture of a view: the triangles of its draw list, as they are drawn.
#pragma once

#include "lib/draw/vertex_source.h"
#include "lib/scene/questions.h"

namespace claque::scene
{

struct Pick {
    uint32_t item = model::none;  // of the draw list; none: the ray meets nothing
    uint32_t part = 0;            // of the level
    uint32_t zone = model::none;  // none: the surface has no zones
    uint32_t vertices[3] = {0, 0, 0};
    double barycentric[3] = {0, 0, 0};
    double distance = 0;
};

struct Picture {
    const draw::DrawList &list;
    const void *view;  // as Scene::show was given it
    draw::VertexSource &source;
};

// Finds the nearest triangle of an individual that still exists and matches the filter. Equal distances: the lower row.
// Where the index is that of the list, the work follows what the ray meets; otherwise each item of the list is tested.
Pick pick(const Asked &asked, const Picture &picture, const Ray &ray);

}  // namespace claque::scene
