// Room in the caches: blocks of an individual's own, within one budget. Who has been unseen so long that its pose is stale
// makes room before more is asked of the host; when the budget is spent, all who are not seen in this update do, unseen for
// longest first, ties by row. Who is seen is never thrown out.
#include "animcache/caches.h"

namespace claque::animcache
{

namespace
{

// At 60 a second, four times the slowest period: what is held then is of use in halted time alone.
constexpr uint64_t stale_updates = 64;

}  // namespace

size_t Caches::block_bytes(const model::Template &tmpl, Block kind) const
{
    const Sizes sizes = sizes_of(tmpl, settings_.vertex_format);
    return sizeof(float) * (kind == &Entry::palette ? sizes.palette_floats : sizes.vertex_floats);
}

void Caches::release(Entry &entry, Block kind)
{
    if (!(entry.*kind)) return;
    blocks_.deallocate(entry.*kind, block_bytes(*entry.tmpl, kind));
    entry.*kind = nullptr;
    (kind == &Entry::palette ? entry.palette_key : entry.vertices_key) = PoseKey();
}

// Rows in the order in which they were last seen; those of one update by row.
void Caches::move_to_end(uint32_t row)
{
    if (last_ == row) return;
    Entry &entry = entries_[row];
    if (entry.before != model::none) entries_[entry.before].after = entry.after;
    else if (first_ == row) first_ = entry.after;
    if (entry.after != model::none) entries_[entry.after].before = entry.before;
    entry.before = last_;
    entry.after = model::none;
    if (last_ != model::none) entries_[last_].after = row;
    else first_ = row;
    last_ = row;
}

// Takes the blocks of who is unseen for longest. False: nobody has any who is not seen in this update, or for `updates`.
bool Caches::evict_one(uint64_t updates)
{
    while (first_ != model::none && entries_[first_].last_seen + updates <= frame_number_) {
        Entry &victim = entries_[first_];
        first_ = victim.after;
        if (first_ != model::none) entries_[first_].before = model::none;
        else last_ = model::none;
        victim.after = model::none;
        const uint32_t blocks = (victim.palette != nullptr) + (victim.vertices != nullptr);
        counters_.evicted += blocks;
        release(victim, &Entry::palette);
        release(victim, &Entry::vertices);
        if (blocks > 0) return true;
    }
    return false;
}

float *Caches::take(const Entry &wanted, Block kind)
{
    const size_t bytes = block_bytes(*wanted.tmpl, kind);
    if (BlockPool::rounded_size(bytes) > settings_.budget_bytes) return nullptr;
    for (;;) {
        if (float *block = blocks_.allocate_from_slabs(bytes)) return block;
        if (evict_one(stale_updates)) continue;
        if (float *block = blocks_.allocate_new_slab(bytes)) return block;
        // Nobody's room: the individual is served while drawing, and the next update asks again.
        if (!blocks_.trim() && !evict_one(1)) return nullptr;
    }
}

std::pmr::vector<Request> &Caches::begin()
{
    ++frame_number_;
    Counters next;
    next.evicted = counters_.evicted;
    counters_ = next;
    requests_.clear();
    return requests_;
}

void Caches::allocate_poses()
{
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        Entry &entry = entries_[requests_[i].row];
        if (entry.tmpl != requests_[i].tmpl) {
            release(entry, &Entry::palette);
            release(entry, &Entry::vertices);
            entry.tmpl = requests_[i].tmpl;
        }
        entry.last_seen = frame_number_;
        entry.request = i;
        move_to_end(requests_[i].row);
    }
    key_poses_.choose(requests_);
    // Palettes first: they are small, and save more of the work a byte. Vertices are nobody's without a palette.
    for (const Request &request : requests_) {
        Entry &entry = entries_[request.row];
        if (!entry.palette && request.needs_palette()) entry.palette = take(entry, &Entry::palette);
    }
}

void Caches::allocate_vertices()
{
    for (const Request &request : requests_) {
        Entry &entry = entries_[request.row];
        const bool ready = entry.palette || !request.needs_palette();
        if (!ready) release(entry, &Entry::vertices);  // of key-poses that it showed: nothing to renew them from
        if (needs_vertices(request) && ready && !entry.vertices) entry.vertices = take(entry, &Entry::vertices);
    }
}

}  // namespace claque::animcache
