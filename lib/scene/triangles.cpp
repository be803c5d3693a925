#include "lib/scene/triangles.h"

#include <glm/geometric.hpp>

#include "lib/model/texel_zone.h"

namespace claque::scene
{

namespace
{

using model::none;

class Search
{
public:
    Search(const draw::Item &item, const draw::Vertices &vertices, const Ray &ray)
        : item_(item), level_(item.tmpl->levels[item.level]), vertices_(vertices), ray_(ray)
    {
        hit_.distance = ray.length;
    }

    TriangleHit run()
    {
        for (const model::Surface &surface : level_.surfaces) {
            const uint32_t *parts = surface.part_offsets.empty() ? nullptr : surface.part_offsets.data();
            const auto next = [&](const model::IndexRange &range, uint32_t zone_index) {
                search(surface, range, parts, zone_index);
                if (parts) parts += level_.parts.size() + 1;
            };
            for (const model::Bin &bin : surface.clean) next(bin.range, bin.zone_index);
            next(surface.dirty, none);
        }
        return hit_;
    }

private:
    void search(const model::Surface &surface, const model::IndexRange &range, const uint32_t *parts,
                uint32_t zone_index)
    {
        const uint32_t count = parts ? static_cast<uint32_t>(level_.parts.size()) : 1;
        for (uint32_t part = 0; part < count; ++part) {
            if (!(item_.parts >> part & 1)) continue;
            const uint32_t first = parts ? parts[part] : 0, last = parts ? parts[part + 1] : range.count;
            for (uint32_t i = range.first + first; i < range.first + last; i += 3)
                test(surface, &level_.indices[i], part, zone_index);
        }
    }

    // Moeller and Trumbore 1997.
    void test(const model::Surface &surface, const uint32_t *corners, uint32_t part, uint32_t zone_index)
    {
        const glm::dvec3 a = glm::dvec3(vertices_.position(corners[0]));
        const glm::dvec3 ab = glm::dvec3(vertices_.position(corners[1])) - a,
                         ac = glm::dvec3(vertices_.position(corners[2])) - a;
        const glm::dvec3 p = glm::cross(ray_.direction, ac);
        const double volume = glm::dot(ab, p);
        if (volume == 0 || (volume < 0 && !surface.double_sided)) return;
        const glm::dvec3 from = ray_.origin - a, q = glm::cross(from, ab);
        const double v = glm::dot(from, p) / volume, w = glm::dot(ray_.direction, q) / volume;
        const double distance = glm::dot(ac, q) / volume;
        if (!(v >= 0 && w >= 0 && v + w <= 1 && distance >= 0 && distance <= hit_.distance)) return;
        if (hit_.found && distance == hit_.distance) return;
        TriangleHit made = {true, part, none, {corners[0], corners[1], corners[2]}, {1 - v - w, v, w}, distance};
        if (shows(surface, zone_index, made)) hit_ = made;
    }

    // Finds the zone. False: there is a hole.
    bool shows(const model::Surface &surface, uint32_t zone_index, TriangleHit &made) const
    {
        const model::Texture &texture = item_.tmpl->textures[surface.texture];
        if (zone_index != none && zone_index < texture.keys.size()) made.zone = texture.keys[zone_index].zone;
        if (zone_index != none && !texture.has_holes) return true;
        double uv[2] = {0, 0};
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 2; ++j)
                uv[j] += made.barycentric[k] * double(level_.uvs[2 * size_t(made.vertices[k]) + size_t(j)]);
        made.zone = model::texel_zone(texture, item_.texture_set, uv[0], uv[1]);
        return made.zone != none || !texture.has_holes;
    }

    const draw::Item &item_;
    const model::Level &level_;
    const draw::Vertices &vertices_;
    const Ray &ray_;
    TriangleHit hit_;
};

}  // namespace

TriangleHit first_triangle(const draw::Item &item, const draw::Vertices &vertices, const Ray &ray)
{
    return Search(item, vertices, ray).run();
}

}  // namespace claque::scene
