// Calls for locomotions, tracks, trajectories and areas.
#include <claque/track.h>
#include <claque/trajectories.h>

#include "tests/api/failing_memory.h"
#include "tests/faults/calls.h"

namespace faults
{
namespace
{

using W = World &;

constexpr char people[] = "time,pedID,posX,posY\n0.5,a,1,2\n0.5,b,5,5\n1.0,a,1.5,2\n1.0,a,1.5,2\n9.0,a,1.5,2\n";
constexpr char hall[] = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 5, 5 5, 5 3, 3 3))";

uint64_t hash_of_track(const clq_track *track)
{
    clq_track_info info = clq_track_info_init();
    EXPECT_EQ(clq_track_get_info(track, &info), CLQ_OK);
    return info.hash;
}

void note_track(W w)
{
    auto *track = static_cast<clq_track *>(w.made);
    w.found = hash_of_track(track);
    clq_track_destroy(track);
}

int add_to_sum(void *user, const void *bytes, size_t count)
{
    uint64_t &sum = *static_cast<uint64_t *>(user);
    sum = 31 * sum + hash_of(bytes, count);
    return 0;
}

// In a good run, without its faults.
std::vector<unsigned char> saved(const clq_track *track)
{
    const failing_memory::Unarmed unarmed;
    std::vector<unsigned char> bytes;
    const auto keep = [](void *user, const void *from, size_t count) {
        const auto *first = static_cast<const unsigned char *>(from);
        auto &to = *static_cast<std::vector<unsigned char> *>(user);
        to.insert(to.end(), first, first + count);
        return 0;
    };
    EXPECT_EQ(clq_track_save(track, keep, &bytes), CLQ_OK);
    return bytes;
}

// Goes on where the first track of the world ends.
clq_status make_piece(const TestWorld &world, clq_track **out)
{
    clq_track_info info = clq_track_info_init();
    EXPECT_EQ(clq_track_get_info(world.tracks[0], &info), CLQ_OK);
    clq_track_point points[40] = {};
    for (int i = 0; i < 40; ++i) {
        points[i].time_s = info.end_s - 1 + 0.1 * i;
        points[i].position[0] = 0.1 * i;
        points[i].heading_rad = 1;
    }
    clq_track_def def = clq_track_def_init();
    def.points = points, def.point_count = 40, def.previous = world.tracks[0], def.end_s = info.end_s + 1.5;
    def.ground = [](void *, const double point[3]) { return point[1] - 0.05; };
    return clq_track_create(world.locomotion, &def, out);
}

