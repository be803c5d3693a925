// A crowd on a field with views of it, for tests of whole updates.
#pragma once

#include <memory>

#include "figure.h"
#include "host.h"
#include "lib/frame/frame.h"

namespace claque::testing_support
{

struct SceneDef {
    uint32_t actors = 80;
    frame::Settings settings;
    glm::dvec3 origin = glm::dvec3(0);  // of the scene in the world
    std::pmr::memory_resource *memory = std::pmr::get_default_resource();
};

inline SceneDef people(uint32_t count, frame::Clock clock, uint32_t budget = 0)
{
    SceneDef def;
    def.actors = count;
    def.settings.clock = clock;
    def.settings.update_budget = budget;
    def.settings.caches.can_defer = budget > 0;
    return def;
}

// Two templates, every clip, speeds forwards and backwards, colours of all three kinds, some mirrored; from 2 to 70 m
// in front of an eye at the origin.
class Scene
{
public:
    explicit Scene(const SceneDef &def = {});

    // The update must succeed; returns the hash of all views' lists.
    uint64_t update(double time_s, const base::Jobs &jobs = base::Jobs());
    base::Status try_update(double time_s, const base::Jobs &jobs = base::Jobs());
    uint64_t hash() const;
    frame::View &add_view(const glm::dvec3 &eye, const glm::dvec3 &target);  // both relative to the scene's origin
    void look(uint32_t view, const glm::dvec3 &eye, const glm::dvec3 &target);

    std::unique_ptr<model::Template> templates[2];
    crowd::Crowd crowd;
    frame::Frame frame;
    std::vector<std::unique_ptr<frame::View>> views;  // one at first
    std::vector<crowd::Id> ids;

private:
    SceneDef def_;
};

}  // namespace claque::testing_support
