// Who uses which control mechanism, and which way its Skeleton Root goes (S0 3, 5.3, 7.1). One row an actor, as in Crowd,
// which owns this and keeps the rows in step. Calls throw base::Error or std::bad_alloc and then change nothing.
#pragma once

#include "lib/base/span.h"
#include "lib/crowd/mechanism.h"

namespace claque::crowd
{

class Behaviours
{
public:
    explicit Behaviours(std::pmr::memory_resource *memory);

    // Descriptions, checked by who makes them. `written`: every degree of freedom that it may write.
    uint32_t add(Mechanism &&mechanism, base::Span<const uint32_t> written);
    uint32_t add(RootPath &&path);
    uint32_t mechanism_count() const { return static_cast<uint32_t>(mechanisms_.size()); }
    uint32_t path_count() const { return static_cast<uint32_t>(paths_.size()); }
    const Mechanism &mechanism(uint32_t i) const { return mechanisms_[i]; }
    const RootPath &path(uint32_t i) const { return paths_[i]; }
    base::Span<const uint32_t> written(const Mechanism &m) const
    {
        return {written_.data() + m.first_dof, m.dof_count};
    }

    // Rows.
    void reserve_row();
    void push_row();
    void pop_row() { first_use_.pop_back(), motions_.pop_back(); }  // a clear one
    void clear_row(uint32_t row);
    void copy_row(uint32_t from, uint32_t to);  // `to` is clear; may throw and then it is still

    void use(uint32_t row, const Use &use);
    void drop(uint32_t row, uint32_t mechanism);
    Command &command(uint32_t row,
                     uint32_t mechanism);  // of this use, made when there is none yet; throws CLQ_ARGUMENT
    void move_root(uint32_t row, const RootMotion &motion);

    bool blends(uint32_t row) const;  // whether idle clips fade into each other
    bool has_uses(uint32_t row) const { return first_use_[row] != model::none; }
    uint32_t first_use(uint32_t row) const { return first_use_[row]; }
    const Use &use_at(uint32_t i) const { return uses_[i]; }
    const Command *command_of(const Use &use) const
    {
        return use.command == model::none ? nullptr : &commands_[use.command];
    }
    bool has_root_motion(uint32_t row) const { return motions_[row] != model::none; }
    const RootMotion &root_motion(uint32_t row) const { return root_motions_[motions_[row]]; }

    bool any_host() const { return any_host_; }      // whether there is a mechanism of the host's
    bool any_blend() const { return any_blend_; }    // whether there are idle clips that fade into each other
    bool any_memory() const { return any_memory_; }  // and one that keeps a memory
    uint64_t bytes() const;

private:
    bool any_host_ = false, any_memory_ = false, any_blend_ = false;
    uint32_t find_use(uint32_t row, uint32_t mechanism) const;  // none: it does not
    void link(uint32_t row, uint32_t index);
    void unlink(uint32_t row, uint32_t index);
    void free_use(uint32_t index);

    Array<Mechanism> mechanisms_;
    Array<uint32_t> written_;
    Array<RootPath> paths_;
    Array<uint32_t> first_use_;  // by row
    Array<uint32_t> motions_;    // by row, of root_motions_
    Array<Use> uses_;
    Array<Command> commands_;
    Array<RootMotion> root_motions_;
    uint32_t free_use_ = model::none, free_command_ = model::none, free_motion_ = model::none;
};

}  // namespace claque::crowd
