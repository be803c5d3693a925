#include "lib/figures/canvas.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::figures
{

namespace
{

constexpr int size = texture_size;

struct Cover {
    bool covered = false;
    Texel texel;
};

size_t at(int x, int y) { return static_cast<size_t>(y) * size + static_cast<size_t>(x); }

float cross2(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

void cover(const Mesh &mesh, const std::vector<glm::vec3> &normals, const Face &face, std::vector<Cover> &covers)
{
    glm::vec2 uv[3];
    for (size_t k = 0; k < 3; ++k) uv[k] = face.corners[k].uv * static_cast<float>(size);
    const float area = cross2(uv[1] - uv[0], uv[2] - uv[0]);
    if (std::fabs(area) < 1e-6f) return;
    const glm::vec2 low = glm::min(uv[0], glm::min(uv[1], uv[2])), high = glm::max(uv[0], glm::max(uv[1], uv[2]));
    const int x0 = std::max(0, static_cast<int>(low.x)), x1 = std::min(size - 1, static_cast<int>(high.x) + 1);
    const int y0 = std::max(0, static_cast<int>(low.y)), y1 = std::min(size - 1, static_cast<int>(high.y) + 1);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const glm::vec2 c(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float a = cross2(uv[1] - c, uv[2] - c) / area, b = cross2(uv[2] - c, uv[0] - c) / area;
            const float d = 1 - a - b;
            if (a < -1e-4f || b < -1e-4f || d < -1e-4f) continue;
            const auto blend = [&](const auto &of) {
                return of(face.corners[0].point) * a + of(face.corners[1].point) * b + of(face.corners[2].point) * d;
            };
            Cover &out = covers[at(x, y)];
            out.covered = true;
            const Point &first = mesh.points[face.corners[0].point];
            out.texel.position = blend([&](uint32_t i) { return mesh.points[i].position; });
            out.texel.normal = glm::normalize(blend([&](uint32_t i) { return normals[i]; }));
            out.texel.chart = face.chart;
            out.texel.region = first.region;
            out.texel.side = first.side;
            out.texel.st = face.corners[0].st * a + face.corners[1].st * b + face.corners[2].st * d;
        }
}

// Ambient visibility is smooth: it is computed at every fourth texel of a chart and interpolated.
void shade(const AmbientVisibility &ambient_visibility, std::vector<Cover> &covers)
{
    constexpr int pitch = 4;
    struct Sample {
        float value = -1;
        Chart chart = Chart::head;
    };
    std::vector<Sample> sampled(covers.size());
    for (int y = 0; y < size; y += pitch)
        for (int x = 0; x < size; x += pitch) {
            // The first covered texel of each cell and chart represents the cell.
            for (int i = 0; i < pitch * pitch; ++i) {
                const size_t k = at(x + i % pitch, y + i / pitch);
                if (!covers[k].covered) continue;
                sampled[at(x, y)] = {ambient_visibility(covers[k].texel.position, covers[k].texel.normal),
                                     covers[k].texel.chart};
                break;
            }
        }
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Cover &c = covers[at(x, y)];
            if (!c.covered) continue;
            float sum = 0, weight = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int cx = x / pitch + dx, cy = y / pitch + dy;
                    if (cx < 0 || cy < 0 || cx >= size / pitch || cy >= size / pitch) continue;
                    const Sample &sample = sampled[at(cx * pitch, cy * pitch)];
                    if (sample.value < 0 || sample.chart != c.texel.chart) continue;
                    const float ux = (static_cast<float>(x) + 0.5f) / pitch - (static_cast<float>(cx) + 0.5f);
                    const float uy = (static_cast<float>(y) + 0.5f) / pitch - (static_cast<float>(cy) + 0.5f);
                    const float w = std::max(0.0f, 1.5f - std::fabs(ux)) * std::max(0.0f, 1.5f - std::fabs(uy));
                    sum += w * sample.value;
                    weight += w;
                }
            c.texel.ambient_visibility = weight > 0 ? sum / weight : 1;
        }
}

// Every texel takes the bytes of the nearest painted one, by rings that grow until every texel is filled.
void fill_gutters(const std::vector<Cover> &covers, std::vector<uint8_t> &rgba)
{
    std::vector<uint32_t> front, next;
    std::vector<uint8_t> filled(covers.size(), 0);
    for (uint32_t i = 0; i < covers.size(); ++i)
        if (covers[i].covered) filled[i] = 1, front.push_back(i);
    while (!front.empty()) {
        next.clear();
        for (const uint32_t i : front) {
            const int x = static_cast<int>(i) % size, y = static_cast<int>(i) / size;
            for (const auto &[dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const int nx = x + dx, ny = y + dy;
                if (nx < 0 || ny < 0 || nx >= size || ny >= size || filled[at(nx, ny)]) continue;
                const size_t to = at(nx, ny);
                filled[to] = 1;
                for (size_t k = 0; k < 4; ++k) rgba[4 * to + k] = rgba[4 * size_t(i) + k];
                next.push_back(static_cast<uint32_t>(to));
            }
        }
        front.swap(next);
    }
}

model::Image image_of(const std::vector<Cover> &covers, const Painter &painter, const Zones &zones)
{
    model::Image image;
    image.width = image.height = size;
    image.alpha = model::AlphaMeaning::zone_keys;
    image.rgba.assign(size_t(4) * size * size, 255);
    for (size_t i = 0; i < covers.size(); ++i) {
        if (!covers[i].covered) continue;
        const Paint p = painter(covers[i].texel);
        const uint8_t grey = static_cast<uint8_t>(std::clamp(p.luminance, 0.0f, 255.0f) + 0.5f);
        for (size_t k = 0; k < 3; ++k) image.rgba[4 * i + k] = grey;
        image.rgba[4 * i + 3] = key_of(zones, p.zone);
    }
    fill_gutters(covers, image.rgba);
    return image;
}

}  // namespace

std::vector<model::Image> paint(const Mesh &mesh, const AmbientVisibility &ambient_visibility,
                                const std::vector<Painter> &painters, const Zones &zones)
{
    const std::vector<glm::vec3> normals = mesh.smooth_normals();
    std::vector<Cover> covers(size_t(size) * size);
    for (const Face &face : mesh.faces) cover(mesh, normals, face, covers);
    shade(ambient_visibility, covers);
    std::vector<model::Image> images;
    for (const Painter &painter : painters) images.push_back(image_of(covers, painter, zones));
    return images;
}

}  // namespace claque::figures
