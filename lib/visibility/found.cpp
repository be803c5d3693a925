#include "lib/visibility/found.h"

#include <algorithm>

namespace claque::visibility
{

Numbers::Numbers(const draw::DrawList &list, std::pmr::memory_resource *memory) : list_(list), firsts_(memory)
{
    firsts_.reserve(list.items.size() + 1);
    uint64_t next = 0;
    for (const draw::Item &item : list.items) {
        firsts_.push_back(next);
        next += draw::triangle_count(item.tmpl->levels[item.level]);
    }
    firsts_.push_back(next);
}

Found Numbers::find(uint64_t number) const
{
    Found found;
    found.item = static_cast<uint32_t>(std::upper_bound(firsts_.begin(), firsts_.end(), number) - firsts_.begin()) - 1;
    const draw::Item &item = list_.items[found.item];
    const model::Level &level = item.tmpl->levels[item.level];
    found.triangle = static_cast<uint32_t>(number - firsts_[found.item]);
    uint32_t left = 3 * found.triangle;
    bool met = false;
    draw::for_bins(level, [&](const model::Surface &surface, const model::IndexRange &range, uint32_t zone_index,
                              const uint32_t *parts) {
        if (met) return;
        if (left >= range.count) {
            left -= range.count;
            return;
        }
        met = true;
        const model::Texture &texture = item.tmpl->textures[surface.texture];
        found.texture = surface.texture;
        if (zone_index != model::none && !texture.has_holes) found.zone = texture.keys[zone_index].zone;
        found.corners = &level.indices[range.first + left];
        if (parts)
            found.part =
                static_cast<uint32_t>(std::upper_bound(parts, parts + level.parts.size() + 1, left) - parts) - 1;
    });
    return found;
}

}  // namespace claque::visibility
