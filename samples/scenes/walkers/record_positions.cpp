#include "samples/scenes/walkers/record_positions.h"

#include <cmath>
#include <map>

namespace scenes::walkers
{
namespace
{

constexpr size_t most_rows = size_t(1) << 26;
constexpr double most_frames = 1e7;
constexpr double instant_s = 1e-6;  // a step is not late by the rounding of its time

// A tenth of a millimetre, as the files of the field have it.
double rounded(double metres) { return std::round(1e4 * metres) / 1e4 + 0.0; }

// Gives a number of its own to each person with an earlier one's actor number.
void name_apart(std::vector<RecordPosition> &rows, const std::vector<uint32_t> &generations)
{
    uint32_t next = 0;
    for (const RecordPosition &row : rows) next = std::max(next, row.person);
    std::map<uint32_t, uint32_t> first;                       // generation, by number
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> later;  // number, by number and generation
    for (size_t i = 0; i < rows.size(); ++i) {
        const uint32_t person = rows[i].person, generation = generations[i];
        if (first.emplace(person, generation).first->second == generation) continue;
        const auto found = later.emplace(std::make_pair(person, generation), 0);
        if (found.second) found.first->second = ++next;
        rows[i].person = found.first->second;
    }
}

}  // namespace

RecordPlaces::RecordPlaces(Library &library, const RecordFile &file) : file_(file)
{
    clq_crowd_def def = clq_crowd_def_init();
    check(clq_record_get_crowd_def(file.record.get(), &def));
    def.cache = CLQ_CACHE_NONE, def.cache_budget_bytes = 0;
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), &def, &made));
    crowd_.reset(made);
    check(clq_scene_create(made, &scene_));
}

void RecordPlaces::at(double time_s, const std::function<void(clq_actor, const double *)> &take)
{
    check(clq_record_play(file_.record.get(), crowd_.get(), time_s + instant_s));
    check(clq_scene_update(scene_, time_s));
    uint32_t count = clq_crowd_get_actor_count(crowd_.get());
    actors_.resize(count);
    check(clq_scene_find(scene_, nullptr, actors_.data(), count, &count));
    for (uint32_t i = 0; i < count; ++i) {
        clq_scene_actor found = clq_scene_actor_init();
        check(clq_scene_get_actor(scene_, actors_[i], time_s, &found));
        if (found.present) take(actors_[i], found.position);
    }
}

RecordPositions positions_in(Library &library, const std::string &path, const std::vector<SocialClass> &characters,
                             double rate_hz, const std::function<void(size_t, size_t)> &progress)
{
    const RecordFile file(library, path);
    const RecordCast cast(library, file, characters);
    const double first = std::ceil((file.info.start_s - instant_s) * rate_hz),
                 last = std::floor((file.info.end_s + instant_s) * rate_hz);
    if (!(std::fabs(first) < 1e9 && std::fabs(last) < 1e9 && last - first < most_frames))
        throw Failure(path + ": its clock runs from " + std::to_string(file.info.start_s) + " to " +
                      std::to_string(file.info.end_s) + " s, which are too many frames: --rate gives fewer");
    RecordPlaces places(library, file);
    RecordPositions out;
    out.rate_hz = rate_hz;
    std::vector<uint32_t> generations;
    for (int frame = int(first); frame <= int(last); ++frame) {
        places.at(frame / rate_hz, [&](clq_actor actor, const double *position) {
            if (out.rows.size() == most_rows)
                throw Failure(path + ": more than 67108864 positions: --rate gives fewer");
            out.rows.push_back({actor.index1, frame, rounded(position[0]), rounded(-position[2])});
            generations.push_back(actor.generation);
        });
        progress(size_t(frame - int(first)) + 1, size_t(last - first) + 1);
    }
    name_apart(out.rows, generations);
    return out;
}

}  // namespace scenes::walkers
