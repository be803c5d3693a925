#include "lib/crowd/behaviours.h"

#include "lib/base/error.h"
#include "lib/crowd/reserve.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

// A slot of a pool whose free ones form a chain through `next`; the caller has reserved one.
template <class T, class Next>
uint32_t take(Array<T> &pool, uint32_t &first_free, const Next &next)
{
    if (first_free == none) {
        pool.emplace_back();
        return static_cast<uint32_t>(pool.size() - 1);
    }
    const uint32_t slot = first_free;
    first_free = next(pool[slot]);
    pool[slot] = T();
    return slot;
}

template <class T>
void reserve_slot(Array<T> &pool, uint32_t first_free)
{
    if (first_free == none) reserve_one(pool);
}

}  // namespace

Behaviours::Behaviours(std::pmr::memory_resource *memory)
    : mechanisms_(memory),
      written_(memory),
      paths_(memory),
      first_attachment_(memory),
      root_path_play_of_(memory),
      attachments_(memory),
      command_histories_(memory),
      root_path_plays_(memory)
{
}

uint32_t Behaviours::add(Mechanism &&mechanism, base::Span<const uint32_t> written)
{
    reserve_one(mechanisms_);
    written_.reserve(written_.size() + written.count);
    mechanism.first_dof = static_cast<uint32_t>(written_.size());
    mechanism.dof_count = written.count;
    written_.insert(written_.end(), written.begin(), written.end());
    if (const HostMechanism *host = std::get_if<HostMechanism>(&mechanism.kind)) {
        any_host_ = true;
        any_memory_ = any_memory_ || host->memory;
    }
    if (const Idle *idle = std::get_if<Idle>(&mechanism.kind)) any_blend_ = any_blend_ || idle->fade_s > 0;
    mechanisms_.push_back(std::move(mechanism));
    return static_cast<uint32_t>(mechanisms_.size() - 1);
}

uint32_t Behaviours::add(RootPath &&path)
{
    reserve_one(paths_);
    paths_.push_back(std::move(path));
    return static_cast<uint32_t>(paths_.size() - 1);
}

void Behaviours::reserve_row()
{
    reserve_one(first_attachment_);
    reserve_one(root_path_play_of_);
}

void Behaviours::push_row()
{
    first_attachment_.push_back(none);
    root_path_play_of_.push_back(none);
}

void Behaviours::free_attachment(uint32_t index)
{
    MechanismAttachment &attachment = attachments_[index];
    if (attachment.command_history != none) {
        command_histories_[attachment.command_history].choice = free_command_history_;
        free_command_history_ = attachment.command_history;
    }
    attachment = MechanismAttachment();
    attachment.next = free_attachment_;
    free_attachment_ = index;
}

void Behaviours::clear_row(uint32_t row)
{
    while (first_attachment_[row] != none) {
        const uint32_t index = first_attachment_[row];
        first_attachment_[row] = attachments_[index].next;
        free_attachment(index);
    }
    play_root_path(row, RootPathPlay());
}

bool Behaviours::blends(uint32_t row) const
{
    for (uint32_t i = first_attachment_[row]; any_blend_ && i != none; i = attachments_[i].next)
        if (const Idle *idle = std::get_if<Idle>(&mechanisms_[attachments_[i].mechanism].kind);
            idle && idle->fade_s > 0)
            return true;
    return false;
}

uint32_t Behaviours::find_attachment(uint32_t row, uint32_t mechanism) const
{
    uint32_t i = first_attachment_[row];
    while (i != none && attachments_[i].mechanism != mechanism) i = attachments_[i].next;
    return i;
}

void Behaviours::unlink(uint32_t row, uint32_t index)
{
    uint32_t *link = &first_attachment_[row];
    while (*link != index) link = &attachments_[*link].next;
    *link = attachments_[index].next;
}

// Behind all of its priority or less.
void Behaviours::link(uint32_t row, uint32_t index)
{
    uint32_t *link = &first_attachment_[row];
    while (*link != none && attachments_[*link].priority <= attachments_[index].priority)
        link = &attachments_[*link].next;
    attachments_[index].next = *link;
    *link = index;
}

void Behaviours::attach_mechanism(uint32_t row, const MechanismAttachment &attachment)
{
    const uint32_t known = find_attachment(row, attachment.mechanism);
    if (known != none) {
        MechanismAttachment &there = attachments_[known];
        const bool moves = there.priority != attachment.priority;
        if (moves) unlink(row, known);
        there.priority = attachment.priority, there.phase_s = attachment.phase_s, there.start_s = attachment.start_s;
        if (moves) link(row, known);
        return;
    }
    uint32_t count = 0;
    for (uint32_t i = first_attachment_[row]; i != none; i = attachments_[i].next) ++count;
    if (count == max_mechanisms) fail(CLQ_LIMIT, "an actor uses at most %u mechanisms", max_mechanisms);
    reserve_slot(attachments_, free_attachment_);
    const uint32_t index = take(attachments_, free_attachment_, [](const MechanismAttachment &u) { return u.next; });
    attachments_[index] = attachment;
    attachments_[index].command_history = none;
    link(row, index);
}

void Behaviours::detach_mechanism(uint32_t row, uint32_t mechanism)
{
    const uint32_t index = find_attachment(row, mechanism);
    if (index == none) return;
    unlink(row, index);
    free_attachment(index);
}

CommandHistory &Behaviours::command_history(uint32_t row, uint32_t mechanism)
{
    const uint32_t index = find_attachment(row, mechanism);
    if (index == none) fail(CLQ_ARGUMENT, "the actor does not use mechanism %u", mechanism + 1);
    if (attachments_[index].command_history == none) {
        reserve_slot(command_histories_, free_command_history_);
        attachments_[index].command_history =
            take(command_histories_, free_command_history_, [](const CommandHistory &c) { return c.choice; });
    }
    return command_histories_[attachments_[index].command_history];
}

void Behaviours::play_root_path(uint32_t row, const RootPathPlay &root_play)
{
    uint32_t &slot = root_path_play_of_[row];
    if (root_play.path == none) {
        if (slot == none) return;
        root_path_plays_[slot].path = free_root_path_play_;
        free_root_path_play_ = slot;
        slot = none;
        return;
    }
    if (slot == none) {
        reserve_slot(root_path_plays_, free_root_path_play_);
        slot = take(root_path_plays_, free_root_path_play_, [](const RootPathPlay &m) { return m.path; });
    }
    root_path_plays_[slot] = root_play;
}

void Behaviours::copy_row(uint32_t from, uint32_t to)
{
    try {
        for (uint32_t i = first_attachment_[from]; i != none; i = attachments_[i].next) {
            attach_mechanism(to, MechanismAttachment(attachments_[i]));
            if (attachments_[i].command_history == none) continue;
            const CommandHistory history = command_histories_[attachments_[i].command_history];
            command_history(to, attachments_[i].mechanism) = history;
        }
        if (has_root_path_play(from)) play_root_path(to, RootPathPlay(root_path_play(from)));
    } catch (...) {
        clear_row(to);
        throw;
    }
}

uint64_t Behaviours::bytes() const
{
    return mechanisms_.capacity() * sizeof(Mechanism) + written_.capacity() * sizeof(uint32_t) +
           paths_.capacity() * sizeof(RootPath) +
           (first_attachment_.capacity() + root_path_play_of_.capacity()) * sizeof(uint32_t) +
           attachments_.capacity() * sizeof(MechanismAttachment) +
           command_histories_.capacity() * sizeof(CommandHistory) + root_path_plays_.capacity() * sizeof(RootPathPlay);
}

}  // namespace claque::crowd
