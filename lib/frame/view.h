// An eye on a crowd, and the draw list that the last update made for it.
#pragma once

#include <claque/crowd.h>

#include "animcache/on_demand.h"
#include "lib/draw/draw_list.h"

namespace claque::frame
{

struct Camera {
    glm::dvec3 eye = glm::dvec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);                               // world to eye: looks along -z with y up
    float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // column-major
};

// From an eye, a point it looks at and an up direction; a symmetric perspective. Throws base::Error (CLQ_ARGUMENT).
Camera look_at(const glm::dvec3 &eye, const glm::dvec3 &target, const glm::vec3 &up, float fov_y_rad, float aspect,
               float z_near, float z_far);

// A host's callbacks as the drawing calls them; `user` of the latter points at this.
struct Hooked {
    clq_actor_hooks host;
    draw::Hooks hooks;
};

// list.server points into the view: a View stays where it is.
struct View {
    explicit View(std::pmr::memory_resource *memory)
        : list(memory), server(memory), colours(memory), grown(memory), hooked(memory)
    {
    }
    View(const View &) = delete;
    View &operator=(const View &) = delete;

    Camera camera;          // for the next update
    float height_px = 768;  // of the picture: how much detail a distance deserves (S0 5); 0: distances as they are
    float cull_scale = 1;   // (0, 1]: of the pyramid that culls, against that of the picture (S0 Fig. 10)
    glm::vec3 shadow = glm::vec3(0);  // world units: how far and whither shadows fall; zero: there are none

    draw::DrawList list;         // of the last update
    animcache::OnDemand server;  // skins at draw time who found no room in the caches

    // Own colours of those in the list, as the update found them: a host may change them, or give the memory to
    // another individual, before it draws. `grown` is the next list's memory where this one's is too small.
    model::Array<uint8_t> colours, grown;
    model::Array<Hooked> hooked;  // of those in the list that have callbacks
};

// Of the list with all matrices, colours and vertices: equal lists draw equal pictures. Asks the server for what no
// cache holds, so it is for one thread a view.
uint64_t hash(const draw::DrawList &list);

uint64_t triangle_count(const draw::DrawList &list);  // each triangle once

}  // namespace claque::frame
