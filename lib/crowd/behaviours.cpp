#include "lib/crowd/behaviours.h"

#include "lib/base/error.h"
#include "lib/base/reserve.h"

namespace claque::crowd
{

using base::fail;
using base::reserve_more;
using model::none;

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
    reserve_more(mechanisms_);
    reserve_more(written_, written.count);
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
    reserve_more(paths_);
    paths_.push_back(std::move(path));
    return static_cast<uint32_t>(paths_.size() - 1);
}

void Behaviours::reserve_row()
{
    reserve_more(first_attachment_);
    reserve_more(root_path_play_of_);
}

void Behaviours::push_row() noexcept
{
    first_attachment_.push_back(none);
    root_path_play_of_.push_back(none);
}

void Behaviours::free_attachment(uint32_t index) noexcept
{
    if (attachments_[index].command_history != none) command_histories_.free(attachments_[index].command_history);
    attachments_.free(index);
}

void Behaviours::clear_row(uint32_t row) noexcept
{
    for (uint32_t index = first_attachment_[row]; index != none;) {
        const uint32_t next = attachments_[index].next;
        free_attachment(index);
        index = next;
    }
    first_attachment_[row] = none;
    if (root_path_play_of_[row] != none) root_path_plays_.free(root_path_play_of_[row]);
    root_path_play_of_[row] = none;
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

const MechanismAttachment &Behaviours::attachment_of(uint32_t row, uint32_t mechanism) const
{
    const uint32_t index = find_attachment(row, mechanism);
    if (index == none) fail(CLQ_ARGUMENT, "mechanism %u is not attached to the actor", mechanism + 1);
    return attachments_[index];
}

void Behaviours::unlink(uint32_t row, uint32_t index) noexcept
{
    uint32_t *link = &first_attachment_[row];
    while (*link != index) link = &attachments_[*link].next;
    *link = attachments_[index].next;
}

// Insert after all attachments of the same or a lower priority.
void Behaviours::link(uint32_t row, uint32_t index) noexcept
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
    if (count == max_mechanisms) fail(CLQ_LIMIT, "an actor has at most %u mechanisms", max_mechanisms);
    attachments_.reserve();
    const uint32_t index = attachments_.take();
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
    attachment_of(row, mechanism);
    MechanismAttachment &attachment = attachments_[find_attachment(row, mechanism)];
    if (attachment.command_history == none) {
        command_histories_.reserve();
        attachment.command_history = command_histories_.take();
    }
    return command_histories_[attachment.command_history];
}

void Behaviours::play_root_path(uint32_t row, const RootPathPlay &root_play)
{
    uint32_t &slot = root_path_play_of_[row];
    if (root_play.path == none) {
        if (slot != none) root_path_plays_.free(slot);
        slot = none;
        return;
    }
    if (slot == none) {
        root_path_plays_.reserve();
        slot = root_path_plays_.take();
    }
    root_path_plays_[slot] = root_play;
}

void Behaviours::reserve_copy(uint32_t from)
{
    uint32_t uses = 0, commands = 0;
    for (uint32_t i = first_attachment_[from]; i != none; i = attachments_[i].next) {
        ++uses;
        commands += attachments_[i].command_history != none;
    }
    attachments_.reserve(uses);
    command_histories_.reserve(commands);
    if (root_path_play_of_[from] != none) root_path_plays_.reserve();
}

void Behaviours::copy_row(uint32_t from, uint32_t to) noexcept
{
    uint32_t *link = &first_attachment_[to];
    for (uint32_t i = first_attachment_[from]; i != none; i = attachments_[i].next) {
        const uint32_t index = attachments_.take();
        attachments_[index] = attachments_[i];
        if (attachments_[i].command_history != none) {
            attachments_[index].command_history = command_histories_.take();
            command_histories_[attachments_[index].command_history] =
                command_histories_[attachments_[i].command_history];
        }
        *link = index;
        link = &attachments_[index].next;
        *link = none;
    }
    if (root_path_play_of_[from] == none) return;
    root_path_play_of_[to] = root_path_plays_.take();
    root_path_plays_[root_path_play_of_[to]] = root_path_plays_[root_path_play_of_[from]];
}

uint64_t Behaviours::bytes() const
{
    return mechanisms_.capacity() * sizeof(Mechanism) + written_.capacity() * sizeof(uint32_t) +
           paths_.capacity() * sizeof(RootPath) +
           (first_attachment_.capacity() + root_path_play_of_.capacity()) * sizeof(uint32_t) + attachments_.bytes() +
           command_histories_.bytes() + root_path_plays_.bytes();
}

}  // namespace claque::crowd
