#include "passes/close_prepare.h"

#include <algorithm>

#include "passes/close_cover.h"
#include "passes/close_distance.h"
#include "passes/close_image.h"
#include "passes/parts.h"

namespace claque::passes
{
namespace
{

glm::vec2 corner_uv(const model::Level &level, uint32_t vertex)
{
    return {level.uvs[2 * size_t(vertex)], level.uvs[2 * size_t(vertex) + 1]};
}

class ClosePreparer
{
public:
    ClosePreparer(PreparedTemplate &out, const RendererOptions &options)
        : out_(out), source_(*out.source), memory_(out.levels.get_allocator().resource()), options_(options)
    {
    }

    void run()
    {
        for (uint32_t i = 0; i < source_.textures.size(); ++i) prepare_texture(i);
        for (size_t i = 0; i < out_.levels.size(); ++i) prepare_level(out_.levels[i], source_.levels[i]);
        const auto shows = [](const PreparedLevel &level) { return level.shows_close; };
        if (std::none_of(out_.levels.begin(), out_.levels.end(), shows)) return;
        out_.close_distance_m = options_.close_distance_m > 0 ? options_.close_distance_m : close_distance(out_);
    }

private:
    // Calls visit(uv) for every triangle that single individuals show with this texture.
    template <class Visit>
    void for_triangles(uint32_t texture, Visit visit) const
    {
        for (size_t i = 0; i < out_.levels.size(); ++i) {
            const model::Level &level = source_.levels[i];
            if (out_.levels[i].batched) continue;
            const auto visit_range = [&](model::IndexRange range) {
                for (uint32_t k = range.first; k < range.first + range.count; k += 3) {
                    const glm::vec2 uv[3] = {corner_uv(level, level.indices[k]), corner_uv(level, level.indices[k + 1]),
                                             corner_uv(level, level.indices[k + 2])};
                    visit(uv);
                }
            };
            for (const model::Surface &surface : level.surfaces) {
                if (surface.texture != texture) continue;
                for (const model::Bin &bin : surface.clean) visit_range(bin.range);
                visit_range(surface.dirty);
            }
        }
    }

    // False if a triangle comes within half a texel of an edge that clamps.
    bool keeps_from_edges(uint32_t texture, uint32_t width, uint32_t height) const
    {
        const model::Texture &from = source_.textures[texture];
        const auto inside = [](float at, uint32_t size, model::Wrap wrap) {
            const float half = 0.5f / static_cast<float>(size);
            return wrap == model::Wrap::repeat || (at >= half && at <= 1 - half);
        };
        bool kept = true;
        for_triangles(texture, [&](const glm::vec2(&uv)[3]) {
            for (const glm::vec2 &at : uv)
                kept = kept && inside(at.x, width, from.wrap_s) && inside(at.y, height, from.wrap_t);
        });
        return kept;
    }

    template <class Image>
    bool prepare_image(uint32_t texture, const Image &from)
    {
        CloseImage &image = out_.textures[texture].close.emplace_back(memory_);
        image.width = from.width, image.height = from.height;
        image.bytes = close_bytes_of(from.width, from.height);
        if (image.bytes > options_.close_bytes || !keeps_from_edges(texture, from.width, from.height)) return false;
        const model::Texture &wraps = source_.textures[texture];
        CloseCover cover(from.width, from.height, wraps.wrap_s, wraps.wrap_t, memory_);
        for_triangles(texture, [&](const glm::vec2(&uv)[3]) { cover.add(uv); });
        const size_t texels = size_t(from.width) * from.height;
        const auto is_hole = [&](size_t i) { return wraps.has_holes && from.rgba[4 * i + 3] == 0; };
        std::vector<uint32_t> holes;
        for (uint32_t i = 0; i < texels; ++i)
            if (is_hole(i) && cover.shows(i)) holes.push_back(i), cover.leave_out(i);
        image.sources = cover.sources();
        for (const uint32_t i : holes) image.sources[i] |= CloseImage::hole;
        return true;
    }

    void prepare_texture(uint32_t texture)
    {
        const model::Texture &from = source_.textures[texture];
        bool usable = prepare_image(texture, from);
        for (size_t i = 0; i < from.set_images.size() && usable; ++i)
            usable = prepare_image(texture, from.set_images[i]);
        if (!usable) out_.textures[texture].close.clear();
    }

    void prepare_level(PreparedLevel &out, const model::Level &level) const
    {
        // In a close texture emission would take the colours of zones.
        const auto has_none = [&](const model::Surface &s) {
            return out_.textures[s.texture].close.empty() || s.lighting.emits();
        };
        out.shows_close = !out.plain.empty() && std::none_of(level.surfaces.begin(), level.surfaces.end(), has_none);
    }

    PreparedTemplate &out_;
    const model::Template &source_;
    std::pmr::memory_resource *memory_;
    const RendererOptions &options_;
};

}  // namespace

void prepare_close(PreparedTemplate &out, const RendererOptions &options) { ClosePreparer(out, options).run(); }

}  // namespace claque::passes
