#include "samples/parity/ids.h"

#include <algorithm>

namespace parity
{
namespace
{

// True if any pixel round (x, y) meets the condition.
template <class Condition>
bool any_near(const Map<uint64_t> &ids, int x, int y, Condition fulfils)
{
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ids.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ids.width - 1); ++u)
            if (fulfils(ids.at(u, v))) return true;
    return false;
}

}  // namespace

bool at_border(const Map<uint64_t> &ids, int x, int y)
{
    const uint64_t own = ids.at(x, y);
    return any_near(ids, x, y, [own](uint64_t id) { return id != own; });
}

IdAgreement compare_ids(const Map<uint64_t> &reference, const Map<uint64_t> &result,
                        const std::vector<uint8_t> &seen_alike)
{
    IdAgreement out;
    out.marks = Map<Mark>(reference.width, reference.height, Mark::same);
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const size_t i = reference.index(x, y);
            if (!seen_alike.empty() && seen_alike[i] == 0) {
                out.marks.values[i] = Mark::ignored;
                continue;
            }
            ++out.compared;
            if (at_border(reference, x, y)) ++out.borders;
            const uint64_t seen = result.values[i];
            if (seen == reference.values[i]) continue;
            ++out.different;
            const bool moved = any_near(reference, x, y, [seen](uint64_t id) { return id == seen; });
            out.marks.values[i] = moved ? Mark::border : Mark::outside;
            if (moved) continue;
            if (out.outside++ > 0) continue;
            out.first_x = x;
            out.first_y = y;
        }
    return out;
}

Map<uint64_t> actor_ids(const Map<uint32_t> &actor)
{
    Map<uint64_t> out(actor.width, actor.height);
    std::copy(actor.values.begin(), actor.values.end(), out.values.begin());
    return out;
}

Map<uint64_t> zone_ids(const Map<uint32_t> &actor, const Map<uint16_t> &zone)
{
    Map<uint64_t> out(actor.width, actor.height);
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = uint64_t{actor.values[i]} << 16 | zone.values[i];
    return out;
}

}  // namespace parity
