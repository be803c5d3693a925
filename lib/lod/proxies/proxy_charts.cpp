// bake_charts: the image of a finer proxy, laid out in charts (proxy_image.h).
#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/proxies/atlas.h"
#include "lib/lod/proxies/proxy_balance.h"
#include "lib/lod/proxies/proxy_image.h"
#include "lib/lod/surface/nearest.h"
#include "lib/model/model_size.h"

namespace claque::lod
{

namespace
{

// A level of `full_triangles` or fewer gets all its texels. A level of more gets as many in all: where it begins, it is
// no larger in the picture than a few thousand pixels.
constexpr uint32_t texels_per_triangle = 32, wanted_texels_per_triangle = 8, least_texels_per_triangle = 2;
constexpr size_t full_triangles = 256;
constexpr size_t samples = 4;             // per texel
constexpr double outward_offset = 0.005;  // as a fraction of the character's size

// The point of the level under a point of the atlas; outside of the charts the nearest.
struct LevelPoint {
    uint32_t triangle = 0;
    glm::dvec3 weights = glm::dvec3(0);
    double distance_squared = std::numeric_limits<double>::infinity();  // in texels
};

// `guess`: a triangle of the chart that is tried first.
LevelPoint level_point_at(const std::vector<PrecomputedTriangle> &flat, const Chart &chart, glm::dvec2 p,
                          uint32_t guess)
{
    LevelPoint best;
    const auto try_triangle = [&](uint32_t t) {
        const glm::dvec3 at(p, 0), weights = flat[t].nearest(at), off = point_on(flat[t].corners, weights) - at;
        if (glm::dot(off, off) < best.distance_squared) best = {t, weights, glm::dot(off, off)};
        return best.distance_squared == 0;
    };
    if (try_triangle(guess)) return best;
    for (const uint32_t t : chart.triangles)
        if (t != guess && try_triangle(t)) break;
    return best;
}

// The nearest points of the source to the samples of one texel.
struct TexelSamples {
    bool used = false;
    glm::dvec3 middle = glm::dvec3(0);
    std::array<SurfacePoint, samples> points;
};

class SourceSampler
{
public:
    SourceSampler(const ProxySource &source, const PosedParts &level, const Atlas &atlas)
        : source_(source), level_(level), atlas_(atlas)
    {
        glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
        for (const PosedParts::Triangle &t : level.triangles())
            for (const glm::dvec3 p : level.corners(t)) min = glm::min(min, p), max = glm::max(max, p);
        const glm::dvec3 sizes = max - min;
        for (const auto &c : atlas.texel_coords)
            flat_.emplace_back(Corners3{glm::dvec3(c[0], 0), glm::dvec3(c[1], 0), glm::dvec3(c[2], 0)});
        offset_ = outward_offset * std::max({sizes.x, sizes.y, sizes.z});
    }

    std::vector<TexelSamples> run() const
    {
        std::vector<TexelSamples> texels(size_t(atlas_.width) * atlas_.height);
        for (const Chart &chart : atlas_.charts) {
            Guess guess{chart.triangles[0], 0};
            for (uint32_t y = chart.y; y < chart.y + chart.height; ++y)
                for (uint32_t x = chart.x; x < chart.x + chart.width; ++x)
                    sample(chart, x, y, guess, texels[size_t(y) * atlas_.width + x]);
        }
        return texels;
    }

private:
    // What the last sample of a chart found: mostly near to what the next one finds.
    struct Guess {
        uint32_t of_level, of_source;
    };
    void sample(const Chart &chart, uint32_t x, uint32_t y, Guess &guess, TexelSamples &texel) const
    {
        for (size_t i = 0; i < samples; ++i) {
            const glm::dvec2 p(x + 0.25 + 0.5 * double(i % 2), y + 0.25 + 0.5 * double(i / 2));
            const LevelPoint here = level_point_at(flat_, chart, p, guess.of_level);
            guess.of_level = here.triangle;
            if (here.distance_squared > double(atlas_gutter * atlas_gutter)) return;
            const auto c = level_.corners(level_.triangles()[here.triangle]);
            const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
            const double length = glm::length(normal);
            const glm::dvec3 at = point_on(c, here.weights);
            // The query point is slightly outside: of two layers the outer one is visible.
            const glm::dvec3 outside = length > 0 ? at + normal * (offset_ / length) : at;
            const NearestPoint::Found found = source_.nearest_visible->to(outside, guess.of_source);
            guess.of_source = found.triangle;
            texel.points[i] =
                source_.through_holes({source_.visible_triangles[found.triangle], found.weights}, outside);
            texel.middle += at / double(samples);
        }
        texel.used = true;
    }

