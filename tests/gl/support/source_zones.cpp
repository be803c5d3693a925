#include "tests/gl/support/source_zones.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/gl/support/zone_sizes.h"

namespace gltest
{
namespace
{

bool names_a_zone(const model::Model &source, const model::Material &material)
{
    return material.zone != model::none ||
           (material.image != model::none && source.images[material.image].alpha == model::AlphaMeaning::zone_keys);
}

std::array<float, 3> colour_of(const model::Material &material)
{
    return {material.base_colour[0], material.base_colour[1], material.base_colour[2]};
}

// Materials that name no zone and are seen; the first of each base colour.
std::vector<uint32_t> materials_that_make_zones(const model::Model &source)
{
    std::vector<uint8_t> used(source.materials.size());
    for (const model::Part &part : source.parts)
        if (!part.hidden && part.material != model::none && !model::triangles_of(part).empty()) used[part.material] = 1;
    std::vector<uint32_t> made;
    for (uint32_t i = 0; i < used.size(); ++i) {
        const auto same = [&](uint32_t k) { return colour_of(source.materials[k]) == colour_of(source.materials[i]); };
        if (used[i] && !names_a_zone(source, source.materials[i]) && std::none_of(made.begin(), made.end(), same))
            made.push_back(i);
    }
    return made;
}

uint16_t zone_of_material(const model::Model &source, uint32_t index)
{
    const model::Material &material = source.materials[index];
    if (material.zone != model::none) return static_cast<uint16_t>(material.zone);
    const std::vector<uint32_t> made = materials_that_make_zones(source);
    for (size_t k = 0; k < made.size(); ++k)
        if (colour_of(source.materials[made[k]]) == colour_of(material))
            return static_cast<uint16_t>(source.zones.size() + k);
    ADD_FAILURE() << "material " << material.name << " has no zone";
    return 0;
}

// Of zones that declare one key, those that no material names come first.
uint16_t zone_of_key(const model::Model &source, uint8_t key)
{
    for (const bool named : {false, true})
        for (uint32_t z = 0; z < source.zones.size(); ++z) {
            const bool is_named = std::any_of(source.materials.begin(), source.materials.end(),
                                              [z](const model::Material &one) { return one.zone == z; });
            if (source.zones[z].key == key && is_named == named) return static_cast<uint16_t>(z);
        }
    ADD_FAILURE() << "no zone has key " << int(key);
    return 0;
}

uint32_t image_of(const model::Model &source, uint32_t material, uint32_t texture_set)
{
    const uint32_t own = source.materials[material].image;
    if (own == model::none || texture_set == 0) return own;
    const uint32_t other = source.texture_sets[texture_set - 1].images[material];
    return other == model::none ? own : other;
}

ZoneTexels texels_of_file(const model::Model &source, uint32_t index, uint32_t texture_set)
{
    const model::Material &material = source.materials[index];
    const uint32_t shown = image_of(source, index, texture_set);
    ZoneTexels out;
    if (shown == model::none) {
        const bool is_hole =
            material.alpha_mode == model::AlphaMode::mask && material.base_colour[3] < material.alpha_cutoff;
        out.zones = {is_hole ? hole : zone_of_material(source, index)};
        return out;
    }
    const model::Image &image = source.images[shown];
    const bool keys = source.images[material.image].alpha == model::AlphaMeaning::zone_keys;
    std::array<uint16_t, 256> by_alpha{};
    std::array<bool, 256> present{};
    for (size_t i = 3; i < image.rgba.size(); i += 4) present[image.rgba[i]] = true;
    for (size_t alpha = 0; alpha < 256; ++alpha) {
        if (!present[alpha]) continue;
        const bool is_hole = !keys && material.alpha_mode == model::AlphaMode::mask &&
                             float(alpha) / 255 * material.base_colour[3] < material.alpha_cutoff;
        by_alpha[alpha] = keys      ? zone_of_key(source, static_cast<uint8_t>(alpha))
                          : is_hole ? hole
                                    : zone_of_material(source, index);
    }
    out.width = image.width, out.height = image.height;
    for (size_t i = 3; i < image.rgba.size(); i += 4) out.zones.push_back(by_alpha[image.rgba[i]]);
    return out;
}

void unfold(ZoneTexels &texels)
{
    ZoneTexels out = texels;
    out.width *= texels.unfolded_s ? 2 : 1, out.height *= texels.unfolded_t ? 2 : 1;
    out.zones.clear();
    for (uint32_t y = 0; y < out.height; ++y)
        for (uint32_t x = 0; x < out.width; ++x) {
            const uint32_t from_x = std::min(x, 2 * texels.width - 1 - x),
                           from_y = std::min(y, 2 * texels.height - 1 - y);
            out.zones.push_back(texels.zones[size_t(from_y) * texels.width + from_x]);
        }
    texels = std::move(out);
}

// Whether the box from (x0, y0) to (x1, y1) meets the triangle: what is left of it, cut off at each side.
bool meets(const glm::dvec2 (&triangle)[3], double x0, double y0, double x1, double y1)
{
    std::vector<glm::dvec2> polygon(triangle, triangle + 3), rest;
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 ? -1 : 1, limit = side == 0 ? x0 : side == 1 ? -x1 : side == 2 ? y0 : -y1;
        rest.clear();
        for (size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double in_a = sign * a[axis] - limit, in_b = sign * b[axis] - limit;
            if (in_a >= 0) rest.push_back(a);
            if ((in_a >= 0) != (in_b >= 0)) rest.push_back(a + (b - a) * (in_a / (in_a - in_b)));
        }
        polygon = rest;
        if (polygon.empty()) return false;
    }
    return true;
}

// Texels that a triangle of a material with this image may show.
class Covered
{
public:
    Covered(const ZoneTexels &texels, bool clamp_s, bool clamp_t)
        : width_(texels.width), height_(texels.height), clamp_s_(clamp_s), clamp_t_(clamp_t), seen(texels.zones.size())
    {
    }

