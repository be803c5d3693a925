#include "lib/lod/proxies/proxy.h"

#include <map>
#include <set>

#include "lib/base/error.h"
#include "lib/lod/proxies/proxy_image.h"
#include "lib/lod/surface/area_fractions.h"
#include "lib/lod/surface/visibility.h"
#include "lib/model/model_size.h"

namespace claque::lod
{

namespace
{

// Returns zone keys that are all different: the present ones if they are, else new ones for zones that share a key,
// taken from values that no image uses.
std::vector<uint8_t> keys_of(const model::Model &model)
{
    std::vector<uint8_t> keys;
    std::set<uint8_t> taken;
    for (const model::Zone &zone : model.zones) keys.push_back(zone.key), taken.insert(zone.key);
    if (taken.size() == keys.size()) return keys;
    taken.clear();
    for (const model::Image &image : model.images)
        if (image.alpha == model::AlphaMeaning::zone_keys)
            for (size_t i = 3; i < image.rgba.size(); i += 4) taken.insert(image.rgba[i]);
    std::set<uint8_t> given;
    uint32_t next = 1;
    for (uint8_t &key : keys) {
        if (taken.count(key) && given.insert(key).second) continue;
        while (next < 256 && (taken.count(static_cast<uint8_t>(next)) || given.count(static_cast<uint8_t>(next))))
            ++next;
        if (next == 256) base::fail(CLQ_LIMIT, "'%s' has more zones than keys", model.name.c_str());
        key = static_cast<uint8_t>(next);
        given.insert(key);
    }
    return keys;
}

// Adds one material with its image in each texture set.
uint32_t add_material(const ProxySource &source, std::vector<model::Image> images, ProxyLevels &proxies)
{
    const auto next = [&] { return static_cast<uint32_t>(source.model.images.size() + proxies.images.size()); };
    model::Material material;
    material.name = source.model.name + " far " + std::to_string(proxies.materials.size() + 1);
    material.image = next();
    material.wrap_s = material.wrap_t = model::Wrap::clamp;
    for (size_t i = 1; i < images.size(); ++i) {
        const bool differs = images[i].rgba != images[0].rgba;
        proxies.set_images[i - 1].push_back(differs ? next() + static_cast<uint32_t>(i) : model::none);
    }
    for (model::Image &image : images) {
        image.name = material.name;
        proxies.images.push_back(std::move(image));
    }
    proxies.materials.push_back(std::move(material));
    return static_cast<uint32_t>(source.model.materials.size() + proxies.materials.size() - 1);
}

std::vector<const model::Part *> parts_of(const PosedParts &posed)
{
    std::vector<const model::Part *> parts;
    for (uint32_t i = 0; i < posed.part_count(); ++i) parts.push_back(&posed.part(i));
    return parts;
}

// Sets whose zone points take a quarter of what levels may take at most (docs/levels.md).
size_t kept_sets(const model::Model &model, const PosedParts &fine)
{
    const uint64_t bytes =
        (PointTree::bytes_of_point + sizeof(SurfacePoint)) * (fine.triangles().size() + uint64_t(surface_sample_count));
    return size_t((64 * model::source_bytes(model) + (16ull << 20)) / 4 / bytes);
}

}  // namespace

ProxySource::ProxySource(const model::Model &of, const std::vector<const model::Part *> &parts, const base::Jobs &jobs)
    : ProxySource(of, posed_at_rest(of.rig, parts), {}, jobs)
{
}

ProxySource::ProxySource(const model::Model &of, PosedParts at_rest, std::vector<double> seen, const base::Jobs &jobs)
    : model(of),
      fine(std::move(at_rest)),
      trees(fine, 1),
      visibility(std::move(seen)),
      keys(keys_of(of)),
      views(of, parts_of(fine))
{
    if (visibility.empty()) visibility = visibility_of(model, fine, jobs);
    for (uint32_t t = 0; t < visibility.size(); ++t)
        if (visibility[t] > 0) {
            visible_triangles.push_back(t);
            if (!has_holes(model, fine.part(fine.triangles()[t].part))) whole_triangles.push_back(t);
        }
    const bool has_both = !whole_triangles.empty() && whole_triangles.size() < visible_triangles.size();
    const auto sets = static_cast<uint32_t>(set_count()),
               kept = std::min(sets, static_cast<uint32_t>(kept_sets(model, fine)));
    area_fractions.resize(sets), zone_points.resize(sets);
    if (has_both) nearest_whole.emplace(fine.corners(whole_triangles));
    jobs.try_each(sets + kept + 1, [&](uint32_t i) {
        if (i == 0) nearest_visible.emplace(fine.corners(visible_triangles));
        else if (i <= kept) zone_points[i - 1] = zone_points_of(model, fine, set(i - 1));
        else area_fractions[i - 1 - kept] = zone_area_fractions(model, fine, visibility, set(i - 1 - kept));
    });
}

PosedParts ProxySource::at_rest(const model::Part &part) const { return posed_at_rest(model.rig, {&part}); }

SurfacePoint ProxySource::through_holes(const SurfacePoint &point, glm::dvec3 at) const
{
    if (!nearest_whole || !is_hole(model, fine, point)) return point;
    const NearestPoint::Found found = nearest_whole->to(at);
    return {whole_triangles[found.triangle], found.weights};
}

ProxyLevels bake_proxies(const ProxySource &source, std::vector<model::Part> meshes,
                         const std::vector<double> &tolerances, const base::Jobs &jobs)
{
    std::vector<model::Part> swatch_parts;
    std::vector<double> swatch_tolerances;
    ProxyLevels proxies;
    proxies.zone_keys = source.keys;
    proxies.set_images.resize(source.model.texture_sets.size());
    for (size_t i = 0; i < meshes.size(); ++i) {
        const bool is_clean = meshes[i].indices.size() <= 3 * max_clean_triangles;
        if (is_clean) swatch_tolerances.push_back(tolerances.empty() ? max_zone_area_error : tolerances[i]);
        (is_clean ? swatch_parts : proxies.parts).push_back(std::move(meshes[i]));
    }
    std::vector<std::vector<model::Image>> charts(proxies.parts.size());
    std::vector<SwatchZones> chosen(swatch_parts.size());
    const uint32_t count = static_cast<uint32_t>(charts.size()), few = static_cast<uint32_t>(chosen.size());
    proxies.visibility.resize(count + few);
    jobs.try_each(few + count, [&](uint32_t i) {
        model::Part &part = i < few ? swatch_parts[i] : proxies.parts[i - few];
        std::vector<double> &visibility = proxies.visibility[i < few ? count + i : i - few];
        visibility = visibility_of(source.model, source.at_rest(part));
        if (i < few) chosen[i] = swatch_zones_of(source, part, swatch_tolerances[i]);
        else charts[i - few] = bake_charts(source, part, visibility);
    });
    for (uint32_t i = 0; i < count; ++i)
        proxies.parts[i].material = add_material(source, std::move(charts[i]), proxies);
    if (swatch_parts.empty()) return proxies;
    const uint32_t material = add_material(source, bake_swatches(source, chosen, swatch_parts), proxies);
    for (model::Part &part : swatch_parts) {
        part.material = material;
        proxies.parts.push_back(std::move(part));
    }
    return proxies;
}

ProxyLevels make_proxies(const model::Model &model, const std::vector<const model::Part *> &source,
                         const ProxyMeshOptions &options)
{
    return bake_proxies(ProxySource(model, source, options.jobs), proxy_meshes(model, source, options), {},
                        options.jobs);
}

void add_to_model(const ProxyLevels &proxies, model::Model &model)
{
    for (size_t i = 0; i < model.texture_sets.size(); ++i) {
        std::vector<uint32_t> &images = model.texture_sets[i].images;
        images.resize(model.materials.size(), model::none);
        images.insert(images.end(), proxies.set_images[i].begin(), proxies.set_images[i].end());
    }
    model.materials.insert(model.materials.end(), proxies.materials.begin(), proxies.materials.end());
    model.images.insert(model.images.end(), proxies.images.begin(), proxies.images.end());
    for (size_t zone = 0; zone < model.zones.size(); ++zone) model.zones[zone].key = proxies.zone_keys[zone];
}

}  // namespace claque::lod
