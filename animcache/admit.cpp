// Room in the caches: blocks of an individual's own, within one budget. When it is spent, who is not seen in this
// update leaves, unseen for longest first, ties by row; who is seen is never thrown out.
#include <algorithm>
#include <utility>

#include "animcache/caches.h"

namespace claque::animcache
{

size_t Caches::block_bytes(const model::Template &tmpl, Block kind) const
{
    const Sizes sizes = sizes_of(tmpl, settings_.geometry);
    return sizeof(float) * (kind == &Entry::palette ? sizes.palette_floats : sizes.vertex_floats);
}

void Caches::release(Entry &entry, Block kind)
{
    if (!(entry.*kind)) return;
    const size_t bytes = block_bytes(*entry.tmpl, kind);
    memory_->deallocate(entry.*kind, bytes, alignof(math::F4));
    counters_.bytes -= bytes;
    entry.*kind = nullptr;
    (kind == &Entry::palette ? entry.palette_key : entry.vertices_key) = PoseKey();
}

void Caches::find_victims()
{
    victims_known_ = true;
    victims_.clear();
    for (uint32_t row = 0; row < entries_.size(); ++row)
        if (entries_[row].last_seen != serial_ && (entries_[row].palette || entries_[row].vertices))
            victims_.push_back(row);
    std::sort(victims_.begin(), victims_.end(), [this](uint32_t a, uint32_t b) {
        const uint64_t seen_a = entries_[a].last_seen, seen_b = entries_[b].last_seen;
        return seen_a != seen_b ? seen_a > seen_b : a > b;
    });
}

// Throws out the next victim, both its blocks; one of the right kind and size is taken over as it is.
bool Caches::evict_one(const Entry &wanted, Block kind, float **taken_over)
{
    if (!victims_known_) find_victims();
    if (victims_.empty()) return false;
    Entry &victim = entries_[victims_.back()];
    victims_.pop_back();
    counters_.evicted += (victim.palette != nullptr) + (victim.vertices != nullptr);
    if (victim.tmpl == wanted.tmpl) std::swap(*taken_over, victim.*kind);
    release(victim, &Entry::palette);
    release(victim, &Entry::vertices);
    victim.palette_key = victim.vertices_key = PoseKey();
    return true;
}

float *Caches::take(const Entry &wanted, Block kind)
{
    const size_t bytes = block_bytes(*wanted.tmpl, kind);
    if (bytes > settings_.budget_bytes) return nullptr;
    float *block = nullptr;
    while (counters_.bytes + bytes > settings_.budget_bytes) {
        if (!evict_one(wanted, kind, &block)) return nullptr;
        if (block) return block;
    }
    try {
        block = static_cast<float *>(memory_->allocate(bytes, alignof(math::F4)));
    } catch (...) {
        return nullptr;  // the individual is served while drawing; the next update asks again
    }
    counters_.bytes += bytes;
    return block;
}

std::pmr::vector<Request> &Caches::begin()
{
    ++serial_;
    victims_known_ = false;
    Counters next;
    next.evicted = counters_.evicted;
    next.bytes = counters_.bytes;
    counters_ = next;
    requests_.clear();
    return requests_;
}

void Caches::admit_poses()
{
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        Entry &entry = entries_[requests_[i].row];
        if (entry.tmpl != requests_[i].tmpl) {
            release(entry, &Entry::palette);
            release(entry, &Entry::vertices);
            entry.tmpl = requests_[i].tmpl;
        }
        entry.last_seen = serial_;
        entry.request = i;
    }
    // Palettes first: they are small, and save more of the work a byte. Vertices are nobody's without a palette.
    for (const Request &request : requests_) {
        Entry &entry = entries_[request.row];
        if (!entry.palette) entry.palette = take(entry, &Entry::palette);
    }
}

void Caches::admit_vertices()
{
    for (const Request &request : requests_) {
        Entry &entry = entries_[request.row];
        if (needs_vertices(request) && entry.palette && !entry.vertices) entry.vertices = take(entry, &Entry::vertices);
    }
}

}  // namespace claque::animcache
