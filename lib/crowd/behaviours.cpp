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
      first_use_(memory),
      motions_(memory),
      uses_(memory),
      commands_(memory),
      root_motions_(memory)
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
    reserve_one(first_use_);
    reserve_one(motions_);
}

void Behaviours::push_row()
{
    first_use_.push_back(none);
    motions_.push_back(none);
}

void Behaviours::free_use(uint32_t index)
{
    Use &use = uses_[index];
    if (use.command != none) {
        commands_[use.command].choice = free_command_;
        free_command_ = use.command;
    }
    use = Use();
    use.next = free_use_;
    free_use_ = index;
}

void Behaviours::clear_row(uint32_t row)
{
    while (first_use_[row] != none) {
        const uint32_t index = first_use_[row];
        first_use_[row] = uses_[index].next;
        free_use(index);
    }
    move_root(row, RootMotion());
}

bool Behaviours::blends(uint32_t row) const
{
    for (uint32_t i = first_use_[row]; any_blend_ && i != none; i = uses_[i].next)
        if (const Idle *idle = std::get_if<Idle>(&mechanisms_[uses_[i].mechanism].kind); idle && idle->fade_s > 0)
            return true;
    return false;
}

uint32_t Behaviours::find_use(uint32_t row, uint32_t mechanism) const
{
    uint32_t i = first_use_[row];
    while (i != none && uses_[i].mechanism != mechanism) i = uses_[i].next;
    return i;
}

void Behaviours::unlink(uint32_t row, uint32_t index)
{
    uint32_t *link = &first_use_[row];
    while (*link != index) link = &uses_[*link].next;
    *link = uses_[index].next;
}

// Behind all of its priority or less.
void Behaviours::link(uint32_t row, uint32_t index)
{
    uint32_t *link = &first_use_[row];
    while (*link != none && uses_[*link].priority <= uses_[index].priority) link = &uses_[*link].next;
    uses_[index].next = *link;
    *link = index;
}

void Behaviours::use(uint32_t row, const Use &use)
{
    const uint32_t known = find_use(row, use.mechanism);
    if (known != none) {
        Use &there = uses_[known];
        const bool moves = there.priority != use.priority;
        if (moves) unlink(row, known);
        there.priority = use.priority, there.phase_s = use.phase_s, there.start_s = use.start_s;
        if (moves) link(row, known);
        return;
    }
    uint32_t count = 0;
    for (uint32_t i = first_use_[row]; i != none; i = uses_[i].next) ++count;
    if (count == most_uses) fail(CLQ_LIMIT, "an actor uses at most %u mechanisms", most_uses);
    reserve_slot(uses_, free_use_);
    const uint32_t index = take(uses_, free_use_, [](const Use &u) { return u.next; });
    uses_[index] = use;
    uses_[index].command = none;
    link(row, index);
}

void Behaviours::drop(uint32_t row, uint32_t mechanism)
{
    const uint32_t index = find_use(row, mechanism);
    if (index == none) return;
    unlink(row, index);
    free_use(index);
}

Command &Behaviours::command(uint32_t row, uint32_t mechanism)
{
    const uint32_t index = find_use(row, mechanism);
    if (index == none) fail(CLQ_ARGUMENT, "the actor does not use mechanism %u", mechanism + 1);
    if (uses_[index].command == none) {
        reserve_slot(commands_, free_command_);
        uses_[index].command = take(commands_, free_command_, [](const Command &c) { return c.choice; });
    }
    return commands_[uses_[index].command];
}

void Behaviours::move_root(uint32_t row, const RootMotion &motion)
{
    uint32_t &slot = motions_[row];
    if (motion.path == none) {
        if (slot == none) return;
        root_motions_[slot].path = free_motion_;
        free_motion_ = slot;
        slot = none;
        return;
    }
    if (slot == none) {
        reserve_slot(root_motions_, free_motion_);
        slot = take(root_motions_, free_motion_, [](const RootMotion &m) { return m.path; });
    }
    root_motions_[slot] = motion;
}

void Behaviours::copy_row(uint32_t from, uint32_t to)
{
    try {
        for (uint32_t i = first_use_[from]; i != none; i = uses_[i].next) {
            use(to, Use(uses_[i]));
            if (uses_[i].command == none) continue;
            const Command told = commands_[uses_[i].command];
            command(to, uses_[i].mechanism) = told;
        }
        if (has_root_motion(from)) move_root(to, RootMotion(root_motion(from)));
    } catch (...) {
        clear_row(to);
        throw;
    }
}

uint64_t Behaviours::bytes() const
{
    return mechanisms_.capacity() * sizeof(Mechanism) + written_.capacity() * sizeof(uint32_t) +
           paths_.capacity() * sizeof(RootPath) + (first_use_.capacity() + motions_.capacity()) * sizeof(uint32_t) +
           uses_.capacity() * sizeof(Use) + commands_.capacity() * sizeof(Command) +
           root_motions_.capacity() * sizeof(RootMotion);
}

}  // namespace claque::crowd
