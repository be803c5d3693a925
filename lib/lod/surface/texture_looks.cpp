#include "lib/lod/surface/texture_looks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

namespace claque::lod
{

namespace
{

constexpr double regions = 14;         // along the longest side of the character
constexpr double least_share = 0.001;  // of the area that a region counts with
constexpr double pixels = 4096;        // of the finest size along the longest side
constexpr double small = 80;           // pixels along the longest side at which the shape alone counts

// Pixels grow until colours differ by no more than this, at most so many times. A difference that is left makes an
// error of the shape more visible, by so many times the difference. A region with a worse shape than
// the whole counts with its own error: the hair of a head above clothes that fit.
constexpr double max_difference = 0.12, weight = 20;
constexpr size_t max_doublings = 4;

using Texel = std::array<uint8_t, 4>;

Texel mean_of(const Texel &a, const Texel &b, const Texel &c, const Texel &d)
{
    Texel mean;
    for (size_t k = 0; k < 4; ++k) mean[k] = static_cast<uint8_t>((a[k] + b[k] + c[k] + d[k] + 2) / 4);
    return mean;
}

// The texels as they are shown: in the colours of their zones, and black where an alpha test leaves a hole.
std::vector<Texel> shown_texels(const model::Model &model, const model::Material &material, const model::Image &image)
{
    std::array<std::array<float, 3>, 256> colours;
    colours.fill({1, 1, 1});
    std::array<bool, 256> is_hole{};
    if (image.alpha == model::AlphaMeaning::zone_keys)
        for (size_t i = model.zones.size(); i-- > 0;) colours[model.zones[i].key] = model.zones[i].colour;
    else if (material.alpha_mode == model::AlphaMode::mask)
        for (size_t alpha = 0; alpha < 256; ++alpha) is_hole[alpha] = float(alpha) < 255 * material.alpha_cutoff;
    std::vector<Texel> texels(image.rgba.size() / 4);
    for (size_t i = 0; i < texels.size(); ++i) {
        const uint8_t *from = &image.rgba[4 * i];
        if (is_hole[from[3]]) continue;
        for (size_t k = 0; k < 3; ++k) texels[i][k] = static_cast<uint8_t>(float(from[k]) * colours[from[3]][k]);
        texels[i][3] = 255;
    }
    return texels;
}

double uv_area(const PosedParts &parts, uint32_t triangle)
{
    const PosedParts::Triangle &t = parts.triangles()[triangle];
    const std::vector<glm::vec2> &uvs = parts.part(t.part).uvs;
    const glm::dvec2 a(uvs[t.vertices[0]]), b(uvs[t.vertices[1]]), c(uvs[t.vertices[2]]);
    return 0.5 * std::fabs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

}  // namespace

std::vector<TextureLooks::Mip> TextureLooks::mips_of(const model::Model &model, const model::Material &material)
{
    const model::Image &image = model.images[material.image];
    std::vector<Mip> mips;
    mips.push_back({image.width, image.height, shown_texels(model, material, image)});
    while (mips.back().width > 1 || mips.back().height > 1) {
        const Mip &from = mips.back();
        Mip half{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
        half.texels.reserve(size_t(half.width) * half.height);
        for (uint32_t y = 0; y < half.height; ++y)
            for (uint32_t x = 0; x < half.width; ++x) {
                const size_t left = std::min(2 * x, from.width - 1), right = std::min(2 * x + 1, from.width - 1);
                const Texel *low = &from.texels[size_t(std::min(2 * y, from.height - 1)) * from.width],
                            *high = &from.texels[size_t(std::min(2 * y + 1, from.height - 1)) * from.width];
                half.texels.push_back(mean_of(low[left], low[right], high[left], high[right]));
            }
        mips.push_back(std::move(half));
    }
    return mips;
}

void TextureLooks::add(const model::Model &model)
{
    const std::vector<model::Material> &all = model.materials;
    for (size_t i = looks_.size(); i < all.size(); ++i) {
        Look &look = looks_.emplace_back();
        look.wrap_s = all[i].wrap_s, look.wrap_t = all[i].wrap_t;
        look.has_holes = all[i].alpha_mode == model::AlphaMode::mask;
        if (all[i].zone != model::none) {
            const std::array<float, 3> &c = model.zones[all[i].zone].colour;
            look.colour = math::F4{c[0], c[1], c[2], 1};
        }
        if (all[i].image == model::none) continue;
        // Many materials may share an image.
        const auto same = std::find_if(all.begin(), all.begin() + std::ptrdiff_t(i), [&](const model::Material &other) {
            return other.image == all[i].image && other.alpha_mode == all[i].alpha_mode &&
                   other.alpha_cutoff == all[i].alpha_cutoff;
        });
        const size_t first = size_t(same - all.begin());
        look.mips = first < i ? looks_[first].mips : std::make_shared<const std::vector<Mip>>(mips_of(model, all[i]));
    }
}

// What a point shows.
struct TextureLooks::Shown {
    const Look *look = nullptr;
    glm::dvec2 uv = glm::dvec2(0);
    double texel = std::numeric_limits<double>::infinity();  // its size on the surface

    // Of a pixel of 2^level of its texels, between the centres of the four nearest.
    math::F4 colour(size_t level) const
    {
        if (!look) return math::splat(1);
        if (!look->mips) return look->colour;
        const Mip &mip = (*look->mips)[std::min(level, look->mips->size() - 1)];
        const double half_x = 0.5 / mip.width, half_y = 0.5 / mip.height;
        const size_t x[2] = {texel_index(uv.x - half_x, mip.width, look->wrap_s),
                             texel_index(uv.x + half_x, mip.width, look->wrap_s)};
        const size_t y[2] = {texel_index(uv.y - half_y, mip.height, look->wrap_t),
                             texel_index(uv.y + half_y, mip.height, look->wrap_t)};
        const double right = uv.x * mip.width - 0.5, up = uv.y * mip.height - 0.5;
        const float s = float(right - std::floor(right)), t = float(up - std::floor(up));
        const auto at = [&](size_t i, size_t j) {
            const Texel &c = mip.texels[y[j] * mip.width + x[i]];
            return math::F4{float(c[0]), float(c[1]), float(c[2]), float(c[3])};
        };
        const math::F4 low = at(0, 0) + math::splat(s) * (at(1, 0) - at(0, 0)),
                       high = at(0, 1) + math::splat(s) * (at(1, 1) - at(0, 1));
        return look->colour * math::splat(1 / 255.0f) * (low + math::splat(t) * (high - low));
    }
};

TextureLooks::Shown TextureLooks::shown_at(const PosedParts &parts, const SurfacePoint &point) const
{
    Shown shown;
    const model::Part &part = parts.part(parts.triangles()[point.triangle].part);
    if (part.material == model::none) return shown;
    shown.look = &looks_[part.material];
    if (!shown.look->mips || part.uvs.empty()) return shown;
    shown.uv = uv_at(parts, point);
    const Mip &finest = shown.look->mips->front();
    const double texels = uv_area(parts, point.triangle) * finest.width * finest.height;
    if (texels > 0) shown.texel = std::sqrt(area_of(parts, point.triangle) / texels);
    return shown;
}

namespace
{

// The level of a chain of mips whose pixels are about as large.
size_t mip_of(double texel, double pixel)
{
    size_t level = 0;
    for (; texel * 1.5 < pixel && level < 16; texel *= 2) ++level;
    return level;
}

// To the power of 3/4: small differences are seen too.
double seen(math::F4 off)
{
    const float square = (off[0] * off[0] + off[1] * off[1] + off[2] * off[2]) / 3 + off[3] * off[3];
    const double root = std::sqrt(std::sqrt(double(square)));
    return root * std::sqrt(root);
}

}  // namespace

double LookDifference::hidden_by(double shape_m) const
{
    size_t first = 0;
    double size = longest_m / pixels, pixel = shape_m;
    for (; first + 1 < size_count && size < shape_m; size *= 2) ++first;
    size_t k = first;
    for (; k + 1 < size_count && k < first + max_doublings && colours[k] > max_difference; ++k) pixel = size *= 2;
    // The last tenth of the way keeps levels in the order of their shapes.
    const double most = longest_m / small, last = 0.9 * most + 0.1 * std::min(shape_m, most);
    return std::max(shape_m, std::min(pixel * factors[k], last));
}

LookDifference TextureLooks::difference(const PosedParts &source, const PosedParts &level,
                                        const std::vector<PointPair> &pairs, const std::vector<double> &areas,
                                        double metres_per_unit) const
{
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3 &p : source.positions()) low = glm::min(low, p), high = glm::max(high, p);
    const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    struct Sum {
        double area = 0, squares = 0;
        std::array<double, LookDifference::size_count> off{};
    };
    std::map<std::array<int, 3>, Sum> sums;
    Sum all;
    for (const PointPair &pair : pairs) {
        const double area = areas[pair.here.triangle] * pair.weight;
        if (pair.corner != PointPair::inside || !(area > 0) || !(longest > 0)) continue;
        const Shown here = shown_at(source, pair.here), there = shown_at(level, pair.there);
        if (!there.look) continue;  // a proxy that is not painted yet
        // A proxy shows the surface behind a hole.
        if (here.look && here.look->has_holes && !there.look->has_holes && here.colour(0)[3] < 0.5f) continue;
        const glm::dvec3 at = position_of(source, pair.here), away = at - position_of(level, pair.there),
                         cell = (at - low) * (regions / longest);
        Sum &sum = sums[{int(cell.x), int(cell.y), int(cell.z)}];
        all.area += area, sum.area += area;
        all.squares += area * glm::dot(away, away), sum.squares += area * glm::dot(away, away);
        double pixel = longest / pixels;
        for (double &off : sum.off) {
            off += area * seen(here.colour(mip_of(here.texel, pixel)) - there.colour(mip_of(there.texel, pixel)));
            pixel *= 2;
        }
    }
    LookDifference found;
    found.longest_m = longest * metres_per_unit;
    const double least = 1e-6 * longest;  // an equal shape is off by rounding
    for (const auto &[cell, sum] : sums) {
        if (!(sum.area > least_share * all.area)) continue;
        const double more =
            all.squares > all.area * least * least ? std::sqrt(sum.squares / sum.area / (all.squares / all.area)) : 1;
        for (size_t k = 0; k < sum.off.size(); ++k) {
            const double colours = sum.off[k] / sum.area;
            found.colours[k] = std::max(found.colours[k], colours);
            found.factors[k] = std::max(found.factors[k], (1 + weight * colours * more) * std::max(more, 1.0));
        }
    }
    return found;
}

}  // namespace claque::lod
