#include "passes/prepared.h"

#include <algorithm>

#include "lib/model/keys.h"
#include "passes/batch.h"
#include "passes/close_prepare.h"
#include "passes/flat.h"
#include "passes/linear_clean.h"
#include "passes/parts.h"
#include "passes/plain.h"
#include "passes/smooth_levels.h"

namespace claque::passes
{
namespace
{

bool in_range(model::IndexRange range, const model::Level &level)
{
    return range.count % 3 == 0 && range.first <= level.indices.size() &&
           range.count <= level.indices.size() - range.first;
}

bool bins_in_range(const Array<model::Bin> &bins, const model::Level &level, size_t zone_count)
{
    return std::all_of(bins.begin(), bins.end(), [&](const model::Bin &bin) {
        return bin.zone_index < zone_count && in_range(bin.range, level);
    });
}

// True if offsets ascend from 0 to the range's count.
bool parts_are_sound(const IndexSlice &slice, size_t part_count)
{
    const uint32_t *firsts = slice.firsts;
    if (!firsts) return true;
    for (size_t part = 0; part < part_count; ++part)
        if (firsts[part] % 3 != 0 || firsts[part] > firsts[part + 1]) return false;
    return firsts[0] == 0 && firsts[part_count] == slice.range.count;
}

bool parts_are_sound(const model::Surface &surface, const model::Level &level)
{
    const size_t parts = level.parts.size();
    const IndexSlices slices(level, surface);
    if (parts > model::max_level_parts) return false;
    if (surface.part_offsets.size() != (parts < 2 ? 0 : slices.count() * (parts + 1))) return false;
    for (size_t i = 0; i < slices.count(); ++i)
        if (!parts_are_sound(slices[i], parts)) return false;
    return true;
}

bool surface_is_sound(const model::Surface &surface, const model::Level &level, const model::Template &source)
{
    if (surface.texture >= source.textures.size()) return false;
    const size_t zones = source.textures[surface.texture].keys.size();
    return in_range(surface.dirty, level) && in_range(surface.fused, level) &&
           bins_in_range(surface.clean, level, zones) && bins_in_range(surface.dirty_by_zone, level, zones) &&
           parts_are_sound(surface, level);
}

// Draws give these arrays to GL, which does not check them.
bool level_is_sound(const model::Level &level, const model::Template &source)
{
    const size_t vertices = level.vertex_count;
    return level.source_count <= vertices && level.uvs.size() == 2 * vertices && level.slots.size() == vertices &&
           (level.colours.empty() || level.colours.size() == 4 * vertices) &&
           std::all_of(level.indices.begin(), level.indices.end(), [&](uint32_t i) { return i < vertices; }) &&
           std::all_of(level.surfaces.begin(), level.surfaces.end(),
                       [&](const model::Surface &s) { return surface_is_sound(s, level, source); });
}

template <class Image>
bool image_is_sound(const Image &image)
{
    return image.width > 0 && image.height > 0 && image.rgba.size() == size_t(4) * image.width * image.height;
}

bool texture_is_sound(const model::Texture &texture, const model::Template &source)
{
    return image_is_sound(texture) && !texture.keys.empty() &&
           (texture.set_images.empty() || texture.set_images.size() == source.texture_sets.size()) &&
           std::all_of(texture.set_images.begin(), texture.set_images.end(),
                       [](const model::TextureImage &image) { return image_is_sound(image); }) &&
           std::all_of(texture.keys.begin(), texture.keys.end(),
                       [&](const model::ZoneKey &key) { return key.zone < source.zone_count(); });
}

base::Status check_sound(const model::Template &source)
{
    const char *wrong = nullptr;
    if (source.zone_colours.size() != source.zone_count()) wrong = "zone colours do not match its zones";
    for (const model::Texture &texture : source.textures)
        if (!texture_is_sound(texture, source)) wrong = "a texture's bytes or keys do not match its size or zones";
    for (const model::Level &level : source.levels)
        if (!level_is_sound(level, source)) wrong = "a level has an index, part or array length out of range";
    if (!wrong) return base::Status::good();
    return base::Status::bad(CLQ_ARGUMENT, "template '%s': %s", source.name.c_str(), wrong);
}

bool has_dirty(const model::Template &source, uint32_t texture)
{
    for (const model::Level &level : source.levels)
        for (const model::Surface &surface : level.surfaces)
            if (surface.texture == texture && surface.dirty.count != 0) return true;
    return false;
}

// Fused if it distinguishes the zones of all textures, else binned, else an error.
base::Status choose_strategy(PreparedTemplate &out, Strategy wanted, uint32_t alpha_bits)
{
    const model::Template &source = *out.source;
    out.strategy = wanted;
    for (uint32_t i = 0; i < source.textures.size(); ++i) {
        if (!has_dirty(source, i)) continue;
        const std::vector<uint8_t> keys = model::keys_of(source.textures[i]);
        if (out.strategy == Strategy::fused && model::fused_accepts(model::Keys(keys), alpha_bits)) continue;
        if (out.strategy == Strategy::fused) out.strategy = Strategy::binned;
        if (!model::passes_accept(model::Keys(keys), alpha_bits))
            return base::Status::bad(CLQ_KEY_RESOLUTION,
                                     "template '%s': texture %u has %zu zones (keys %d to %d), which %u bits of "
                                     "alpha cannot tell apart; %u zones are the most",
                                     source.name.c_str(), i, keys.size(), keys.front(), keys.back(), alpha_bits,
                                     model::passes_limit(alpha_bits));
    }
    return base::Status::good();
}

void prepare_texture(PreparedTexture &out, const model::Texture &texture, const RendererOptions &options)
{
    out.names.resize(1 + texture.set_images.size());
    if (options.linear_clean) out.linear_names.resize(out.names.size());
    const std::vector<uint8_t> bytes = model::keys_of(texture);
    const model::Keys keys(bytes);
    const model::FusedTable fused = model::fused_table(keys);
    out.hole_reference = model::pass_reference(keys, 0);
    out.fused_reference = fused.reference;
    for (uint32_t i = 0; i < texture.keys.size(); ++i) {
        ZoneTest test;
        test.zone = texture.keys[i].zone;
        // Not key / 255, which differs by one ulp from GL's value of the texel.
        test.reference = options.key_test == KeyTest::equal ? static_cast<float>(bytes[i]) * (1.0f / 255.0f)
                                                            : model::pass_reference(keys, i);
        test.threshold_ubyte = fused.alpha_8bit[i];
        test.threshold_real = fused.alpha[i];
        out.tests.push_back(test);
    }
}

// All levels or none: a host chooses the rigid mode for a whole template.
void prepare_placement(PreparedTemplate &out)
{
    out.rigid = out.source->has_rigid_parts_only();
    for (size_t i = 0; i < out.levels.size() && out.rigid; ++i)
        out.rigid = prepare_rigid(out.levels[i], *out.source, out.source->levels[i]);
    if (out.rigid) return;
    for (PreparedLevel &level : out.levels) {
        level.positions.clear();
        level.normals.clear();
        level.steps.clear();
    }
}

}  // namespace

base::Status prepare_without_gl(PreparedTemplate &out, const model::Template &source, const RendererOptions &options,
                                int alpha_bits)
{
    base::Status status = check_sound(source);
    if (!status.ok()) return status;
    out.source = &source;
    status = choose_strategy(out, options.strategy, static_cast<uint32_t>(alpha_bits));
    if (!status.ok()) return status;

    std::pmr::memory_resource *memory = out.levels.get_allocator().resource();
    for (const std::array<float, 3> &colour : source.zone_colours)
        for (const float c : colour)
            out.zone_rgb.push_back(static_cast<uint8_t>(std::clamp(c, 0.0f, 1.0f) * 255.0f + 0.5f));
    for (const model::Texture &texture : source.textures)
        prepare_texture(out.textures.emplace_back(memory), texture, options);
    for (const model::Level &level : source.levels) {
        PreparedLevel &ready = out.levels.emplace_back(memory);
        ready.batched = Batch::fits(source, level, options.batch_triangles);
        prepare_flat(ready, source, level, options.flat_triangles);
        LuminanceStep step;
        if (options.linear_clean && !ready.batched) prepare_linear_clean(ready, source, level, step);
        if (&level == &source.levels[0]) out.step = step;
        prepare_ranges(ready, ready.drawn(level));
        prepare_plain(ready, level);
        prepare_shadow(ready, level);
    }
    prepare_placement(out);
    if (options.smooth_levels) prepare_smooth(out);
    if (options.close_bytes != 0) prepare_close(out, options);
    return base::Status::good();
}

const PreparedTemplate *find(const Array<PreparedTemplate> &templates, const model::Template *tmpl)
{
    for (const PreparedTemplate &prepared : templates)
        if (prepared.source == tmpl) return &prepared;
    return nullptr;
}

}  // namespace claque::passes
