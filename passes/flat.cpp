#include "passes/flat.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "passes/provoking.h"
#include "passes/welded.h"

namespace claque::passes
{
namespace
{

uint32_t nearest(float at, uint32_t size, model::Wrap wrap)
{
    const double texel = std::floor(static_cast<double>(at) * size);
    if (wrap == model::Wrap::clamp) return static_cast<uint32_t>(std::clamp(texel, 0.0, size - 1.0));
    return static_cast<uint32_t>(texel - std::floor(texel / size) * size);
}

// One texel per texture set: the first, and those that differ.
std::vector<const uint8_t *> texels_at(const model::Texture &texture, const float *uv)
{
    std::vector<const uint8_t *> texels;
    const auto add = [&](const auto &image) {
        const size_t x = nearest(uv[0], image.width, texture.wrap_s), y = nearest(uv[1], image.height, texture.wrap_t);
        texels.push_back(image.rgba.data() + 4 * (y * image.width + x));
    };
    add(texture);
    for (const model::TextureImage &other : texture.set_images) add(other);
    return texels;
}

class FlatMaker
{
public:
    FlatMaker(FlatLevel &out, const model::Template &source, const model::Level &level)
        : out_(out),
          texture_(source.textures[level.surfaces[0].texture]),
          level_(level),
          welded_(welded_vertices(level))
    {
    }

    void run()
    {
        out_.sets = 1 + static_cast<uint32_t>(texture_.set_images.size());
        const model::IndexRange all = level_.surfaces[0].fused;
        corners_.assign(level_.indices.begin() + all.first, level_.indices.begin() + all.first + all.count);
        std::vector<FlatTriangle> triangles;
        for (size_t i = 0; i < corners_.size(); i += 3) triangles.push_back(triangle_of(&corners_[i]));
        out_.indices.resize(corners_.size());
        for (const Provoking &end : provoking_vertices(triangles)) {
            const uint16_t vertex = add(end.vertex, static_cast<uint16_t>(end.colour_entry));
            for (const uint32_t t : end.triangles) turn(t, end.vertex, vertex);
        }
        for (size_t i = 0; i < corners_.size(); ++i)
            if (i % 3 != 2) out_.indices[i] = any(corners_[i]);
    }

private:
    glm::vec3 position(uint32_t vertex) const
    {
        const float *p = level_.positions.data() + 3 * size_t(vertex);
        return {p[0], p[1], p[2]};
    }

    FlatTriangle triangle_of(const uint32_t *corners)
    {
        FlatTriangle triangle;
        for (size_t k = 0; k < 3; ++k) triangle.vertices[k] = welded_[corners[k]];
        triangle.colour_entry = colour_entry_of(corners[0]);
        const glm::vec3 p = position(corners[0]);
        const glm::vec3 across = glm::cross(position(corners[1]) - p, position(corners[2]) - p);
        const float length = glm::length(across);
        if (length > 0) triangle.normal = across / length;
        return triangle;
    }

    uint16_t add(uint32_t vertex, uint16_t colour_entry)
    {
        const uint16_t at = static_cast<uint16_t>(out_.vertices.size());
        out_.vertices.push_back(static_cast<uint16_t>(vertex));
        out_.colour_entries.push_back(colour_entry);
        first_.emplace(vertex, at);
        return at;
    }

    // Rotates the corners until the triangle ends at this vertex.
    void turn(uint32_t triangle, uint32_t welded_vertex, uint16_t vertex)
    {
        uint32_t *corners = &corners_[3 * size_t(triangle)];
        while (welded_[corners[2]] != welded_vertex) std::rotate(corners, corners + 1, corners + 3);
        out_.indices[3 * size_t(triangle) + 2] = vertex;
    }

    uint16_t any(uint32_t vertex)
    {
        const auto found = first_.find(welded_[vertex]);
        return found != first_.end() ? found->second : add(welded_[vertex], 0);
    }

    uint16_t colour_entry_of(uint32_t vertex)
    {
        const uint32_t zone = texture_.keys[level_.slots[vertex] / 2].zone;
        std::vector<uint32_t> key = {zone};
        for (const uint8_t *texel : texels_at(texture_, level_.uvs.data() + 2 * size_t(vertex)))
            key.insert(key.end(), texel, texel + 3);
        const auto [found, is_new] = colour_entries_.emplace(key, static_cast<uint16_t>(out_.zones.size()));
        if (is_new) {
            out_.zones.push_back(zone);
            out_.rgb.insert(out_.rgb.end(), key.begin() + 1, key.end());
        }
        return found->second;
    }

    FlatLevel &out_;
    const model::Texture &texture_;
    const model::Level &level_;
    const std::vector<uint32_t> welded_;
    std::map<std::vector<uint32_t>, uint16_t> colour_entries_;
    std::map<uint32_t, uint16_t> first_;  // by welded vertex: its first vertex
    std::vector<uint32_t> corners_;       // as indices of the level
};

}  // namespace

void prepare_flat(PreparedLevel &out, const model::Template &source, const model::Level &level, uint32_t max_triangles)
{
    if (!out.batched || !shows_texels(level, max_triangles)) return;
    if (level.surfaces[0].lighting.emits()) return;
    FlatMaker(out.flat, source, level).run();
}

}  // namespace claque::passes
