#include "meshsplit/pyramid.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace claque::meshsplit
{

namespace
{

// One axis of a resampling, in units in which an old texel is `to` long and a new one `from` long.
struct Axis {
    uint64_t from, to;

    struct Range {
        uint64_t low, high;
    };
    Range box(uint32_t i) const { return {i * from, (i + 1) * from}; }
    Range grown(uint32_t i) const { return {i == 0 ? 0 : (i - 1) * from, std::min((i + 2) * from, from * to)}; }
    uint32_t first(Range r) const { return static_cast<uint32_t>(r.low / to); }
    uint32_t end(Range r) const { return static_cast<uint32_t>((r.high + to - 1) / to); }
    uint64_t overlap(Range r, uint32_t old) const
    {
        return std::min(r.high, (old + 1) * to) - std::max(r.low, old * to);
    }
};

struct ZoneArea {
    uint16_t zone = 0;
    uint64_t area = 0;
    uint64_t rgb[3] = {0, 0, 0};
};

class Resampler
{
public:
    Resampler(const ZoneMap &map, uint32_t width, uint32_t height)
        : map_(map), x_{map.width, width}, y_{map.height, height}
    {
    }

    const ZoneArea &texel(uint32_t x, uint32_t y)
    {
        gather(x_.box(x), y_.box(y), zone_areas_);
        if (zone_areas_.size() == 1) return zone_areas_[0];
        uint64_t maximum = 0;
        for (const ZoneArea &zone_area : zone_areas_) maximum = std::max(maximum, zone_area.area);
        size_t tied = 0;
        for (const ZoneArea &zone_area : zone_areas_) tied += zone_area.area == maximum;
        if (tied > 1) return break_tie(x, y, maximum);
        return *std::find_if(zone_areas_.begin(), zone_areas_.end(),
                             [&](const ZoneArea &s) { return s.area == maximum; });
    }

private:
    void gather(Axis::Range xs, Axis::Range ys, std::vector<ZoneArea> &zone_areas) const
    {
        zone_areas.clear();
        const uint32_t x_first = x_.first(xs), x_end = x_.end(xs), y_end = y_.end(ys);
        for (uint32_t y = y_.first(ys); y < y_end; ++y) {
            const uint64_t height = y_.overlap(ys, y);
            for (uint32_t x = x_first; x < x_end; ++x) {
                const size_t at = size_t(y) * map_.width + x;
                const uint64_t area = x_.overlap(xs, x) * height;
                ZoneArea &zone_area = zone_area_of(map_.zones[at], zone_areas);
                zone_area.area += area;
                for (size_t k = 0; k < 3; ++k) zone_area.rgb[k] += area * map_.rgb[3 * at + k];
            }
        }
    }

    static ZoneArea &zone_area_of(uint16_t zone, std::vector<ZoneArea> &zone_areas)
    {
        for (ZoneArea &zone_area : zone_areas)
            if (zone_area.zone == zone) return zone_area;
        zone_areas.push_back({});
        zone_areas.back().zone = zone;
        return zone_areas.back();
    }

    const ZoneArea &break_tie(uint32_t x, uint32_t y, uint64_t maximum)
    {
        gather(x_.grown(x), y_.grown(y), around_);
        const ZoneArea *best = nullptr;
        uint64_t best_around = 0;
        for (const ZoneArea &zone_area : zone_areas_) {
            if (zone_area.area != maximum) continue;
            const uint64_t around = zone_area_of(zone_area.zone, around_).area;
            if (!best || around > best_around || (around == best_around && zone_area.zone < best->zone))
                best = &zone_area, best_around = around;
        }
        return *best;
    }

    const ZoneMap &map_;
    Axis x_, y_;
    std::vector<ZoneArea> zone_areas_, around_;
};

// Averages four texels of the same zone, which is nearly always the case; the same result as resampling.
bool average_four(const ZoneMap &map, uint32_t x, uint32_t y, ZoneMap &out)
{
    const size_t a = 2 * (size_t(y) * map.width + x), b = a + map.width;
    const uint16_t zone = map.zones[a];
    if (map.zones[a + 1] != zone || map.zones[b] != zone || map.zones[b + 1] != zone) return false;
    const size_t at = size_t(y) * out.width + x;
    out.zones[at] = zone;
    for (size_t k = 0; k < 3; ++k) {
        const uint32_t sum = map.rgb[3 * a + k] + map.rgb[3 * a + 3 + k] + map.rgb[3 * b + k] + map.rgb[3 * b + 3 + k];
        out.rgb[3 * at + k] = static_cast<uint8_t>((sum + 2) / 4);
    }
    return true;
}

bool power_of_two(uint32_t v) { return (v & (v - 1)) == 0; }

// For each texel the nearest covered row of its column; `none` if the column has none.
std::vector<uint32_t> nearest_rows(const ZoneMap &map, const std::vector<uint8_t> &covered)
{
    std::vector<uint32_t> rows(covered.size(), model::none), last(map.width, model::none);
    for (uint32_t y = 0; y < map.height; ++y)
        for (uint32_t x = 0; x < map.width; ++x) {
            const size_t at = size_t(y) * map.width + x;
            if (covered[at]) last[x] = y;
            rows[at] = last[x];
        }
    std::fill(last.begin(), last.end(), model::none);
    for (uint32_t y = map.height; y-- > 0;)
        for (uint32_t x = 0; x < map.width; ++x) {
            uint32_t &row = rows[size_t(y) * map.width + x];
            if (row == y) last[x] = y;
            if (last[x] != model::none && (row == model::none || last[x] - y < y - row)) row = last[x];
        }
    return rows;
}

// The nearest column for each texel of a row, where column x is gap[x] away: the lower envelope of parabolas.
class Envelope
{
public:
    void build(const std::vector<int64_t> &gap)
    {
        columns_.clear(), starts_.clear();
        for (int64_t x = 0; x < static_cast<int64_t>(gap.size()); ++x) {
            if (gap[static_cast<size_t>(x)] < 0) continue;
            int64_t start = 0;
            while (!columns_.empty()) {
                start = first_nearer(columns_.back(), x, gap);
                if (start > starts_.back()) break;
                columns_.pop_back(), starts_.pop_back();
                start = 0;
            }
            columns_.push_back(x), starts_.push_back(start);
        }
    }
    size_t size() const { return columns_.size(); }
    int64_t column(size_t i) const { return columns_[i]; }
    int64_t start(size_t i) const { return starts_[i]; }

private:
    // Returns the first position at which column b > a is strictly nearer than a.
    static int64_t first_nearer(int64_t a, int64_t b, const std::vector<int64_t> &gap)
    {
        const int64_t ga = gap[static_cast<size_t>(a)], gb = gap[static_cast<size_t>(b)];
        const int64_t over = b * b - a * a + gb * gb - ga * ga, under = 2 * (b - a);
        const int64_t quotient = over >= 0 ? over / under : -((-over + under - 1) / under);
        return std::max<int64_t>(0, quotient + 1);
    }
    std::vector<int64_t> columns_, starts_;
};

}  // namespace

uint32_t fitted_side(uint32_t side, uint32_t max_px)
{
    uint32_t p = 1;
    while (p < side && p * 2 <= max_px) p *= 2;
    return p;
}

ZoneMap resample(const ZoneMap &map, uint32_t width, uint32_t height)
{
    ZoneMap out(width, height);
    Resampler resampler(map, width, height);
    const bool halved = map.width == 2 * width && map.height == 2 * height;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            if (halved && average_four(map, x, y, out)) continue;
            const ZoneArea &zone_area = resampler.texel(x, y);
            const size_t at = size_t(y) * width + x;
            out.zones[at] = zone_area.zone;
            for (size_t k = 0; k < 3; ++k)
                out.rgb[3 * at + k] = static_cast<uint8_t>((zone_area.rgb[k] + zone_area.area / 2) / zone_area.area);
        }
    return out;
}

