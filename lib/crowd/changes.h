// The rows and groups of a crowd that were changed since a reader last asked (lib/scene). Edits mark them; a crowd
// without a reader marks nothing. The order of the edits does not matter.
#pragma once

#include "lib/base/bitmap.h"

namespace claque::crowd
{

struct Changes {
    explicit Changes(std::pmr::memory_resource *memory) : rows(memory), groups(memory) {}

    // Marks nothing beyond what was reserved: everything counts as changed then.
    void mark(base::Bitmap &of, uint32_t i) noexcept
    {
        if (of.has_room_for(i)) of.insert(i);
        else everything = true;
    }
    bool any() const { return everything || rows.count() > 0 || groups.count() > 0; }
    void clear() noexcept
    {
        rows.clear(), groups.clear();
        everything = false;
    }
    uint64_t bytes() const { return rows.bytes() + groups.bytes(); }

    base::Bitmap rows;    // of actors: one was made, destroyed or moved, or changed in extent or looks
    base::Bitmap groups;  // moved with all their members
    bool everything = true;
};

}  // namespace claque::crowd
