#include "animcache/keyposes.h"

#include <algorithm>

#include "lib/base/held_bytes.h"
#include "lib/base/slack.h"

namespace claque::animcache
{

KeyPoses::KeyPoses(std::pmr::memory_resource *memory, const KeyPoseSettings &settings, VertexFormat vertex_format)
    : memory_(memory),
      settings_(settings),
      vertex_format_(vertex_format),
      owners_(memory),
      stores_(memory),
      retired_(memory),
      work_(memory),
      requested_(memory)
{
    shared_ = {memory, settings.budget_bytes, 0};
}

void KeyPoses::reserve(uint32_t request_count, base::Span<const model::Template *const> templates)
{
    if (!settings_.any()) return;
    base::reserve_with_slack(requested_, request_count);
    uint32_t same = 0;
    while (same < owners_.size() && same < templates.count && owners_[same].tmpl == templates[same]) ++same;
    if (same < owners_.size()) {  // another state of the crowd: its templates may have another order
        owners_.clear();
        if (retired_.empty()) retired_.swap(stores_);
        else stores_.clear();
        shared_.bytes = 0;
        same = 0;
    }
    while (!stores_.empty() && stores_.size() > (owners_.empty() ? 0 : owners_.back().end_store)) stores_.pop_back();
    owners_.reserve(templates.count);
    size_t poses = work_.capacity();
    for (uint32_t t = same; t < templates.count; ++t) {
        const model::Template &tmpl = *templates[t];
        const uint32_t first = static_cast<uint32_t>(stores_.size());
        Owner owner{&tmpl, first, first + static_cast<uint32_t>(tmpl.levels.size()),
                    KeyPoseTable(memory_, tmpl, settings_.rate_hz)};
        stores_.reserve(stores_.size() + tmpl.levels.size());
        work_.reserve(poses += size_t(std::min(owner.table.count(), settings_.max_kept)) * tmpl.levels.size());
        for (const model::Level &level : tmpl.levels)
            stores_.emplace_back(memory_, owner.table.count(), vertex_floats(level, vertex_format_));
        owners_.push_back(std::move(owner));
    }
}

uint64_t KeyPoses::book_bytes() const
{
    uint64_t sum = base::held_bytes(owners_, stores_, retired_, work_, requested_);
    for (const Owner &owner : owners_) sum += owner.table.bytes();
    for (const KeyPoseStore &store : stores_) sum += store.book_bytes();
    return sum;
}

KeyPoseSelection KeyPoses::select(uint32_t tmpl, uint32_t level, KeyPoseMode mode, uint32_t clip, double time_s) const
{
    KeyPoseSelection selection = owners_[tmpl].table.select(mode, clip, time_s);
    selection.tmpl = tmpl;
    selection.store = owners_[tmpl].first_store + level;
    return selection;
}

// When the budget is spent, templates and levels that no individual shows in this update release their key-poses.
void KeyPoses::make_room()
{
    bool short_of_room = false;
    for (const KeyPoseStore &store : stores_)
        short_of_room = short_of_room || store.is_short_of_room(settings_.max_kept, shared_);
    if (!short_of_room) return;
    for (KeyPoseStore &store : stores_)
        if (store.is_idle() && !store.was_used_since(listed_from_)) store.release(shared_);
}

// Key-poses that were to be skinned are not.
void KeyPoses::undo()
{
    for (KeyPoseStore &store : stores_) store.drop_fresh();
    work_.clear();
}

void KeyPoses::commit()
{
    for (KeyPoseStore &store : stores_) store.keep_fresh();
    retired_.clear();
    listed_from_ = ~uint64_t(0);
    last_listed_ = frame_number_;
}

void KeyPoses::choose(std::pmr::vector<Request> &requests)
{
    counters_ = KeyPoseCounters();
    work_.clear();
    if (!settings_.any()) return;
    ++frame_number_;
    requested_.clear();
    for (KeyPoseStore &store : stores_) store.begin(frame_number_);
    for (uint32_t i = 0; i < requests.size(); ++i) {
        const KeyPoseSelection &selection = requests[i].key_pose;
        if (!shows_key_poses(selection.mode)) continue;
        requested_.push_back(i);
        stores_[selection.store].want(selection.first, selection.second);
    }
    for (KeyPoseStore &store : stores_) store.close();
    make_room();
    for (KeyPoseStore &store : stores_) store.choose(settings_.max_kept, shared_);
    for (const uint32_t i : requested_) {
        KeyPoseSelection &selection = requests[i].key_pose;
        selection.kept[0] = stores_[selection.store].find(selection.first);
        selection.kept[1] =
            selection.second == selection.first ? selection.kept[0] : stores_[selection.store].find(selection.second);
        counters_.served += selection.served();
    }
    counters_.requested = static_cast<uint32_t>(requested_.size());
    list_work();
}

void KeyPoses::list_work()
{
    for (const Owner &owner : owners_)
        for (uint32_t level = 0; level < owner.tmpl->levels.size(); ++level) {
            const KeyPoseStore &store = stores_[owner.first_store + level];
            for (const KeyPoseStore::Fresh &fresh : store.fresh()) {
                Work work;
                work.request.tmpl = owner.tmpl;
                work.request.level = level;
                work.request.pose.clip = owner.table.at(fresh.pose).clip;
                work.request.pose.clip_time_s = owner.table.at(fresh.pose).time_s;
                work.vertices = fresh.vertices;
                work_.push_back(work);
            }
            counters_.wanted += store.wanted();
            counters_.held += store.held();
        }
    counters_.updated = static_cast<uint32_t>(work_.size());
    counters_.bytes = shared_.bytes;
}

void KeyPoses::make(const base::Jobs &jobs, ScratchPool &scratch)
{
    if (work_.empty()) return;
    const uint32_t slices = scratch.slice_count(), count = static_cast<uint32_t>(work_.size());
    jobs.for_each(slices, [&](uint32_t slice) {
        const Scratch mine = scratch.slice(slice);
        const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (slice + 1) / slices);
        for (uint32_t i = static_cast<uint32_t>(uint64_t(count) * slice / slices); i < last; ++i) {
            animate(work_[i].request, mine, mine.palette);
            skin(work_[i].request, mine.palette, vertex_format_, mine, work_[i].vertices);
        }
    });
}

}  // namespace claque::animcache
