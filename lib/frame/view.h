// A camera on a crowd, and the draw list that the last update made for it.
#pragma once

#include <claque/crowd.h>

#include "lib/base/held_bytes.h"
#include "lib/draw/draw_list.h"

namespace claque::frame
{

struct Camera {
    glm::dvec3 eye = glm::dvec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);                               // world to eye: looks along -z with y up
    float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // column-major
};

// From an eye, a point to look at and an up direction; a symmetric perspective. Throws base::Error (CLQ_ARGUMENT).
Camera look_at(const glm::dvec3 &eye, const glm::dvec3 &target, const glm::vec3 &up, float fov_y_rad, float aspect,
               float z_near, float z_far);

// A host's callbacks in the form that drawing calls; `user` of the latter points at this.
struct Hooked {
    clq_actor_hooks host;
    draw::Hooks hooks;
};

// The list points into the view, so a View must not move.
struct View {
    explicit View(std::pmr::memory_resource *memory) : list(memory), colours(memory), grown(memory), hooked(memory) {}
    View(const View &) = delete;
    View &operator=(const View &) = delete;

    Camera camera;          // for the next update
    float height_px = 768;  // of the picture: scales the distances of levels (S0 5); 0: they are taken as they are
    float cull_scale = 1;   // (0, 1]: size of the frustum for culling, relative to that of the picture (S0 Fig. 10)
    // What of the picture is drawn: left, bottom, right, top as shares of its size from the lower left corner. It
    // narrows the frustum for culling; nothing else depends on it.
    float tile[4] = {0, 0, 1, 1};
    glm::vec3 shadow = glm::vec3(0);  // world units: length and direction of shadows; zero: no shadows

    draw::DrawList list;  // of the last update

    // Colours of the listed individuals, copied in the update: before the draw a host may change them or give their
    // memory to another individual. `grown` is the next list's memory when this one is too small.
    model::Array<uint8_t> colours, grown;
    model::Array<Hooked> hooked;  // of listed individuals with callbacks

    uint64_t bytes() const { return base::held_bytes(list.items, colours, grown, hooked); }
};

// A hash of the list with all matrices, colours and vertices: equal lists draw equal pictures.
uint64_t hash(const draw::DrawList &list);

uint64_t triangle_count(const draw::DrawList &list);  // counts each triangle once

}  // namespace claque::frame
