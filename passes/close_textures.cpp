#include "passes/close_textures.h"

#include <algorithm>
#include <new>

#include "lib/base/hash.h"
#include "lib/base/reserve.h"
#include "passes/close_image.h"
#include "passes/guard.h"
#include "passes/list_drawer.h"

namespace claque::passes
{

base::Status CloseTextures::make(const Gl11 &gl, const Preflight &preflight, const Array<PreparedTemplate> &templates,
                                 const draw::DrawList &list, uint32_t &left_out, DrawStats &stats)
{
    ++draw_;
    left_out = 0;
    base::Status status;
    try {
        choose(templates, list);
        names_.resize(picks_.size());
    } catch (const std::bad_alloc &) {
        status = base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory to choose and paint textures of single individuals");
    }
    if (status.ok() && !pending_.empty()) status = preflight.check_upload(gl);
    if (!status.ok()) {
        drop_pending_from(0);
        first_name_.clear();
        return status;
    }
    if (options_.close_per_draw != 0) drop_pending_from(options_.close_per_draw);
    make_room(gl);
    left_out = make_pending(gl, templates);
    stats.close_made += static_cast<uint32_t>(pending_.size()) - left_out;
    name_items(list);
    return status;
}

void CloseTextures::find_wishes(const Array<PreparedTemplate> &templates, const draw::DrawList &list)
{
    wishes_.clear();
    const PreparedTemplate *prepared = nullptr;
    for (uint32_t i = 0; i < list.items.size(); ++i) {
        const draw::Item &item = list.items[i];
        if (item.hooks || !shows(item) || !(item.vertices.any() || item.locals)) continue;
        if (!prepared || prepared->source != item.tmpl) prepared = find(templates, item.tmpl);
        const float at = item.eye_distance_m * list.distance_scale + list.min_distance_m;
        if (prepared->levels[item.level].shows_close && at < prepared->close_distance_m)
            wishes_.push_back({item.eye_distance_m, i});
    }
    std::sort(wishes_.begin(), wishes_.end());
}

// The nearest first, up to the first one that the budget has no room for. So none is left out that is nearer than one
// that is chosen, whatever the sizes of their textures.
void CloseTextures::choose(const Array<PreparedTemplate> &templates, const draw::DrawList &list)
{
    pending_.clear(), picks_.clear();
    first_name_.assign(list.items.size(), model::none);
    find_wishes(templates, list);
    const PreparedTemplate *prepared = nullptr;
    uint64_t bytes = 0;
    for (const Wish &wish : wishes_) {
        const draw::Item &item = list.items[wish.item];
        if (!prepared || prepared->source != item.tmpl) prepared = find(templates, item.tmpl);
        const size_t first = picks_.size(), made = pending_.size();
        pick(*prepared, item);
        const uint64_t more = new_bytes(first);
        if (bytes + more > options_.close_bytes) {
            picks_.resize(first);
            drop_pending_from(made);
            return;
        }
        bytes += more;
        for (size_t i = first; i < picks_.size(); ++i) slots_[picks_[i]].drawn = draw_;
        first_name_[wish.item] = static_cast<uint32_t>(first);
    }
}

// Adds a slot for each surface.
void CloseTextures::pick(const PreparedTemplate &prepared, const draw::Item &item)
{
    for (const model::Surface &surface : item.tmpl->levels[item.level].surfaces)
        picks_.push_back(slot_for(prepared, item, surface.texture));
}

// Of the last picks, what this draw did not want before them.
uint64_t CloseTextures::new_bytes(size_t first_pick) const
{
    uint64_t bytes = 0;
    const auto begin = picks_.begin() + std::ptrdiff_t(first_pick);
    for (auto at = begin; at != picks_.end(); ++at)
        if (slots_[*at].drawn != draw_ && std::find(begin, at, *at) == at) bytes += slots_[*at].bytes;
    return bytes;
}

uint32_t CloseTextures::slot_for(const PreparedTemplate &prepared, const draw::Item &item, uint32_t texture)
{
    const PreparedTexture &ready = prepared.textures[texture];
    const uint32_t image = item.texture_set < ready.close.size() ? item.texture_set : 0;
    const uint8_t *zone_rgb = item.zone_rgb ? item.zone_rgb : prepared.zone_rgb.data();
    rgb_.clear();
    for (const ZoneTest &test : ready.tests)
        rgb_.insert(rgb_.end(), zone_rgb + 3 * size_t(test.zone), zone_rgb + 3 * size_t(test.zone) + 3);
    const uint64_t hash = base::fnv_words(base::fnv_start, rgb_.data(), rgb_.size());
    for (auto [at, end] = by_hash_.equal_range(hash); at != end; ++at) {
        const Slot &slot = slots_[at->second];
        if (slot.source == item.tmpl && slot.texture == texture && slot.image == image && slot.rgb == rgb_)
            return at->second;
    }
    if (free_.empty()) {
        if (free_.capacity() <= slots_.size()) free_.reserve(2 * slots_.size() + 16);  // so that drop() cannot fail
        slots_.emplace_back(memory_);
        free_.push_back(static_cast<uint32_t>(slots_.size() - 1));
    }
    const uint32_t index = free_.back();
    Slot &slot = slots_[index];
    slot.rgb.assign(rgb_.begin(), rgb_.end());
    base::reserve_more(pending_);
    pixels_.resize(std::max<size_t>(pixels_.size(), size_t(4) * ready.close[image].width * ready.close[image].height));
    by_hash_.emplace(hash, index);
    free_.pop_back();
    pending_.push_back(index);
    slot.source = item.tmpl, slot.texture = texture, slot.image = image;
    slot.hash = hash, slot.bytes = ready.close[image].bytes, slot.drawn = 0, slot.name = 0;
    return index;
}

void CloseTextures::drop(uint32_t index)
{
    Slot &slot = slots_[index];
    for (auto [at, end] = by_hash_.equal_range(slot.hash); at != end; ++at)
        if (at->second == index) {
            by_hash_.erase(at);
            break;
        }
    if (slot.name != 0) held_ -= slot.bytes;
    slot.source = nullptr, slot.name = 0;
    free_.push_back(index);
}

void CloseTextures::drop_pending_from(size_t first)
{
    while (pending_.size() > first) {
        drop(pending_.back());
        pending_.pop_back();
    }
}

// What this draw does not want goes, the longest unwanted first. glDeleteTextures comes before any glPushAttrib, so
// that no pop brings a deleted name back.
void CloseTextures::make_room(const Gl11 &gl)
{
    uint64_t needed = held_;
    for (const uint32_t index : pending_) needed += slots_[index].bytes;
    while (needed > options_.close_bytes) {
        uint32_t oldest = model::none;
        for (uint32_t i = 0; i < slots_.size(); ++i)
            if (slots_[i].name != 0 && slots_[i].drawn != draw_ &&
                (oldest == model::none || slots_[i].drawn < slots_[oldest].drawn))
                oldest = i;
        if (oldest == model::none) return;
        needed -= slots_[oldest].bytes;
        gl.DeleteTextures(1, &slots_[oldest].name);
        drop(oldest);
    }
}

// Returns how many GL had no memory for; their slots are dropped.
uint32_t CloseTextures::make_pending(const Gl11 &gl, const Array<PreparedTemplate> &templates)
{
    if (pending_.empty()) return 0;
    const UploadGuard guard(gl);
    uint32_t failed = 0;
    for (const uint32_t index : pending_) {
        Slot &slot = slots_[index];
        gl.GenTextures(1, &slot.name);
        held_ += slot.bytes;
        if (upload(gl, *find(templates, slot.source), slot)) continue;
        gl.DeleteTextures(1, &slot.name);
        drop(index);
        ++failed;
    }
    return failed;
}

bool CloseTextures::upload(const Gl11 &gl, const PreparedTemplate &prepared, Slot &slot)
{
    const model::Texture &texture = prepared.source->textures[slot.texture];
    const CloseImage &image = prepared.textures[slot.texture].close[slot.image];
    const uint8_t *source = slot.image == 0 ? texture.rgba.data() : texture.set_images[slot.image - 1].rgba.data();
    paint_close_image(texture, source, image, slot.rgb.data(), pixels_.data());
    const auto set = [&](gl::Enum name, gl::Enum value) {
        gl.TexParameteri(gl::texture_2d, name, static_cast<int32_t>(value));
    };
    gl.BindTexture(gl::texture_2d, slot.name);
    set(gl::texture_min_filter, options_.close_nearest ? gl::nearest : gl::linear_mipmap_linear);
    set(gl::texture_mag_filter, options_.close_nearest ? gl::nearest : gl::linear);
    // Nothing is shown within half a texel of an edge that clamps, and GL_CLAMP would filter GL's border colour in.
    set(gl::wrap_s, gl::repeat), set(gl::wrap_t, gl::repeat);
    bool taken = true;
    uint32_t width = image.width, height = image.height;
    for (int32_t level = 0;; ++level) {
        gl.TexImage2D(gl::texture_2d, level, static_cast<int32_t>(gl::rgba8), static_cast<int32_t>(width),
                      static_cast<int32_t>(height), 0, gl::rgba, gl::unsigned_byte, pixels_.data());
        int32_t found = 0;  // without memory GL keeps the level as it was: without an image
        gl.GetTexLevelParameteriv(gl::texture_2d, level, gl::texture_width, &found);
        taken = taken && found == static_cast<int32_t>(width);
        if (options_.close_nearest || (width == 1 && height == 1)) return taken;
        halve(pixels_.data(), width, height);
    }
}

// An item without one of its textures shows none of them.
void CloseTextures::name_items(const draw::DrawList &list)
{
    for (size_t i = 0; i < picks_.size(); ++i) names_[i] = slots_[picks_[i]].name;
    for (size_t i = 0; i < list.items.size(); ++i) {
        if (first_name_[i] == model::none) continue;
        const auto begin = names_.begin() + std::ptrdiff_t(first_name_[i]);
        const auto count = std::ptrdiff_t(list.items[i].tmpl->levels[list.items[i].level].surfaces.size());
        if (std::find(begin, begin + count, 0u) != begin + count) first_name_[i] = model::none;
    }
}

void CloseTextures::destroy(const Gl11 &gl)
{
    for (const Slot &slot : slots_)
        if (slot.name != 0) gl.DeleteTextures(1, &slot.name);
    forget();
}

void CloseTextures::forget()
{
    slots_.clear(), free_.clear(), by_hash_.clear();
    picks_.clear(), pending_.clear(), first_name_.clear(), names_.clear();
    held_ = 0;
}

}  // namespace claque::passes
