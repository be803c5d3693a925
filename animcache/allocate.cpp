// Room in the caches: blocks of individuals, within one budget. Before more memory is requested from the host,
// individuals unseen for so long that their pose is stale are evicted. When the budget is spent, all individuals that
// are invisible in this update may be evicted, unseen for longest first, ties in the order of requests. Visible
// individuals are never evicted.
#include "animcache/caches.h"

namespace claque::animcache
{

namespace
{

// At 60 updates a second, four times the slowest period: an older pose is useful only when time stands still.
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

// Slots in the order in which they were last seen; those of one update in the order of its requests.
void Caches::move_to_end(uint32_t slot)
{
    if (last_ == slot) return;
    Entry &entry = entries_[slot];
    if (entry.before != model::none) entries_[entry.before].after = entry.after;
    else if (first_ == slot) first_ = entry.after;
    if (entry.after != model::none) entries_[entry.after].before = entry.before;
    entry.before = last_;
    entry.after = model::none;
    if (last_ != model::none) entries_[last_].after = slot;
    else first_ = slot;
    last_ = slot;
}

// Evicts the individuals unseen for longest. False: all that hold blocks are visible in this update or were seen in the
// last `updates`.
bool Caches::evict_one(uint64_t updates)
{
    while (first_ != model::none && entries_[first_].last_seen + updates <= frame_number_ &&
           !is_listed(entries_[first_])) {
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
        // No room: the arena serves this update, and the next update tries again.
        if (!blocks_.trim() && !evict_one(1)) return nullptr;
    }
}

std::pmr::vector<Request> &Caches::begin(bool can_undo)
{
    begin_over(can_undo);
    requests_.clear();
    return requests_;
}

void Caches::begin_over(bool can_undo)
{
    ++frame_number_;
    listed_from_ = can_undo ? last_listed_ : ~uint64_t(0);
    if (can_undo) requests_.swap(requests_before_);
    replaced_.clear();
    key_poses_.begin(can_undo);
    Counters next;
    next.evicted = counters_.evicted;
    counters_ = next;
    arena_.reset();
}

void Caches::undo()
{
    requests_.swap(requests_before_);
    replaced_.clear();
    key_poses_.undo();
}

void Caches::allocate_poses()
{
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        const Request &request = requests_[i];
        if (!request.tmpl) continue;
        Entry &entry = entries_[request.slot];
        if (entry.tmpl != request.tmpl) {
            if (entry.tmpl && is_listed(entry)) replaced_.push_back(i);
            else {
                release(entry, &Entry::palette);
                release(entry, &Entry::vertices);
                entry.tmpl = request.tmpl;
            }
        }
        entry.last_seen = frame_number_;
        move_to_end(request.slot);
    }
    key_poses_.choose(requests_);
    without_room_ = 0;
    animate_.clear();
    // Palettes first: they are small and save more work per byte. Vertices are cached only beside a palette.
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        Request &request = requests_[i];
        request.palette = nullptr;
        if (!request.tmpl || !request.needs_palette()) continue;
        Entry &entry = entries_[request.slot];
        const bool replaced = entry.tmpl != request.tmpl;
        if (!entry.palette && !replaced && settings_.mode != Mode::none) entry.palette = take(entry, &Entry::palette);
        request.palette = replaced ? nullptr : entry.palette;
        note_pose(i, entry);
        if (request.palette) continue;
        request.palette = arena_.take(block_bytes(*request.tmpl, &Entry::palette));
        ++without_room_;
    }
}

// Whether the pose must be evaluated. What has no room in a cache is listed by animate().
void Caches::note_pose(uint32_t i, const Entry &entry)
{
    if (!is_due(requests_[i])) {
        ++counters_.palette_served;
        return;
    }
    ++counters_.due;
    if (entry.palette && requests_[i].palette == entry.palette) animate_.push_back(i);
}

void Caches::allocate_vertices()
{
    skin_.clear();
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        Request &request = requests_[i];
        if (!request.tmpl) continue;
        Entry &entry = entries_[request.slot];
        const bool keeps = settings_.mode == Mode::full && (entry.palette || !request.needs_palette());
        // of a key-pose shown before: without a palette they cannot be renewed
        if (!keeps) release(entry, &Entry::vertices);
        request.vertices = nullptr;
        if (!needs_vertices(request)) {
            counters_.left_out += request.drawn && request.needs_palette() && !request.palette;
            continue;
        }
        if (keeps && !entry.vertices) entry.vertices = take(entry, &Entry::vertices);
        const model::Level &level = request.tmpl->levels[request.level];
        request.vertices = entry.vertices ? entry.vertices
                                          : arena_.take(sizeof(float) * vertex_floats(level, settings_.vertex_format));
        note_vertices(i, entry);
    }
}

// Whether the vertices must be made.
void Caches::note_vertices(uint32_t i, const Entry &entry)
{
    const Request &request = requests_[i];
    if (!request.vertices) {
        ++counters_.left_out;
    } else if (request.vertices == entry.vertices && entry.vertices_key == request.pose &&
               entry.vertices_level == request.level) {
        ++counters_.vertices_served;
    } else {
        counters_.on_demand += settings_.mode == Mode::full && request.vertices != entry.vertices;
        skin_.push_back(i);
    }
}

}  // namespace claque::animcache
