#include "passes/linear_clean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "passes/linear_footprint.h"
#include "passes/parts.h"

namespace claque::passes
{
namespace
{

using Corners = std::array<uint32_t, 3>;
constexpr int samples_an_edge = 9;

glm::vec2 uv_of(const model::Level &level, uint32_t vertex)
{
    return {level.uvs[2 * size_t(vertex)], level.uvs[2 * size_t(vertex) + 1]};
}

// The source vertices of a triangle of any stream.
Corners source_of(const model::Level &level, uint32_t first_index)
{
    Corners out;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = level.indices[first_index + k];
        out[k] = v < level.source_count ? v : level.copies[v - level.source_count];
    }
    return out;
}

// Splits each surface of a level in two: triangles that can be filtered, and the rest.
class Splitter
{
public:
    Splitter(const model::Template &source, const model::Level &level, model::Level &out, Array<uint8_t> &linear,
             LuminanceStep &step)
        : source_(source), level_(level), out_(out), linear_(linear), step_(step)
    {
    }

    void run()
    {
        out_.source_count = level_.source_count, out_.vertex_count = level_.vertex_count;
        out_.copies = level_.copies, out_.uvs = level_.uvs, out_.colours = level_.colours, out_.slots = level_.slots;
        out_.parts = level_.parts;
        for (const model::Surface &surface : level_.surfaces) {
            const LinearFootprint footprint(source_.textures[surface.texture]);
            find_filtered(surface, footprint);
            measure(surface, footprint);
            for (const bool filtered : {true, false}) add(surface, filtered);
        }
    }

private:
    void find_filtered(const model::Surface &surface, const LinearFootprint &footprint)
    {
        filtered_.clear();
        for (const model::Bin &bin : surface.clean)
            for (uint32_t i = bin.range.first; i < bin.range.first + bin.range.count; i += 3) {
                const Corners corners = source_of(level_, i);
                const glm::vec2 uv[3] = {uv_of(level_, corners[0]), uv_of(level_, corners[1]),
                                         uv_of(level_, corners[2])};
                if (footprint.has_one_zone(uv)) filtered_.insert(corners);
            }
        step_.linear_triangles += static_cast<uint32_t>(filtered_.size());
    }

    // Edges of the first level that a filtered and an unfiltered triangle share.
    void measure(const model::Surface &surface, const LinearFootprint &footprint)
    {
        std::map<std::pair<uint32_t, uint32_t>, int> kinds;  // bit 0: filtered, bit 1: unfiltered
        const auto count_edges = [&](model::IndexRange range) {
            for (uint32_t i = range.first; i < range.first + range.count; i += 3) {
                const Corners c = source_of(level_, i);
                ++step_.triangles;
                for (size_t k = 0; k < 3; ++k) kinds[std::minmax(c[k], c[(k + 1) % 3])] |= filtered_.count(c) ? 1 : 2;
            }
        };
        for (const model::Bin &bin : surface.clean) count_edges(bin.range);
        count_edges(surface.dirty);
        for (const auto &[edge, kind] : kinds) {
            if (kind != 3) continue;
            const glm::vec2 a = uv_of(level_, edge.first), b = uv_of(level_, edge.second);
            double sum = 0, max = 0;
            for (int s = 0; s < samples_an_edge; ++s) {
                const float t = (float(s) + 0.5f) / samples_an_edge;
                const double off = std::fabs(footprint.linear(a + t * (b - a)) - footprint.nearest(a + t * (b - a)));
                sum += off, max = std::fmax(max, off);
            }
            step_.mean += (static_cast<float>(sum / samples_an_edge) - step_.mean) / float(++step_.edges);
            step_.max = std::fmax(step_.max, static_cast<float>(max));
        }
    }

    // The triangles of a slice that belong to one of the two, part by part.
    model::IndexRange take(const IndexSlice &slice, bool filtered, std::vector<uint32_t> &firsts)
    {
        const uint32_t begin = static_cast<uint32_t>(out_.indices.size());
        for (uint32_t part = 0; part < part_count_of(level_); ++part) {
            firsts.push_back(static_cast<uint32_t>(out_.indices.size()) - begin);
            const model::IndexRange share = part_of(slice, part);
            for (uint32_t i = share.first; i < share.first + share.count; i += 3)
                if ((filtered_.count(source_of(level_, i)) != 0) == filtered)
                    out_.indices.insert(out_.indices.end(), level_.indices.begin() + i, level_.indices.begin() + i + 3);
        }
        firsts.push_back(static_cast<uint32_t>(out_.indices.size()) - begin);
        return {begin, static_cast<uint32_t>(out_.indices.size()) - begin};
    }

    void add(const model::Surface &from, bool filtered)
    {
        const IndexSlices slices(level_, from);
        model::Surface made(out_.surfaces.get_allocator().resource());
        made.texture = from.texture, made.double_sided = from.double_sided, made.lighting = from.lighting;
        std::vector<uint32_t> firsts;
        for (size_t bin = 0; bin < from.clean.size(); ++bin)
            made.clean.push_back({from.clean[bin].zone_index, take(slices.clean(bin), filtered, firsts)});
        made.dirty = take(slices.dirty(), filtered, firsts);
        for (size_t bin = 0; bin < from.dirty_by_zone.size(); ++bin)
            made.dirty_by_zone.push_back(
                {from.dirty_by_zone[bin].zone_index, take(slices.by_zone(bin), filtered, firsts)});
        made.fused = take(slices.fused(), filtered, firsts);
        if (made.fused.count == 0) return;
        if (!from.part_offsets.empty()) made.part_offsets.assign(firsts.begin(), firsts.end());
        out_.surfaces.push_back(std::move(made));
        linear_.push_back(filtered);
    }

    const model::Template &source_;
    const model::Level &level_;
    model::Level &out_;
    Array<uint8_t> &linear_;
    LuminanceStep &step_;
    std::set<Corners> filtered_;  // of the current surface
};

}  // namespace

void prepare_linear_clean(PreparedLevel &out, const model::Template &source, const model::Level &level,
                          LuminanceStep &step)
{
    model::Level &made = out.filtered.emplace_back(out.filtered.get_allocator().resource());
    Splitter(source, level, made, out.linear, step).run();
}

}  // namespace claque::passes
