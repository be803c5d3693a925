// The pose and vertices of an individual that drawing does not need: its parts are placed by GL's matrix stack, or it
// shows a kept key-pose. For queries by hosts; allocates when it is made.
#pragma once

#include "animcache/scratch.h"

namespace claque::animcache
{

class Inspection
{
public:
    Inspection(std::pmr::memory_resource *memory, const model::Template &tmpl, VertexFormat vertex_format);

    // Results are valid until the next call. The request is one of the last update, with its matrices.
    draw::Pose pose(const Request &request);          // null palette: it shows two key-poses blended
    draw::Vertices vertices(const Request &request);  // requires a palette
private:
    VertexFormat vertex_format_;
    ScratchPool scratch_;
    std::pmr::vector<float> vertices_;
};

}  // namespace claque::animcache
