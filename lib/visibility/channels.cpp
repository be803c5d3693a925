#include "lib/visibility/channels.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "lib/model/texel_zone.h"
#include "lib/visibility/corners.h"

namespace claque::visibility
{
namespace
{

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// The triangle of the pixel before, which the next one often shows too.
struct Shown {
    uint64_t number = ~uint64_t(0);
    Found found;
    Corners corners;
    glm::dvec3 normals[3] = {};  // in eye space, towards the seen side
};

class Writer
{
public:
    Writer(const Picture &picture, double metres_per_unit, const clq_pixel_channels &out)
        : picture_(picture), metres_per_unit_(metres_per_unit), out_(out)
    {
    }

    void write(size_t pixel, Shown &shown) const
    {
        uint64_t number = 0;
        if (!picture_.number_at(pixel, number)) return write_nothing(pixel);
        if (number != shown.number) begin(number, shown);
        const draw::Item &item = picture_.list.items[shown.found.item];
        if (out_.individuals) out_.individuals[pixel] = shown.found.item;
        if (out_.actors) out_.actors[pixel] = item.actor_index + 1;
        if (out_.parts) out_.parts[pixel] = shown.found.part;
        if (out_.triangles) out_.triangles[pixel] = shown.found.triangle;
        const bool points = out_.barycentric || out_.depth_m || out_.positions || out_.normals || out_.zones;
        if (!points) return;
        const glm::dvec3 weights = shown.corners.weights_at(picture_.centre(pixel), picture_.half());
        if (out_.zones)
            out_.zones[pixel] = shown.found.zone != model::none ? shown.found.zone : zone_of(shown.found, weights);
        write_point(pixel, shown, weights);
    }

private:
    void begin(uint64_t number, Shown &shown) const
    {
        shown.number = number;
        shown.found = picture_.numbers.find(number);
        const draw::Item &item = picture_.list.items[shown.found.item];
        const draw::Vertices &vertices = picture_.vertices[shown.found.item];
        shown.corners = corners_of(picture_.list, item, vertices, shown.found.corners);
        if (!out_.normals) return;
        const float *m = item.model_view;
        const double side = shown.corners.faces_away(item.mirrored) ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 n = side * glm::dvec3(vertices.normal(shown.found.corners[k]));
            for (int i = 0; i < 3; ++i)
                shown.normals[k][i] = double(m[i]) * n.x + double(m[4 + i]) * n.y + double(m[8 + i]) * n.z;
            shown.normals[k] = glm::normalize(shown.normals[k]);
        }
    }

    uint32_t zone_of(const Found &found, const glm::dvec3 &weights) const
    {
        if (std::isnan(weights.x)) return model::none;  // seen edge on
        const draw::Item &item = picture_.list.items[found.item];
        const model::Level &level = item.tmpl->levels[item.level];
        double uv[2] = {0, 0};
        for (int k = 0; k < 3; ++k)
            for (size_t j = 0; j < 2; ++j) uv[j] += weights[k] * double(level.uvs[2 * size_t(found.corners[k]) + j]);
        return model::texel_zone(item.tmpl->textures[found.texture], item.texture_set, uv[0], uv[1]);
    }

    glm::dvec3 to_world(const glm::dvec3 &eye) const
    {
        const double *w = picture_.list.world_to_eye;
        return {w[0] * eye.x + w[1] * eye.y + w[2] * eye.z, w[3] * eye.x + w[4] * eye.y + w[5] * eye.z,
                w[6] * eye.x + w[7] * eye.y + w[8] * eye.z};
    }

    void write_point(size_t pixel, const Shown &shown, const glm::dvec3 &weights) const
    {
        if (out_.barycentric)
            for (size_t k = 0; k < 3; ++k)
                out_.barycentric[3 * pixel + k] = static_cast<float>(weights[static_cast<int>(k)]);
        const auto mean = [&](const glm::dvec3 *of) {
            return weights.x * of[0] + weights.y * of[1] + weights.z * of[2];
        };
        const glm::dvec3 eye = mean(shown.corners.eye);
        if (out_.depth_m) out_.depth_m[pixel] = static_cast<float>(-eye.z * metres_per_unit_);
        if (out_.positions) {
            const glm::dvec3 at = to_world(eye);
            for (int k = 0; k < 3; ++k) out_.positions[3 * pixel + size_t(k)] = picture_.list.eye[k] + at[k];
        }
        if (out_.normals) {
            const glm::dvec3 normal = to_world(glm::normalize(mean(shown.normals)));
            for (int k = 0; k < 3; ++k) out_.normals[3 * pixel + size_t(k)] = static_cast<float>(normal[k]);
        }
    }

    void write_nothing(size_t pixel) const
    {
        for (uint32_t *of : {out_.individuals, out_.parts, out_.zones, out_.triangles})
            if (of) of[pixel] = model::none;
        if (out_.actors) out_.actors[pixel] = 0;
        if (out_.depth_m) out_.depth_m[pixel] = nan;
        for (size_t k = 0; k < 3; ++k) {
            if (out_.barycentric) out_.barycentric[3 * pixel + k] = nan;
            if (out_.positions) out_.positions[3 * pixel + k] = double(nan);
            if (out_.normals) out_.normals[3 * pixel + k] = nan;
        }
    }

    const Picture &picture_;
    double metres_per_unit_;
    const clq_pixel_channels &out_;
};

}  // namespace

void write_channels(const Picture &picture, double metres_per_unit, const base::Jobs &jobs,
                    const clq_pixel_channels &out)
{
    const Writer writer(picture, metres_per_unit, out);
    picture.for_rows(jobs, [&](size_t first, size_t last) {
        Shown shown;
        for (size_t pixel = first; pixel < last; ++pixel) writer.write(pixel, shown);
    });
}

}  // namespace claque::visibility