ZoneMap halve(const ZoneMap &map) { return resample(map, std::max(1u, map.width / 2), std::max(1u, map.height / 2)); }

void dilate(ZoneMap &map, const std::vector<uint8_t> &covered)
{
    const std::vector<uint32_t> rows = nearest_rows(map, covered);
    std::vector<int64_t> gap(map.width);
    Envelope envelope;
    for (uint32_t y = 0; y < map.height; ++y) {
        const size_t row = size_t(y) * map.width;
        if (std::memchr(covered.data() + row, 0, map.width) == nullptr) continue;
        for (uint32_t x = 0; x < map.width; ++x)
            gap[x] = rows[row + x] == model::none ? -1 : std::abs(int64_t(rows[row + x]) - int64_t(y));
        envelope.build(gap);
        if (envelope.size() == 0) return;  // nothing is covered
        size_t i = 0;
        for (uint32_t x = 0; x < map.width; ++x) {
            while (i + 1 < envelope.size() && envelope.start(i + 1) <= int64_t(x)) ++i;
            if (covered[row + x]) continue;
            const size_t column = static_cast<size_t>(envelope.column(i));
            const size_t from = size_t(rows[row + column]) * map.width + column;
            // Covered texels are never written, so this one is unchanged.
            map.zones[row + x] = map.zones[from];
            for (size_t k = 0; k < 3; ++k) map.rgb[3 * (row + x) + k] = map.rgb[3 * from + k];
        }
    }
}

ZoneMap unfold(const ZoneMap &map, bool mirror_s, bool mirror_t)
{
    ZoneMap out(map.width * (mirror_s ? 2 : 1), map.height * (mirror_t ? 2 : 1));
    for (uint32_t y = 0; y < out.height; ++y)
        for (uint32_t x = 0; x < out.width; ++x) {
            const uint32_t sx = x < map.width ? x : 2 * map.width - 1 - x;
            const uint32_t sy = y < map.height ? y : 2 * map.height - 1 - y;
            const size_t from = size_t(sy) * map.width + sx, to = size_t(y) * out.width + x;
            out.zones[to] = map.zones[from];
            for (size_t k = 0; k < 3; ++k) out.rgb[3 * to + k] = map.rgb[3 * from + k];
        }
    return out;
}

bool fits(const ZoneMap &map, uint32_t max_px)
{
    return map.width == fitted_side(map.width, max_px) && map.height == fitted_side(map.height, max_px);
}

ZoneMap fit(const ZoneMap &map, uint32_t max_px)
{
    const uint32_t width = fitted_side(map.width, max_px), height = fitted_side(map.height, max_px);
    ZoneMap out = map;
    if (!power_of_two(out.width) || !power_of_two(out.height))
        out =
            resample(out, power_of_two(out.width) ? out.width : width, power_of_two(out.height) ? out.height : height);
    while (out.width > width || out.height > height)
        out = resample(out, std::max(width, out.width / 2), std::max(height, out.height / 2));
    return out;
}

}  // namespace claque::meshsplit