void add_tracks(std::vector<Call> &all)
{
    all.push_back({"clq_locomotion_create",
                   [](W w) {
                       const uint32_t clip = 0;
                       const clq_locomotion_def def = Walker::locomotion(w.test.templates[0], &clip);
                       return clq_locomotion_create(w.test.context, &def, w.out<clq_locomotion>());
                   },
                   0, [](W w) { clq_locomotion_destroy(static_cast<clq_locomotion *>(w.made)); }});
    all.push_back({"clq_locomotion_get_info",
                   [](W w) {
                       clq_locomotion_info info = clq_locomotion_info_init();
                       return clq_locomotion_get_info(w.test.locomotion, &info);
                   },
                   quiet});
    all.push_back({"clq_locomotion_destroy",
                   [](W) {
                       clq_locomotion_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
    all.push_back({"clq_track_create",
                   [](W w) {
                       clq_track *whole = nullptr;
                       const clq_status status = Walker::track(w.test.locomotion, 7, &whole);
                       clq_track_destroy(whole);
                       return status == CLQ_OK ? make_piece(w.test, w.out<clq_track>()) : status;
                   },
                   0, note_track});
    all.push_back({"clq_find_passings",
                   [](W w) {
                       clq_track_point points[2][2] = {{{0, {0, 0, 0}, 0}, {4, {0, 0, 4}, 0}},
                                                       {{0, {0.5, 0, 4}, 0}, {4, {0.5, 0, 0}, 0}}};
                       clq_track_def defs[2] = {clq_track_def_init(), clq_track_def_init()};
                       for (int i = 0; i < 2; ++i) defs[i].points = points[i], defs[i].point_count = 2;
                       const clq_track_def *const both[2] = {&defs[0], &defs[1]};
                       clq_found_passing found[4];
                       size_t count = 0;
                       const clq_status status = clq_find_passings(w.test.context, both, 2, found, 4, &count);
                       if (status == CLQ_OK) w.found = count;
                       return status;
                   },
                   0});
    all.push_back({"clq_track_load",
                   [](W w) {
                       const std::vector<unsigned char> bytes = saved(w.test.tracks[0]);
                       return clq_track_load(w.test.locomotion, bytes.data(), bytes.size(), w.out<clq_track>());
                   },
                   0, note_track});
    all.push_back({"clq_track_save", [](W w) {
                       w.found = 0;
                       return clq_track_save(w.test.tracks[0], add_to_sum, &w.found);
                   }});
    all.push_back({"clq_track_get_info",
                   [](W w) {
                       clq_track_info info = clq_track_info_init();
                       return clq_track_get_info(w.test.tracks[0], &info);
                   },
                   quiet});
    all.push_back({"clq_track_evaluate",
                   [](W w) {
                       clq_track_state state;
                       return clq_track_evaluate(w.test.tracks[0], 2, &state);
                   },
                   quiet});
    all.push_back({"clq_track_hold",
                   [](W w) { return clq_track_hold(w.test.tracks[0]), clq_track_destroy(w.test.tracks[0]), CLQ_OK; },
                   quiet});
    all.push_back({"clq_track_destroy",
                   [](W) {
                       clq_track_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
}

clq_status read(W w, clq_trajectories **out)
{
    return clq_trajectories_load_memory(w.test.context, people, sizeof people - 1, "people.csv", nullptr, out);
}

// What a call finds in trajectories that were read without faults.
template <class Body>
auto in_trajectories(const Body &body)
{
    return [body](W w) {
        clq_trajectories *read_ones = nullptr;
        {
            const failing_memory::Unarmed unarmed;
            EXPECT_EQ(read(w, &read_ones), CLQ_OK) << clq_last_error();
        }
        const clq_status status = body(read_ones);
        const failing_memory::Unarmed unarmed;
        clq_trajectories_destroy(read_ones);
        return status;
    };
}

template <class Body>
auto in_area(const Body &body)
{
    return [body](W w) {
        clq_area *area = nullptr;
        {
            const failing_memory::Unarmed unarmed;
            EXPECT_EQ(clq_area_load_memory(w.test.context, hall, sizeof hall - 1, "hall.wkt", &area), CLQ_OK);
        }
        const clq_status status = body(area);
        const failing_memory::Unarmed unarmed;
        clq_area_destroy(area);
        return status;
    };
}

std::string path_of(W w, const char *name)
{
    const failing_memory::Unarmed unarmed;
    return w.folder + name;
}

auto file_of(const char *name, const char *text)
{
    return [name, text](W w) {
        std::FILE *file = std::fopen((w.folder + name).c_str(), "wb");
        EXPECT_NE(file, nullptr) << name;
        if (file) std::fputs(text, file), std::fclose(file);
    };
}

void add_trajectories(std::vector<Call> &all)
{
    const auto destroy = [](W w) { clq_trajectories_destroy(static_cast<clq_trajectories *>(w.made)); };
    all.push_back({"clq_trajectories_load_memory", [](W w) { return read(w, w.out<clq_trajectories>()); }, 0, destroy});
    all.push_back({"clq_trajectories_load",
                   [](W w) {
                       const std::string path = path_of(w, "people.csv");
                       return clq_trajectories_load(w.test.context, path.c_str(), nullptr, w.out<clq_trajectories>());
                   },
                   0,
                   destroy,
                   {},
                   file_of("people.csv", people)});
    all.push_back({"clq_trajectories_get_info", in_trajectories([](const clq_trajectories *read_ones) {
                       clq_trajectories_info info = clq_trajectories_info_init();
                       return clq_trajectories_get_info(read_ones, &info);
                   }),
                   quiet});
    all.push_back({"clq_trajectories_get_person", in_trajectories([](const clq_trajectories *read_ones) {
                       clq_trajectory_person person = clq_trajectory_person_init();
                       return clq_trajectories_get_person(read_ones, 0, &person);
                   }),
                   quiet});
    all.push_back({"clq_trajectories_get_samples", in_trajectories([](const clq_trajectories *read_ones) {
                       return clq_trajectories_get_samples(read_ones) ? CLQ_OK : CLQ_LIMIT;
                   }),
                   quiet});
    all.push_back({"clq_trajectories_get_warning", in_trajectories([](const clq_trajectories *read_ones) {
                       return *clq_trajectories_get_warning(read_ones, 0) ? CLQ_OK : CLQ_LIMIT;
                   }),
                   quiet});
    all.push_back({"clq_trajectories_destroy",
                   [](W) {
                       clq_trajectories_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
}

void add_areas(std::vector<Call> &all)
{
    const auto destroy = [](W w) { clq_area_destroy(static_cast<clq_area *>(w.made)); };
    all.push_back(
        {"clq_area_load_memory",
         [](W w) { return clq_area_load_memory(w.test.context, hall, sizeof hall - 1, "hall.wkt", w.out<clq_area>()); },
         0, destroy});
    all.push_back({"clq_area_load",
                   [](W w) {
                       const std::string path = path_of(w, "hall.wkt");
                       return clq_area_load(w.test.context, path.c_str(), w.out<clq_area>());
                   },
                   0,
                   destroy,
                   {},
                   file_of("hall.wkt", hall)});
    all.push_back({"clq_area_get_info", in_area([](const clq_area *area) {
                       clq_area_info info = clq_area_info_init();
                       return clq_area_get_info(area, &info);
                   }),
                   quiet});
    all.push_back({"clq_area_get_warning",
                   in_area([](const clq_area *area) { return clq_area_get_warning(area, 9) ? CLQ_OK : CLQ_LIMIT; }),
                   quiet});
    all.push_back({"clq_area_destroy",
                   [](W) {
                       clq_area_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
}

void follow(W w)
{
    EXPECT_EQ(clq_actor_follow_track(w.objects.crowd, w.objects.actor, w.test.tracks[0], 1), CLQ_OK)
        << clq_last_error();
}

void add_followers(std::vector<Call> &all)
{
    all.push_back({"clq_actor_fade_to_track",
                   [](W w) { return clq_actor_fade_to_track(w.objects.crowd, w.objects.actor, 1, 1); },
                   quiet,  // this actor has had layers before
                   {},
                   {},
                   follow});
    all.push_back({"clq_actor_leave_track",
                   [](W w) { return clq_actor_leave_track(w.objects.crowd, w.objects.actor, 1); },
                   quiet,
                   {},
                   {},
                   follow});
}

}  // namespace

void add_walking_calls(std::vector<Call> &all)
{
    add_tracks(all), add_followers(all), add_trajectories(all), add_areas(all);
}

}  // namespace faults
