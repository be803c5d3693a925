#include "lib/model/skin_plan.h"

#include <algorithm>
#include <cstring>

#include "lib/model/template.h"

namespace claque::model
{

namespace
{

constexpr uint32_t least_block = 5;  // vertices; fewer are faster in pairs

// A chunk of vertices is skinned by sets if it has at most half as many sets as vertices.
constexpr uint32_t vertices_per_set = 2;

class Planner
{
public:
    explicit Planner(Level &level) : level_(level), plan_(level.skinning) {}

    void run()
    {
        for (const InfluenceRun &run : level_.runs) {
            run_ = &run;
            if (run.influences > max_block_influences) add_singles(0, run.count);
            else add_blocks();
        }
    }

private:
    // `v` counts from the first vertex of the run.
    const uint16_t *joints(uint32_t v) const
    {
        return level_.joints.data() + run_->first_influence + size_t(v) * run_->influences;
    }
    const float *weights(uint32_t v) const
    {
        return level_.weights.data() + run_->first_influence + size_t(v) * run_->influences;
    }

    SkinSegment segment(SkinMethod method, uint32_t first, uint32_t count) const
    {
        SkinSegment out;
        out.method = method;
        out.influences = run_->influences;
        out.first = run_->first + first, out.count = count;
        out.first_influence = run_->first_influence + first * run_->influences;
        return out;
    }

    uint32_t alike(uint32_t first) const
    {
        uint32_t count = 1;
        while (first + count < run_->count && same_entries(joints(first), joints(first + count), run_->influences))
            ++count;
        return count;
    }

    void add_blocks()
    {
        uint32_t loose = 0;  // the first vertex that is in no segment yet
        for (uint32_t v = 0, count; v < run_->count; v += count) {
            count = alike(v);
            const uint32_t in_blocks = worth_blocks(count);
            if (in_blocks == 0) continue;
            add_singles(loose, v);
            add_blocks_of(v, in_blocks);
            loose = v + in_blocks;
        }
        add_singles(loose, run_->count);
    }

    void add_blocks_of(uint32_t first, uint32_t count)
    {
        const bool goes_on = !plan_.segments.empty() && plan_.segments.back().method == SkinMethod::block &&
                             plan_.segments.back().influences == run_->influences &&
                             plan_.segments.back().first + plan_.segments.back().count == run_->first + first;
        if (!goes_on) {
            plan_.segments.push_back(segment(SkinMethod::block, first, 0));
            plan_.segments.back().first_item = static_cast<uint32_t>(plan_.blocks.size());
        }
        SkinSegment &to = plan_.segments.back();
        to.count += count;
        for (uint32_t v = first; v < first + count; v += lane_count) {
            add_block(v, std::min(lane_count, first + count - v));
            ++to.item_count;
        }
    }

    void add_block(uint32_t first, uint32_t count)
    {
        LaneBlock block;
        block.first = run_->first + first, block.count = count;
        block.first_lanes = static_cast<uint32_t>(plan_.lanes.size());
        std::copy_n(joints(first), run_->influences, block.joints);
        plan_.lanes.resize(plan_.lanes.size() + 6 + (run_->influences > 1 ? run_->influences : 0));
        Lanes *to = plan_.lanes.data() + block.first_lanes;
        for (uint32_t i = 0; i < count; ++i) {
            const size_t at = 3 * size_t(block.first + i);
            for (size_t k = 0; k < 3; ++k) {
                to[k].v[i] = level_.positions[at + k];
                to[3 + k].v[i] = level_.normals[at + k];
            }
            if (run_->influences == 1) continue;
            const bool changed_over = joints(first + i)[0] != block.joints[0];
            for (uint32_t k = 0; k < run_->influences; ++k) to[6 + k].v[i] = weights(first + i)[k];
            if (changed_over) std::swap(to[6].v[i], to[7].v[i]);
        }
        plan_.blocks.push_back(block);
    }

    // Vertices without blocks: in chunks of as many vertices as max_chunk_sets allows.
    void add_singles(uint32_t first, uint32_t end)
    {
        if (run_->influences == 1 && first < end) return add_vertices(first, end);
        while (first < end) {
            SkinSegment chunk = segment(SkinMethod::set, first, 0);
            chunk.first_item = static_cast<uint32_t>(plan_.set_joints.size());
            chunk.first_set_of = static_cast<uint32_t>(plan_.set_of.size());
            while (first < end && add_to_set(chunk, first)) ++first;
            if (chunk.item_count * vertices_per_set <= chunk.count) {
                plan_.segments.push_back(chunk);
            } else {
                forget(chunk);
                add_vertices(chunk.first - run_->first, first);
            }
        }
    }

    void add_vertices(uint32_t first, uint32_t end)
    {
        Array<SkinSegment> &to = plan_.segments;
        const bool goes_on = !to.empty() && to.back().method == SkinMethod::vertex &&
                             to.back().influences == run_->influences &&
                             to.back().first + to.back().count == run_->first + first;
        if (goes_on) to.back().count += end - first;
        else to.push_back(segment(SkinMethod::vertex, first, end - first));
    }

    // Returns false if the chunk has no room for the new set of this vertex.
    bool add_to_set(SkinSegment &chunk, uint32_t v)
    {
        const size_t joint_bytes = run_->influences * sizeof(uint16_t), weight_bytes = run_->influences * sizeof(float);
        uint32_t set = chunk.item_count;
        while (set-- > 0) {  // neighbours are more often equal
            const size_t at = chunk.first_item + size_t(set) * run_->influences;
            if (std::memcmp(&plan_.set_joints[at], joints(v), joint_bytes) == 0 &&
                std::memcmp(&plan_.set_weights[at], weights(v), weight_bytes) == 0)
                break;
        }
        if (set == none) {
            if (chunk.item_count == max_chunk_sets) return false;
            set = chunk.item_count++;
            plan_.set_joints.insert(plan_.set_joints.end(), joints(v), joints(v) + run_->influences);
            plan_.set_weights.insert(plan_.set_weights.end(), weights(v), weights(v) + run_->influences);
        }
        plan_.set_of.push_back(static_cast<uint16_t>(set));
        ++chunk.count;
        return true;
    }

    void forget(const SkinSegment &chunk)
    {
        plan_.set_joints.resize(chunk.first_item);
        plan_.set_weights.resize(chunk.first_item);
        plan_.set_of.resize(chunk.first_set_of);
    }

    Level &level_;
    SkinPlan &plan_;
    const InfluenceRun *run_ = nullptr;
};

}  // namespace

bool same_entries(const uint16_t *a, const uint16_t *b, uint32_t influences)
{
    const bool first_two =
        (a[0] == b[0] && (influences == 1 || a[1] == b[1])) || (influences > 1 && a[0] == b[1] && a[1] == b[0]);
    return first_two && (influences < 3 || std::equal(a + 2, a + influences, b + 2));
}

uint32_t worth_blocks(uint32_t count)
{
    const uint32_t rest = count % lane_count;
    return rest < least_block ? count - rest : count;
}

void plan_skinning(Level &level)
{
    level.skinning = SkinPlan(level.runs.get_allocator().resource());
    Planner(level).run();
}

}  // namespace claque::model
