#include "lib/track/track_file.h"

#include <algorithm>
#include <cmath>

#include "lib/base/file_header.h"
#include "lib/track/build.h"

namespace claque::track
{

namespace
{

using base::fail;

constexpr base::FileForm form = {{'c', 'l', 'a', 'q', 'u', 'e', 'W', 0x1a}, track_file_version, "a saved track"};
constexpr base::FileForm climbing_form = {
    {'c', 'l', 'a', 'q', 'u', 'e', 'W', 0x1a}, climbing_file_version, "a saved track"};
constexpr double highest_m = 1e6;

// One list of fields for writing and reading.
template <class Archive, class T>
void walk(Archive &a, T &track)
{
    for (int k = 0; k < 3; ++k) a.value(track.origin_m[k]);
    a.value(track.start_s), a.value(track.length_s), a.value(track.rate_hz), a.value(track.min_height_m);
    a.value(track.height_step_m), a.value(track.metres_per_unit), a.value(track.scale);
    a.value(track.mean_shift_m), a.value(track.max_shift_m), a.value(track.distance_m), a.value(track.standing_s);
    a.array(track.samples, 16, [&](auto &s) {
        a.value(s.x), a.value(s.z), a.value(s.height), a.value(s.heading), a.value(s.phase), a.value(s.gait);
        a.value(s.flags);
    });
    for (auto &plants : track.plants)
        a.array(plants, 36, [&](auto &p) {
            a.value(p.begin_s), a.value(p.end_s), a.value(p.x), a.value(p.z), a.value(p.heading_rad);
            a.value(p.begin_x), a.value(p.begin_z), a.value(p.end_x), a.value(p.end_z);
        });
    a.value(track.previous_hash), a.value(track.stand_count);
    for (auto &s : track.swings) a.value(s.x), a.value(s.z), a.value(s.turn_rad), a.value(s.until_s);
    a.value(track.upper_swing.gaze_rad), a.value(track.upper_swing.torso_rad);
    a.array(track.ahead, 2, [&](auto &heading) { a.value(heading); });
    a.array(track.shoulders, 12, [&](auto &turn) { a.value(turn.at_s), a.value(turn.half_s), a.value(turn.turn_rad); });
}

template <class Archive, class T>
void walk_heights(Archive &a, T &track)
{
    for (auto &plants : track.plants)
        for (auto &plant : plants) a.value(plant.y), a.value(plant.slope);
    for (auto &swing : track.swings) a.value(swing.y);
    a.array(track.sinks, 2, [&](auto &sink) { a.value(sink); });
}

void check_heights(const Track &track)
{
    const auto bad = [](float y) { return std::fabs(double(y)) > highest_m; };
    for (const Array<Plant> &plants : track.plants)
        for (const Plant &plant : plants)
            if (bad(plant.y) || !(std::fabs(double(plant.slope)) <= max_slope + 1e-6))
                fail(CLQ_FORMAT, "a step of a saved track is at an impossible height");
    if (!track.sinks.empty() && track.sinks.size() != track.samples.size())
        fail(CLQ_FORMAT, "a saved track has %zu samples, but %zu of its hips", track.samples.size(),
             track.sinks.size());
    const double most = max_sink * double(track.locomotion->leg_length) * track.scale + sink_step_m;
    for (const uint16_t sink : track.sinks)
        if (sink * sink_step_m > most) fail(CLQ_FORMAT, "the hips of a saved track sink by %g m", sink * sink_step_m);
    for (const Swing &swing : track.swings)
        if (bad(swing.y) || std::isnan(swing.y)) fail(CLQ_FORMAT, "a step of a saved track is at an impossible height");
}

bool is_climbing(const uint8_t *bytes, size_t size)
{
    return size >= base::file_header_bytes && bytes[8] == climbing_file_version;
}

void check_plants(const Array<Plant> &plants, bool piece)
{
    for (size_t i = 0; i < plants.size(); ++i) {
        const Plant &p = plants[i];
        bool good = (piece ? std::isfinite(p.begin_s) : p.begin_s >= 0) && p.end_s >= p.begin_s &&
                    (i == 0 || p.begin_s > plants[i - 1].end_s);
        for (const float x : {p.end_s, p.x, p.z, p.heading_rad, p.begin_x, p.begin_z, p.end_x, p.end_z})
            good = good && std::isfinite(x);
        if (!good) fail(CLQ_FORMAT, "step %zu of a saved track is impossible", i);
    }
}

void check_shoulders(const Array<ShoulderTurn> &shoulders)
{
    for (size_t i = 0; i < shoulders.size(); ++i) {
        const ShoulderTurn &turn = shoulders[i];
        const bool good = std::isfinite(turn.at_s) && turn.half_s > 0 && turn.half_s < 10 &&
                          std::fabs(turn.turn_rad) <= max_shoulder_turn_rad &&
                          (i == 0 || turn.at_s - turn.half_s >= shoulders[i - 1].at_s + shoulders[i - 1].half_s);
        if (!good) fail(CLQ_FORMAT, "turn %zu of the shoulders of a saved track is impossible", i);
    }
}

void check(const Track &track, const Locomotion &locomotion)
{
    bool good = true;
    for (const double x : {track.origin_m.x, track.origin_m.y, track.origin_m.z, track.start_s, track.length_s,
                           track.rate_hz, track.min_height_m, track.height_step_m, track.metres_per_unit, track.scale})
        good = good && std::isfinite(x);
    good = good && track.length_s >= 0 && track.length_s <= 1e6 && track.height_step_m >= 0;
    good = good && track.rate_hz >= 1 && track.rate_hz <= 100 && track.metres_per_unit > 0 && track.scale > 0;
    if (!good) fail(CLQ_FORMAT, "a saved track has a length, rate or scale that no track has");
    if (double(track.samples.size()) < std::max(2.0, track.length_s * track.rate_hz + 0.5))
        fail(CLQ_FORMAT, "a saved track of %g s at %g Hz has %zu samples", track.length_s, track.rate_hz,
             track.samples.size());
    for (const Sample &sample : track.samples)
        if (double(sample.gait) > double(locomotion.max_gait()) * gait_unit ||
            idle_of(sample.flags) >= std::max(1u, locomotion.clips.idle_count) ||
            (turn_of(sample.flags) > 0 && locomotion.clips.turn == model::none))
            fail(CLQ_FORMAT, "a saved track plays a gait or clip that its locomotion lacks");
    for (const Array<Plant> &plants : track.plants) check_plants(plants, track.previous_hash != 0);
    for (const Swing &s : track.swings)
        for (const float x : {s.x, s.z, s.turn_rad, s.until_s})
            if (!std::isfinite(x)) fail(CLQ_FORMAT, "a step of a saved track is impossible");
    check_shoulders(track.shoulders);
    if (!(std::fabs(track.upper_swing.gaze_rad) < 4) || !(std::fabs(track.upper_swing.torso_rad) < 4))
        fail(CLQ_FORMAT, "the gaze of a saved track is impossible");
}

}  // namespace

uint64_t hash_of(const Locomotion &locomotion)
{
    uint64_t h = base::fnv_start;
    const auto add = [&h](const auto &value) { h = base::fnv(h, &value, sizeof value); };
    add(locomotion.clips.walk), add(locomotion.clips.run), add(locomotion.clips.slow), add(locomotion.clips.turn);
    add(locomotion.clips.idle_count);
    for (const uint32_t idle : locomotion.clips.idles) add(idle);
    for (const float stride : locomotion.stride) add(stride);
    for (const Array<GaitCell> *cells : {&locomotion.cells, &locomotion.turn_cells})
        for (const GaitCell &cell : *cells) {
            add(cell.advance);
            for (int f = 0; f < 2; ++f) add(cell.x[f]), add(cell.z[f]), add(cell.supports[f]), add(cell.reach[f]);
            for (const float yaw : cell.yaw) add(yaw);
        }
    return h;
}

void save(const Track &track, Array<uint8_t> &out)
{
    out.reserve(out.size() + track.bytes() + 256);
    base::append_file(track.climbs ? climbing_form : form, out, [&](auto &archive) {
        archive.value(track.locomotion->hash);
        walk(archive, track);
        if (track.climbs) walk_heights(archive, track);
    });
}

void load(const uint8_t *bytes, size_t size, const Locomotion &locomotion, Track &out)
{
    const bool climbs = is_climbing(bytes, size);
    base::ArchiveReader<> in = base::open_file(climbs ? climbing_form : form, bytes, size);
    uint64_t made_for = 0;
    in.value(made_for);
    if (made_for != locomotion.hash)
        fail(CLQ_ARGUMENT, "the saved track was made for another locomotion: its template or its clips differ");
    out.locomotion = &locomotion;
    walk(in, out);
    if (climbs) walk_heights(in, out);
    in.end();
    check(out, locomotion);
    if (climbs) check_heights(out);
    index_plants(out);
    out.climbs = climbs;
    out.top_speed = top_speed_of(out);
    out.reach = reach_of(out);
    out.hash = hash_of(out);
}

}  // namespace claque::track
