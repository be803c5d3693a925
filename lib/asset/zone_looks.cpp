#include "lib/asset/zone_looks.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

using model::none;

namespace
{

using Factor = std::array<double, 3>;

constexpr double white = 0.98;  // from here on a factor leaves a colour as it is

std::vector<Place> places_of(const model::Rig &rig)
{
    std::vector<Place> out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::string name = lowered(rig.node_names[i]);
        const auto has = [&](std::initializer_list<const char *> words) {
            return std::any_of(words.begin(), words.end(),
                               [&](const char *word) { return name.find(word) != std::string::npos; });
        };
        Place place = rig.parents[i] == none ? Place::elsewhere : out[rig.parents[i]];
        if (has({"slot", "socket", "weapon", "prop", "tool"})) place = Place::elsewhere;
        else if (has({"head"})) place = Place::head;
        else if (has({"hand", "palm", "wrist", "fist"})) place = Place::hands;
        out.push_back(place);
    }
    return out;
}

Place place_of(const model::Rig &rig, const std::vector<Place> &places, const model::Part &part, uint32_t vertex)
{
    const float *weights = &part.weights[size_t(vertex) * part.influence_count];
    const size_t most = static_cast<size_t>(std::max_element(weights, weights + part.influence_count) - weights);
    return places[rig.palette[part.joints[size_t(vertex) * part.influence_count + most]].node];
}

const uint8_t *texel_at(const model::Image &image, double u, double v)
{
    const auto index = [](double x, uint32_t size) {
        return std::min(static_cast<size_t>((x - std::floor(x)) * size), size_t(size) - 1);
    };
    return &image.rgba[4 * (index(v, image.height) * image.width + index(u, image.width))];
}

// The zone of each key: materials name all zones without one.
std::array<uint32_t, 256> zones_by_key(const model::Model &model)
{
    std::vector<bool> named(model.zones.size());
    for (const model::Material &material : model.materials)
        if (material.zone != none) named[material.zone] = true;
    std::array<uint32_t, 256> out;
    out.fill(none);
    for (uint32_t z = 0; z < model.zones.size(); ++z)
        if (!named[z]) out[model.zones[z].key] = z;
    return out;
}

// Adds up the triangles of one part.
class PartLooks
{
public:
    PartLooks(const model::Model &model, const model::Part &part, const std::array<uint32_t, 256> &by_key)
        : part_(part), material_(model.materials[part.material]), by_key_(by_key)
    {
        if (material_.image != none && !part.uvs.empty()) image_ = &model.images[material_.image];
        keyed_ = image_ && image_->alpha == model::AlphaMeaning::zone_keys;
    }

    // The colour in a triangle's middle; returns the zone there, or none.
    uint32_t shown(const std::array<uint32_t, 3> &t, Factor &factor) const
    {
        factor = {1, 1, 1};
        uint32_t zone = keyed_ ? none : material_.zone;
        if (image_) {
            const auto middle = [&](auto coordinate) {
                return (double(coordinate(t[0])) + double(coordinate(t[1])) + double(coordinate(t[2]))) / 3;
            };
            const uint8_t *texel = texel_at(*image_, middle([&](uint32_t i) { return part_.uvs[i].x; }),
                                            middle([&](uint32_t i) { return part_.uvs[i].y; }));
            if (keyed_) zone = by_key_[texel[3]];
            for (size_t k = 0; k < 3; ++k) factor[k] *= texel[k] / 255.0;
        }
        for (size_t k = 0; k < 3; ++k) {
            if (!part_.colours.empty())
                factor[k] *= (part_.colours[t[0]][k] + part_.colours[t[1]][k] + part_.colours[t[2]][k]) / (3 * 255.0);
            if (keyed_) factor[k] *= double(material_.base_colour[k]);
        }
        return zone;
    }

private:
    const model::Part &part_;
    const model::Material &material_;
    const std::array<uint32_t, 256> &by_key_;
    const model::Image *image_ = nullptr;
    bool keyed_ = false;
};

std::array<float, 3> mean_of(const Factor &sum, size_t count)
{
    if (count == 0) return {1, 1, 1};
    const double n = double(count);
    return {float(sum[0] / n), float(sum[1] / n), float(sum[2] / n)};
}

}  // namespace

std::array<float, 3> ZoneLook::mean(Place place) const { return mean_of(sums[static_cast<size_t>(place)], at(place)); }

std::array<float, 3> ZoneLook::mean() const
{
    Factor sum{};
    for (const Factor &one : sums)
        for (size_t k = 0; k < 3; ++k) sum[k] += one[k];
    return mean_of(sum, all());
}

std::vector<ZoneLook> looks_of(const model::Model &model)
{
    std::vector<ZoneLook> out(model.zones.size());
    const std::vector<Place> places = places_of(model.rig);
    const std::array<uint32_t, 256> by_key = zones_by_key(model);
    for (const model::Part &part : model.parts) {
        if (part.hidden || part.material == none) continue;
        const PartLooks looks(model, part, by_key);
        for (const auto &t : model::triangles_of(part)) {
            Factor factor;
            const uint32_t zone = looks.shown(t, factor);
            if (zone == none) continue;
            const size_t place = static_cast<size_t>(place_of(model.rig, places, part, t[0]));
            ++out[zone].triangles[place];
            for (size_t k = 0; k < 3; ++k) {
                out[zone].sums[place][k] += factor[k];
                out[zone].patterned |= factor[k] < white;
            }
        }
    }
    return out;
}

}  // namespace claque::asset