    const ProxySource &source_;
    const PosedParts &level_;
    const Atlas &atlas_;
    std::vector<PrecomputedTriangle> flat_;  // the triangles of the level in the atlas
    double offset_ = 0;
};

// Returns the zone that most samples of a texel show, and their mean colour.
ProxyTexel proxy_texel(const ProxySource &source, const model::TextureSet *set, const TexelSamples &texel)
{
    std::array<uint32_t, samples> zones;
    for (size_t i = 0; i < samples; ++i) zones[i] = zone_at(source.model, source.fine, texel.points[i], set);
    ProxyTexel shown;
    ptrdiff_t maximum = 0;
    for (const uint32_t zone : zones) {
        const ptrdiff_t count = std::count(zones.begin(), zones.end(), zone);
        if (count > maximum) maximum = count, shown.zone = zone;
    }
    for (size_t i = 0; i < samples; ++i)
        if (zones[i] == shown.zone)
            shown.rgb += texel_at(source.model, source.fine, texel.points[i], set) / double(maximum);
    shown.at = texel.middle, shown.used = texel.used;
    return shown;
}

// Returns the fraction of the level's visible area that each texel covers.
std::vector<double> areas_of(const PosedParts &level, const std::vector<double> &visibility, const Atlas &atlas)
{
    std::vector<double> areas(size_t(atlas.width) * atlas.height, 0);
    double all = 0;
    for (const SurfaceSample &sample : sample_surface(level, surface_sample_count)) {
        const auto &corners = atlas.texel_coords[sample.point.triangle];
        const glm::dvec3 w = sample.point.weights;
        const glm::dvec2 p = w.x * corners[0] + w.y * corners[1] + w.z * corners[2];
        areas[size_t(p.y) * atlas.width + size_t(p.x)] += sample.area * visibility[sample.point.triangle];
        all += sample.area * visibility[sample.point.triangle];
    }
    for (double &area : areas) area = all > 0 ? area / all : 0;
    return areas;
}

// Texels of each triangle, so that all together take a quarter of what levels may take (docs/levels.md). An atlas is up
// to twice as large as its charts.
uint32_t texels_for(const model::Model &model, size_t triangles)
{
    constexpr uint64_t bytes_of_texel = 2 * (sizeof(TexelSamples) + sizeof(ProxyTexel) + sizeof(double) + 4);
    const uint64_t most = (64 * model::source_bytes(model) + (16ull << 20)) / 4 / bytes_of_texel / triangles;
    const uint64_t wanted = std::clamp<uint64_t>(texels_per_triangle * full_triangles / triangles,
                                                 wanted_texels_per_triangle, texels_per_triangle);
    return static_cast<uint32_t>(std::clamp<uint64_t>(most, least_texels_per_triangle, wanted));
}

}  // namespace

std::vector<model::Image> bake_charts(const ProxySource &source, model::Part &part,
                                      const std::vector<double> &visibility)
{
    const PosedParts level = source.at_rest(part);
    const Atlas atlas = build_atlas(level, texels_for(source.model, level.triangles().size()));
    const std::vector<TexelSamples> texels = SourceSampler(source, level, atlas).run();
    const std::vector<double> areas = areas_of(level, visibility, atlas);
    std::vector<model::Image> images;
    for (size_t set = 0; set < source.set_count(); ++set) {
        std::vector<ProxyTexel> shown;
        shown.reserve(texels.size());
        for (size_t i = 0; i < texels.size(); ++i) {
            shown.push_back(texels[i].used ? proxy_texel(source, source.set(set), texels[i]) : ProxyTexel());
            shown.back().area = areas[i];
        }
        balance_zones(source, set, shown);
        images.push_back(empty_image(atlas.width, atlas.height));
        // Unused texels copy a used one, so that no key names a missing zone.
        const ProxyTexel any =
            *std::find_if(shown.begin(), shown.end(), [](const ProxyTexel &one) { return one.used; });
        for (size_t i = 0; i < shown.size(); ++i) {
            const ProxyTexel &one = shown[i].used ? shown[i] : any;
            set_texel(source, i, one.zone, one.rgb, images.back());
        }
    }
    std::vector<glm::vec2> corners;
    for (const auto &triangle : atlas.texel_coords)
        for (const glm::dvec2 p : triangle) corners.emplace_back(p / glm::dvec2(atlas.width, atlas.height));
    split_by_uv(part, corners);
    return images;
}

}  // namespace claque::lod
