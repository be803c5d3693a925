#include "animcache/keypose_choice.h"

#include <algorithm>

namespace claque::animcache
{

uint32_t choose_key_poses(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held, uint8_t *chosen)
{
    const auto missing = [held](const KeyPoseBin &bin) {
        if (!held) return 0;
        return int(!held[bin.first]) + int(bin.second != bin.first && !held[bin.second]);
    };
    std::sort(bins, bins + bin_count, [&](const KeyPoseBin &a, const KeyPoseBin &b) {
        if (a.count != b.count) return a.count > b.count;
        if (const int x = missing(a), y = missing(b); x != y) return x < y;
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    uint32_t used = 0;
    for (const KeyPoseBin *bin = bins; bin != bins + bin_count && used < capacity; ++bin) {
        const uint32_t more =
            uint32_t(!chosen[bin->first]) + uint32_t(bin->second != bin->first && !chosen[bin->second]);
        if (used + more > capacity) continue;
        chosen[bin->first] = chosen[bin->second] = 1;
        used += more;
    }
    return used;
}

}  // namespace claque::animcache
