#include "lib/lod/far.h"

#include <map>
#include <set>

#include "lib/base/error.h"
#include "lib/lod/far_image.h"
#include "lib/lod/seen.h"
#include "lib/lod/shares.h"
#include "lib/lod/shell.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

// Keys that tell all zones apart: as they are where they do, else new ones for those that no image names.
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

// One material with what each texture set shows of it.
uint32_t add_material(const FarSource &source, std::vector<model::Image> images, FarLevels &far)
{
    const auto next = [&] { return static_cast<uint32_t>(source.model.images.size() + far.images.size()); };
    model::Material material;
    material.name = source.model.name + " far " + std::to_string(far.materials.size() + 1);
    material.image = next();
    material.wrap_s = material.wrap_t = model::Wrap::clamp;
    for (size_t i = 1; i < images.size(); ++i) {
        const bool differs = images[i].rgba != images[0].rgba;
        far.set_images[i - 1].push_back(differs ? next() + static_cast<uint32_t>(i) : model::none);
    }
    for (model::Image &image : images) {
        image.name = material.name;
        far.images.push_back(std::move(image));
    }
    far.materials.push_back(std::move(material));
    return static_cast<uint32_t>(source.model.materials.size() + far.materials.size() - 1);
}

}  // namespace

FarSource::FarSource(const model::Model &of, const std::vector<const model::Part *> &parts, const base::Jobs &jobs)
    : model(of), fine(parts), keys(keys_of(of))
{
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    fine.pose(model.rig, palette, workspace.weights());
    seen = seen_of(model, fine, jobs);
    for (size_t i = 0; i < set_count(); ++i) shares.push_back(zone_shares(model, fine, seen, set(i)));
}

PosedParts FarSource::at_rest(const model::Part &part) const
{
    PosedParts posed({&part});
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(model.rig, palette, workspace.weights());
    return posed;
}

FarLevels make_far(const model::Model &model, const std::vector<const model::Part *> &source, const FarWish &wish,
                   const base::Jobs &jobs)
{
    ShellWish shell;
    shell.targets = wish.targets;
    shell.influence = wish.influence, shell.zone = wish.zone, shell.jobs = jobs;
    const FarSource from(model, source, jobs);
    std::vector<model::Part> in_blocks;
    FarLevels far;
    far.zone_keys = from.keys;
    far.set_images.resize(model.texture_sets.size());
    for (model::Part &part : shells_of(model, source, shell))
        (part.indices.size() <= 3 * most_clean ? in_blocks : far.parts).push_back(std::move(part));
    for (model::Part &part : far.parts) part.material = add_material(from, painted_in_charts(from, part, jobs), far);
    if (in_blocks.empty()) return far;
    std::vector<model::Image> images = painted_in_blocks(from, in_blocks, jobs);
    const uint32_t material = add_material(from, std::move(images), far);
    for (model::Part &part : in_blocks) {
        part.material = material;
        far.parts.push_back(std::move(part));
    }
    return far;
}

void enter(const FarLevels &far, model::Model &model)
{
    for (size_t i = 0; i < model.texture_sets.size(); ++i) {
        std::vector<uint32_t> &images = model.texture_sets[i].images;
        images.resize(model.materials.size(), model::none);
        images.insert(images.end(), far.set_images[i].begin(), far.set_images[i].end());
    }
    model.materials.insert(model.materials.end(), far.materials.begin(), far.materials.end());
    model.images.insert(model.images.end(), far.images.begin(), far.images.end());
    for (size_t zone = 0; zone < model.zones.size(); ++zone) model.zones[zone].key = far.zone_keys[zone];
}

}  // namespace claque::lod
