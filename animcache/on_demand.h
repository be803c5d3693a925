// Serves, at draw time, the vertices of individuals that found no room in the caches: the same bits, made anew into
// memory of its own. One per view.
#pragma once

#include "animcache/caches.h"

namespace claque::animcache
{

class OnDemand : public draw::VertexServer
{
public:
    explicit OnDemand(std::pmr::memory_resource *memory) : scratch_(memory, 1), vertices_(memory) {}

    // std::bad_alloc: as it was.
    void reserve(base::Span<const model::Template *const> templates, const Settings &settings);
    // `caches` must live as long as lists that were made from its last update are drawn.
    void attach(const Caches &caches) { caches_ = &caches; }

    draw::Vertices serve(const draw::Item &item) override;
    draw::Pose pose(const draw::Item &item) override;

private:
    const Caches *caches_ = nullptr;
    ScratchPool scratch_;
    std::pmr::vector<float> vertices_;
};

}  // namespace claque::animcache
