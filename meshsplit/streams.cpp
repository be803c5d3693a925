#include "meshsplit/streams.h"

#include <unordered_map>

#include "lib/base/error.h"
#include "meshsplit/interner.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

constexpr uint16_t no_zone = 0xffff;
constexpr uint16_t no_slot = 0xffff;

template <class Image>
ZoneImage zone_image_of(const model::Texture &texture, const Image &image)
{
    std::array<uint16_t, 256> index{};
    index.fill(no_zone);
    for (size_t i = 0; i < texture.keys.size(); ++i) index[texture.keys[i].key] = static_cast<uint16_t>(i);
    ZoneImage out{{image.width, image.height, texture.wrap_s, texture.wrap_t}, {}};
    out.zones.resize(size_t(image.width) * image.height);
    for (size_t i = 0; i < out.zones.size(); ++i) out.zones[i] = index[image.rgba[4 * i + 3]];
    return out;
}

// Collects the zones of texel spans, over all texture sets.
class ZoneCollector
{
public:
    ZoneCollector(const std::vector<ZoneImage> &zone_images, size_t zone_count)
        : zone_images_(zone_images), seen_(zone_count)
    {
    }

    void append(const UvTriangle &triangle, std::vector<uint16_t> &out)
    {
        if (seen_.size() == 1) return out.push_back(0);
        // Triangles with equal coordinates show the same zones.
        known_.begin();
        for (const glm::vec2 &corner : triangle.corners) known_.add(corner.x), known_.add(corner.y);
        const auto [number, is_new] = known_.number();
        if (!is_new) {
            for (uint32_t i = known_first_[number]; i < known_first_[number + 1]; ++i) out.push_back(known_zones_[i]);
            return;
        }
        std::fill(seen_.begin(), seen_.end(), uint8_t(0));
        left_ = seen_.size();
        for (const ZoneImage &zone_image : zone_images_) collect(zone_image, triangle);
        for (size_t z = 0; z < seen_.size(); ++z)
            if (seen_[z]) known_zones_.push_back(static_cast<uint16_t>(z));
        if (left_ == seen_.size()) known_zones_.push_back(0);
        out.insert(out.end(), known_zones_.begin() + known_first_.back(), known_zones_.end());
        known_first_.push_back(static_cast<uint32_t>(known_zones_.size()));
    }

    uint64_t texels() const { return texels_; }

private:
    void collect(const ZoneImage &zone_image, const UvTriangle &triangle)
    {
        spans_.clear();
        cover(zone_image.grid, triangle, spans_);
        for (const TexelSpan &span : spans_) {
            if (left_ == 0) return;  // no further texel can add a zone
            const uint16_t *texel = zone_image.zones.data() + size_t(span.row) * zone_image.grid.width + span.first;
            texels_ += span.count;
            for (uint32_t i = 0; i < span.count; ++i)
                if (texel[i] != no_zone && !seen_[texel[i]]) seen_[texel[i]] = 1, --left_;
        }
    }

    const std::vector<ZoneImage> &zone_images_;
    std::vector<uint8_t> seen_;
    size_t left_ = 0;  // zones that were not seen
    std::vector<TexelSpan> spans_;
    Interner known_;  // coordinates, and the zones that were found for them
    std::vector<uint32_t> known_first_ = {0};
    std::vector<uint16_t> known_zones_;
    uint64_t texels_ = 0;  // that were looked at
};

class StreamMaker
{
public:
    StreamMaker(const Mesh &mesh, const TriangleZones &zones, uint32_t part_count, model::Level &level)
        : mesh_(mesh), zones_(zones), part_count_(part_count), level_(level)
    {
        level_.slots.assign(level_.source_count, no_slot);
    }

