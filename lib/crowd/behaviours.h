// Attachments of control mechanisms and root paths to actors (S0 3, 5.3, 7.1). One row per actor, as in Crowd, which
// owns this table and keeps its rows in step. Calls throw base::Error or std::bad_alloc and change nothing then.
#pragma once

#include "lib/base/slot_map.h"
#include "lib/base/span.h"
#include "lib/crowd/mechanism.h"

namespace claque::crowd
{

class Behaviours
{
public:
    explicit Behaviours(std::pmr::memory_resource *memory);

    // Descriptions, checked by the caller. `written`: every degree of freedom that it may write.
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
    void push_row() noexcept;
    void clear_row(uint32_t row) noexcept;
    void reserve_copy(uint32_t from);                    // before copy_row
    void copy_row(uint32_t from, uint32_t to) noexcept;  // `to` is clear

    void attach_mechanism(uint32_t row, const MechanismAttachment &attachment);
    void detach_mechanism(uint32_t row, uint32_t mechanism);
    // The commands of this attachment, created if it has none yet. Throws base::Error (CLQ_ARGUMENT) if the mechanism
    // is not attached.
    CommandHistory &command_history(uint32_t row, uint32_t mechanism);
    void play_root_path(uint32_t row, const RootPathPlay &root_play);

    bool blends(uint32_t row) const;  // whether idle clips fade into each other
    bool has_mechanisms(uint32_t row) const { return first_attachment_[row] != model::none; }
    uint32_t first_attachment(uint32_t row) const { return first_attachment_[row]; }
    const MechanismAttachment &attachment_at(uint32_t i) const { return attachments_[i]; }
    uint32_t find_attachment(uint32_t row, uint32_t mechanism) const;  // none: not attached to this actor
    const MechanismAttachment &attachment_of(uint32_t row,
                                             uint32_t mechanism) const;  // throws base::Error (CLQ_ARGUMENT) instead
    const CommandHistory *command_history_of(const MechanismAttachment &attachment) const
    {
        return attachment.command_history == model::none ? nullptr : &command_histories_[attachment.command_history];
    }
    bool has_root_path_play(uint32_t row) const { return root_path_play_of_[row] != model::none; }
    const RootPathPlay &root_path_play(uint32_t row) const { return root_path_plays_[root_path_play_of_[row]]; }

    bool any_host() const { return any_host_; }      // whether a host mechanism exists
    bool any_blend() const { return any_blend_; }    // whether idle clips exist that fade into each other
    bool any_memory() const { return any_memory_; }  // and a host mechanism with a memory
    uint64_t bytes() const;

private:
    void link(uint32_t row, uint32_t index) noexcept;
    void unlink(uint32_t row, uint32_t index) noexcept;
    void free_attachment(uint32_t index) noexcept;

    Array<Mechanism> mechanisms_;
    Array<uint32_t> written_;
    Array<RootPath> paths_;
    Array<uint32_t> first_attachment_;   // by row
    Array<uint32_t> root_path_play_of_;  // by row, of root_motions_
    base::SlotMap<MechanismAttachment> attachments_;
    base::SlotMap<CommandHistory> command_histories_;
    base::SlotMap<RootPathPlay> root_path_plays_;
    bool any_host_ = false, any_memory_ = false, any_blend_ = false;
};

}  // namespace claque::crowd
