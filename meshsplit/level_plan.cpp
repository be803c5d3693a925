#include "meshsplit/level_plan.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::meshsplit
{

using base::fail;
using model::none;
using model::Part;

namespace
{

class Planner
{
public:
    explicit Planner(const model::Model &model)
        : model_(model), stops_(model.rig.node_count()), roots_(model.rig.node_count())
    {
        const model::Rig &rig = model.rig;
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            stops_[i] = rig.deactivation_of(i);
            roots_[i] = rig.parents[i] == none ? i : roots_[rig.parents[i]];
            if (rig.parents[i] != none) stops_[i] = std::min(stops_[i], stops_[rig.parents[i]]);
        }
        for (uint32_t p = 0; p < model.parts.size(); ++p)
            if (model::is_drawn(model.parts[p])) drawn_.push_back(p);
        for (const uint32_t p : drawn_) rigid_nodes_.push_back(rigid_node(model.parts[p]));
    }

    std::vector<LevelPlan> run() const
    {
        for (size_t i = 0; i < drawn_.size(); ++i) check_part(i);
        std::vector<LevelPlan> plans;
        for (const float distance : distances()) plans.push_back(plan_at(distance));
        return plans;
    }

private:
    uint32_t rigid_node(const Part &part) const
    {
        const uint32_t entry = rigid_entry(part);
        return entry == none ? none : model_.rig.palette[entry].node;
    }

    static bool is_drawn_at(const Part &part, float distance)
    {
        return part.lod_min_m <= distance && distance < part.lod_max_m;
    }

    std::vector<float> distances() const
    {
        std::vector<float> out = {0};
        const auto add = [&](float distance) {
            if (distance > 0 && std::isfinite(distance)) out.push_back(distance);
        };
        for (const uint32_t p : drawn_) add(model_.parts[p].lod_min_m), add(model_.parts[p].lod_max_m);
        for (const float distance : model_.rig.deactivation_m) add(distance);
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        if (out.size() > max_levels)
            fail(CLQ_LIMIT, "model '%s' changes at %zu distances: a template can have %zu levels", model_.name.c_str(),
                 out.size() - 1, max_levels);
        return out;
    }

    LevelPlan plan_at(float distance) const
    {
        LevelPlan plan;
        plan.distance_m = distance;
        for (const float stop : stops_) plan.active.push_back(stop > distance);
        for (const uint32_t p : drawn_)
            if (is_drawn_at(model_.parts[p], distance)) plan.parts.push_back(p);
        return plan;
    }

    void check_part(size_t i) const
    {
        const Part &part = model_.parts[drawn_[i]];
        if (rigid_nodes_[i] == none) check_skinned(part);
        else check_rigid(part, rigid_nodes_[i]);
    }

    void check_rigid(const Part &part, uint32_t node) const
    {
        const float stop = stops_[node];
        if (part.lod_max_m > stop)
            fail(CLQ_ARGUMENT,
                 "model '%s': part '%s' is attached to node '%s', which stops at %g m%s, but is drawn from %g m "
                 "to %g m: the part must end where the node stops",
                 model_.name.c_str(), part.name.c_str(), name(node), double(stop), with_whom(node).c_str(),
                 double(part.lod_min_m), double(part.lod_max_m));
        if (part.lod_max_m == stop && something_from(stop) && !is_taken_over(stop))
            fail(CLQ_ARGUMENT,
                 "model '%s': part '%s' ends at %g m where node '%s' stops%s, and no part on an active node "
                 "begins at %g m: a part that takes over is missing",
                 model_.name.c_str(), part.name.c_str(), double(stop), name(node), with_whom(node).c_str(),
                 double(stop));
    }

    // Its vertices can move to ancestor nodes, unless there is none.
    void check_skinned(const Part &part) const
    {
        for (size_t k = 0; k < part.joints.size(); ++k) {
            if (part.weights[k] == 0) continue;
            const uint32_t root = roots_[model_.rig.palette[part.joints[k]].node];
            if (part.lod_max_m > stops_[root])
                fail(CLQ_ARGUMENT,
                     "model '%s': part '%s' is drawn to %g m and follows node '%s' or nodes below it, which is a root "
                     "and stops at %g m: no node remains for its vertices to follow",
                     model_.name.c_str(), part.name.c_str(), double(part.lod_max_m), name(root), double(stops_[root]));
        }
    }

    bool something_from(float distance) const
    {
        return std::any_of(drawn_.begin(), drawn_.end(),
                           [&](uint32_t p) { return model_.parts[p].lod_max_m > distance; });
    }

    bool is_taken_over(float distance) const
    {
        // A part that begins on a stopped node is refused by its own check.
        return std::any_of(drawn_.begin(), drawn_.end(),
                           [&](uint32_t p) { return model_.parts[p].lod_min_m == distance; });
    }

    const char *name(uint32_t node) const { return model_.rig.node_names[node].c_str(); }

    // Names the ancestor that stops a node, if it is not the node itself.
    std::string with_whom(uint32_t node) const
    {
        uint32_t cause = node;
        while (model_.rig.deactivation_of(cause) != stops_[node]) cause = model_.rig.parents[cause];
        return cause == node ? "" : base::text_of(" with '%s' above it", name(cause));
    }

    const model::Model &model_;
    std::vector<float> stops_;           // per node, including its ancestors
    std::vector<uint32_t> roots_;        // per node: the root above it
    std::vector<uint32_t> drawn_;        // parts that are visible at some distance
    std::vector<uint32_t> rigid_nodes_;  // per drawn part; none: skinned
};

}  // namespace

uint32_t rigid_entry(const Part &part)
{
    uint32_t entry = none;
    for (const auto &triangle : model::triangles_of(part))
        for (const uint32_t v : triangle)
            for (uint32_t k = 0; k < part.influence_count; ++k) {
                const size_t at = size_t(v) * part.influence_count + k;
                if (part.weights[at] == 0) continue;
                if (entry != none && part.joints[at] != entry) return none;
                entry = part.joints[at];
            }
    return entry;
}

std::vector<LevelPlan> plan_levels(const model::Model &model) { return Planner(model).run(); }

}  // namespace claque::meshsplit