    void run()
    {
        std::vector<std::vector<size_t>> triangles(mesh_.surfaces.size());
        for (size_t t = 0; t < mesh_.triangles.size(); ++t) triangles[mesh_.triangles[t].surface].push_back(t);
        for (uint32_t s = 0; s < mesh_.surfaces.size(); ++s) add_surface(s, triangles[s]);
        level_.vertex_count = level_.source_count + static_cast<uint32_t>(level_.copies.size());
    }

private:
    using ZoneLists = std::vector<std::vector<size_t>>;  // triangles, by zone

    void add_surface(uint32_t s, const std::vector<size_t> &triangles)
    {
        ZoneLists clean, touching;
        std::vector<size_t> dirty;
        for (const size_t t : triangles) {
            const uint32_t count = zones_.count(t);
            auto &lists = count == 1 ? clean : touching;
            for (uint32_t i = 0; i < count; ++i) {
                const uint16_t zone = zones_.of(t)[i];
                if (lists.size() <= zone) lists.resize(size_t(zone) + 1);
                lists[zone].push_back(t);
            }
            if (count > 1) dirty.push_back(t);
        }
        level_.surfaces.emplace_back(level_.surfaces.get_allocator().resource());
        model::Surface &surface = level_.surfaces.back();
        surface.texture = mesh_.surfaces[s].texture;
        surface.double_sided = mesh_.surfaces[s].double_sided;
        surface.lighting = mesh_.surfaces[s].lighting;
        part_firsts_.clear();
        add_bins(clean, surface.clean);
        surface.dirty = add_range(dirty);
        add_bins(touching, surface.dirty_by_zone);
        surface.fused = add_fused(clean, touching);
        if (part_count_ > 1) surface.part_offsets.assign(part_firsts_.begin(), part_firsts_.end());
    }

    void add_bins(const ZoneLists &lists, model::Array<model::Bin> &out)
    {
        for (uint32_t z = 0; z < lists.size(); ++z)
            if (!lists[z].empty()) out.push_back({z, add_range(lists[z])});
    }

    model::IndexRange add_range(const std::vector<size_t> &triangles)
    {
        const uint32_t first = here();
        auto next = triangles.begin();
        for (uint32_t part = 0; part < part_count_; ++part) {
            part_firsts_.push_back(here() - first);
            for (; next != triangles.end() && mesh_.triangles[*next].part == part; ++next)
                for (const uint32_t corner : mesh_.triangles[*next].corners) level_.indices.push_back(corner);
        }
        part_firsts_.push_back(here() - first);
        return {first, here() - first};
    }

    model::IndexRange add_fused(const ZoneLists &clean, const ZoneLists &touching)
    {
        const uint32_t first = here();
        std::vector<size_t> next_clean(clean.size()), next_touching(touching.size());  // positions in the lists
        for (uint32_t part = 0; part < part_count_; ++part) {
            part_firsts_.push_back(here() - first);
            for (uint32_t z = 0; z < clean.size(); ++z)
                for (size_t &next = next_clean[z]; is_next(clean[z], next, part); ++next)
                    add_slotted(clean[z][next], z, false);
            for (uint32_t z = 0; z < touching.size(); ++z)
                for (size_t &next = next_touching[z]; is_next(touching[z], next, part); ++next)
                    add_slotted(touching[z][next], z, z != zones_.of(touching[z][next])[0]);
        }
        part_firsts_.push_back(here() - first);
        return {first, here() - first};
    }

    bool is_next(const std::vector<size_t> &triangles, size_t next, uint32_t part) const
    {
        return next < triangles.size() && mesh_.triangles[triangles[next]].part == part;
    }

    void add_slotted(size_t triangle, uint32_t zone, bool raised)
    {
        const uint16_t slot = static_cast<uint16_t>(2 * zone + (raised ? 1 : 0));
        for (const uint32_t corner : mesh_.triangles[triangle].corners)
            level_.indices.push_back(vertex_of(corner, slot));
    }