    void add(const glm::dvec2 (&triangle)[3])
    {
        double largest = 0;
        glm::dvec2 low(1e300), high(-1e300);
        for (const glm::dvec2 &corner : triangle) {
            largest = std::max({largest, std::fabs(corner.x), std::fabs(corner.y)});
            low = glm::dvec2(std::min(low.x, corner.x), std::min(low.y, corner.y));
            high = glm::dvec2(std::max(high.x, corner.x), std::max(high.y, corner.y));
        }
        const double slack = 1.0 / 8 + largest / 1048576;
        const auto range = [&](double from, double to, uint32_t size, bool clamp) {
            const double end = size - 1.0;
            return std::pair<int64_t, int64_t>(
                static_cast<int64_t>(std::floor(clamp ? std::clamp(from - slack, 0.0, end) : from - slack)),
                static_cast<int64_t>(std::floor(clamp ? std::clamp(to + slack, 0.0, end) : to + slack)));
        };
        const auto [x0, x1] = range(low.x, high.x, width_, clamp_s_);
        const auto [y0, y1] = range(low.y, high.y, height_, clamp_t_);
        for (int64_t y = y0; y <= y1; ++y)
            for (int64_t x = x0; x <= x1; ++x) {
                uint8_t &one = seen[wrapped(y, height_) * width_ + wrapped(x, width_)];
                constexpr double beyond = 1e7;  // a clamped edge shows all that lies beyond it
                one |= meets(triangle, clamp_s_ && x == 0 ? -beyond : double(x) - slack,
                             clamp_t_ && y == 0 ? -beyond : double(y) - slack,
                             clamp_s_ && x + 1 == width_ ? beyond : double(x) + 1 + slack,
                             clamp_t_ && y + 1 == height_ ? beyond : double(y) + 1 + slack);
            }
    }

private:
    static size_t wrapped(int64_t i, int64_t size) { return static_cast<size_t>((i % size + size) % size); }
    int64_t width_, height_;
    bool clamp_s_, clamp_t_;

public:
    std::vector<uint8_t> seen;
};

Covered covered_by(const model::Model &source, uint32_t index, const ZoneTexels &texels, bool clamp_s, bool clamp_t)
{
    Covered covered(texels, clamp_s, clamp_t);
    const model::Material &material = source.materials[index];
    for (const model::Part &part : source.parts) {
        if (part.hidden || part.material == model::none || part.uvs.empty()) continue;
        const model::Material &other = source.materials[part.material];
        if (other.image != material.image || other.wrap_s != material.wrap_s || other.wrap_t != material.wrap_t ||
            other.zone != material.zone || other.alpha_mode != material.alpha_mode)
            continue;
        for (const auto &corners : model::triangles_of(part)) {
            glm::dvec2 triangle[3];
            for (int k = 0; k < 3; ++k) {
                const glm::vec2 uv = part.uvs[corners[static_cast<size_t>(k)]];
                triangle[k] = glm::dvec2(double(uv.x) * (texels.unfolded_s ? 0.5 : 1) * texels.width,
                                         double(uv.y) * (texels.unfolded_t ? 0.5 : 1) * texels.height);
            }
            covered.add(triangle);
        }
    }
    return covered;
}

}  // namespace

std::vector<std::string> zone_names_of(const model::Model &source)
{
    std::vector<std::string> names;
    for (const model::Zone &zone : source.zones) names.push_back(zone.name);
    for (const uint32_t material : materials_that_make_zones(source)) names.push_back(source.materials[material].name);
    return names;
}

const ZoneTexels &SourceImages::of(uint32_t material, uint32_t texture_set)
{
    const auto [found, is_new] = made_.emplace(std::pair(material, texture_set), ZoneTexels());
    if (is_new) found->second = made(material, texture_set);
    return found->second;
}

ZoneTexels SourceImages::made(uint32_t index, uint32_t texture_set) const
{
    ZoneTexels texels = texels_of_file(source_, index, texture_set);
    const model::Material &material = source_.materials[index];
    if (material.image == model::none) return texels;
    const uint32_t width = fitted(texels.width, most_px_), height = fitted(texels.height, most_px_);
    if (width == texels.width && height == texels.height) return texels;
    texels.unfolded_s = material.wrap_s == model::Wrap::mirror,
    texels.unfolded_t = material.wrap_t == model::Wrap::mirror;
    unfold(texels);
    fill_unseen(texels, covered_by(source_, index, texels, material.wrap_s == model::Wrap::clamp,
                                   material.wrap_t == model::Wrap::clamp)
                            .seen);
    const uint32_t to_x = fitted(texels.width, most_px_), to_y = fitted(texels.height, most_px_);
    if (!is_power_of_two(texels.width) || !is_power_of_two(texels.height))
        resize(texels, is_power_of_two(texels.width) ? texels.width : to_x,
               is_power_of_two(texels.height) ? texels.height : to_y);
    while (texels.width > to_x || texels.height > to_y)
        resize(texels, std::max(to_x, texels.width / 2), std::max(to_y, texels.height / 2));
    return texels;
}

}  // namespace gltest