    // The first slot that uses a source vertex gets the vertex itself, every further slot a copy.
    uint32_t vertex_of(uint32_t source, uint16_t slot)
    {
        if (level_.slots[source] == no_slot) level_.slots[source] = slot;
        if (level_.slots[source] == slot) return source;
        const uint32_t next = level_.source_count + static_cast<uint32_t>(level_.copies.size());
        const auto [found, is_new] = copies_.emplace(uint64_t(source) << 16 | slot, next);
        if (is_new) {
            level_.copies.push_back(source);
            level_.slots.push_back(slot);
        }
        return found->second;
    }

    uint32_t here() const
    {
        if (level_.indices.size() >= none) base::fail(CLQ_LIMIT, "more than %u indices in one level", none);
        return static_cast<uint32_t>(level_.indices.size());
    }

    const Mesh &mesh_;
    const TriangleZones &zones_;
    const uint32_t part_count_;
    model::Level &level_;
    std::vector<uint32_t> part_firsts_;  // of the current surface
    std::unordered_map<uint64_t, uint32_t> copies_;
};

[[noreturn]] void refuse(size_t triangles, const char *where, size_t more, const ZoneLimits &limits)
{
    base::fail(
        CLQ_LIMIT,
        "%zu triangles%s show %zu zones besides their first, and %llu are the most for the %llu bytes read; "
        "%zu zones are too many: fewer come from materials joined in the file, or from a zone map of fewer colours "
        "and specks (--propose N or --zones PNG of claque prepare, clq_asset_set_zone_map)",
        triangles, where, more, base::big(limits.bytes / TriangleZones::bytes_per_zone), base::big(limits.source_bytes),
        limits.zones);
}

}  // namespace

ZoneImages::ZoneImages(const model::Array<model::Texture> &textures)
{
    for (const model::Texture &texture : textures) {
        zone_counts.push_back(texture.keys.size());
        std::vector<ZoneImage> &sets = images.emplace_back();
        if (texture.keys.size() == 1) continue;
        sets.push_back(zone_image_of(texture, texture));
        for (const model::TextureImage &other : texture.set_images) sets.push_back(zone_image_of(texture, other));
    }
}

TriangleZones zones_of_triangles(const Mesh &mesh, const ZoneImages &zone_images, const ZoneLimits &limits)
{
    std::vector<ZoneCollector> collectors;
    for (size_t i = 0; i < zone_images.images.size(); ++i)
        collectors.emplace_back(zone_images.images[i], zone_images.zone_counts[i]);
    const uint64_t maximum = limits.bytes / TriangleZones::bytes_per_zone;
    TriangleZones out;
    out.first.push_back(0);
    for (const MeshTriangle &triangle : mesh.triangles) {
        UvTriangle uv;
        for (int k = 0; k < 3; ++k) uv.corners[k] = mesh.vertices[triangle.corners[static_cast<size_t>(k)]].uv;
        const uint32_t texture = mesh.surfaces[triangle.surface].texture;
        collectors[texture].append(uv, out.zones);
        out.first.push_back(static_cast<uint32_t>(out.zones.size()));
        if (collectors[texture].texels() > limits.texels)
            base::fail(CLQ_LIMIT,
                       "%zu of %zu triangles cover more than the %llu texels that the bytes read allow: "
                       "a smaller max_texture_px (--texture-size of prepare) makes them fewer",
                       out.triangles(), mesh.triangles.size(), base::big(limits.texels));
        if (out.besides_first() > maximum) refuse(out.triangles(), "", out.besides_first(), limits);
    }
    return out;
}

uint64_t stream_bytes(const std::vector<TriangleZones> &levels, const ZoneLimits &limits)
{
    size_t triangles = 0, more = 0;
    for (const TriangleZones &level : levels) triangles += level.triangles(), more += level.besides_first();
    const uint64_t maximum = limits.bytes / TriangleZones::bytes_per_zone;
    if (more > maximum) refuse(triangles, " in all levels of detail", more, limits);
    return TriangleZones::bytes_per_zone * more;
}

void make_streams(const Mesh &mesh, const TriangleZones &zones, uint32_t part_count, model::Level &out)
{
    StreamMaker(mesh, zones, part_count, out).run();
}

}  // namespace claque::meshsplit
