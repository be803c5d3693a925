// The law of feet on files and characters that others made. Prints the tables of docs/measurements.md.
#include <claque/assets.h>
#include <claque/trajectories.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "lib/api/track_handle.h"
#include "tests/support/collected_file.h"
#include "tests/unit/track/contact_law.h"
#include "tests/unit/track/sole_meter.h"

using namespace claque;

namespace
{

const std::string assets = CLAQUE_ASSETS_DIR;

struct File {
    const char *path;
    double rate_hz, metres_per_unit;  // 0: the file says it
};
const File files[] = {{"pedpy/040_c_56_h-.txt", 0, 0},         {"pedpy/uo-050-180-180.txt", 16, 0.01},
                      {"pedpy/ref-bottleneck/traj.txt", 0, 0}, {"pedpy/ref-corner/traj.txt", 0, 1},
                      {"opentraj/zara01/obsmat.txt", 0, 0},    {"opentraj/seq_hotel/obsmat.txt", 0, 0},
                      {"trajnet/biwi_hotel.ndjson", 0, 0},     {"trajnet/lcas.ndjson", 0, 0},
                      {"pedpy/jupedsim_v2.sqlite", 0, 0},      {"pedpy/trajectories.sqlite", 0, 0},
                      {"pedpy/pathfinder.csv", 0, 0},          {"pedpy/vadere_postvis.traj", 0, 0},
                      {"pedpy/crowdit.csv.gz", 0, 0},          {"derived/viswalk_from_trajectories_sqlite.pp", 0, 0},
                      {"sumo/crossing_1s.fcd.xml", 0, 0}};

struct Character {
    const char *name;  // built-in, or a file
    const char *walk, *run, *idle;
    double scale;  // to the size of a person
};
const Character characters[] = {
    {"citizen", "walk", "jog", "stand", 1},
    {"patrician", "walk", "jog", "stand", 1},
    {"plebeian", "walk", "jog", "stand", 1},
    {"decurion", "walk", "jog", "stand", 1},
    {"humanoids/kaykit/Barbarian.glb", "Walking_A", "Running_A", "Idle", 0.73},
    {"humanoids/kaykit/Mage.glb", "Walking_A", "Running_A", "Idle", 0.65},
    {"humanoids/kaykit/Rogue.glb", "Walking_A", "Running_A", "Idle", 0.8},
    {"humanoids/quaternius-ultimate/Casual_Male.gltf", "Walk", "Run", "Idle", 0.54},
    {"humanoids/quaternius-ultimate/Kimono_Female.gltf", "Walk", "Run", "Idle", 0.54},
    {"humanoids/gdquest/gdbot.glb", "walk", "run", "Idle", 1},
};

// The library that a file of this name needs and this build lacks, or null.
const char *absent_library(const std::string &path)
{
    const std::string kind = std::filesystem::path(path).extension();
    if (kind != ".xml" && kind != ".sqlite" && kind != ".gz") return nullptr;
#ifndef CLAQUE_HAS_EXPAT
    if (kind == ".xml") return "libexpat";
#endif
#ifndef CLAQUE_HAS_SQLITE3
    if (kind == ".sqlite") return "libsqlite3";
#endif
#ifndef CLAQUE_HAS_Z
    if (kind == ".gz") return "zlib";
#endif
    return nullptr;
}

// What the characters walk with.
class Cast
{
public:
    Cast() { EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK); }
    ~Cast()
    {
        for (auto &[name, locomotion] : walks_) clq_locomotion_destroy(locomotion);
        EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    }
    clq_context *context = nullptr;

    const clq_locomotion *walk_of(const Character &character)
    {
        clq_locomotion *&made = walks_[character.name];
        if (made) return made;
        clq_template *tmpl = nullptr;
        const bool built_in = std::string(character.name).find('.') == std::string::npos;
        const std::string path = assets + "/" + character.name;
        if (built_in) {
            EXPECT_EQ(clq_template_builtin(context, character.name, &tmpl), CLQ_OK) << clq_last_error();
        } else {
            clq_asset *asset = nullptr;
            EXPECT_EQ(clq_asset_load_file(context, path.c_str(), nullptr, &asset), CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_asset_build(context, asset, 256, &tmpl), CLQ_OK) << clq_last_error();
            clq_asset_destroy(asset);
        }
        const uint32_t idles[] = {clq_template_find_clip(tmpl, character.idle),
                                  clq_template_find_clip(tmpl, "stand_look"),
                                  clq_template_find_clip(tmpl, "stand_shift")};
        clq_locomotion_def def = clq_locomotion_def_init();
        def.tmpl = tmpl, def.walk = clq_template_find_clip(tmpl, character.walk);
        def.run = clq_template_find_clip(tmpl, character.run), def.idle_count = built_in ? 3 : 1, def.idles = idles;
        if (built_in) {
            def.slow_walk = clq_template_find_clip(tmpl, "walk_slow");
            def.turn = clq_template_find_clip(tmpl, "turn");
        }
        EXPECT_EQ(clq_locomotion_create(context, &def, &made), CLQ_OK) << path << ": " << clq_last_error();
        clq_template_destroy(tmpl);
        return made;
    }

private:
    std::map<std::string, clq_locomotion *> walks_;
};

clq_track *track_of(const clq_locomotion *walk, const std::vector<clq_track_point> &points, uint32_t seed, double scale)
{
    clq_track_def def = clq_track_def_init();
    def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
    def.scale = static_cast<float>(scale), def.seed = seed;
    clq_track *made = nullptr;
    EXPECT_EQ(clq_track_create(walk, &def, &made), CLQ_OK) << clq_last_error();
    return made;
}

// The mean distance between the place that is shown and the given way, averaged over a stride of 1.1 s.
double away_from_average_m(const track::Track &track, const std::vector<clq_track_point> &points)
{
    const auto given = [&](double time_s) {
        size_t next = 1;
        while (next + 1 < points.size() && points[next].time_s < time_s) ++next;
        const clq_track_point &a = points[next - 1], &b = points[next];
        const double part = (time_s - a.time_s) / (b.time_s - a.time_s);
        return glm::dvec2(a.position[0], a.position[2]) * (1 - part) + glm::dvec2(b.position[0], b.position[2]) * part;
    };
    constexpr int parts = 22;
    double sum = 0;
    for (const clq_track_point &point : points) {
        const double to_end_s = std::min(point.time_s - points.front().time_s, points.back().time_s - point.time_s);
        const double half_s = std::min(0.55, to_end_s);
        glm::dvec2 mean(0);
        for (int i = 0; i < parts; ++i)
            mean += given(point.time_s + half_s * ((2 * i + 1.0) / parts - 1)) / double(parts);
        const glm::dvec3 shown = track::position_at(track, point.time_s);
        sum += glm::length(glm::dvec2(shown.x, shown.z) - mean);
    }
    return sum / double(points.size());
}

constexpr uint32_t max_people = 4;  // of a file, evenly spread over it

class FootLaw : public testing::TestWithParam<File>
{
protected:
    static void SetUpTestSuite() { cast_ = std::make_unique<Cast>(); }
    static void TearDownTestSuite() { cast_.reset(); }
    void SetUp() override
    {
        CLAQUE_NEEDS_FILE(assets + "/tracks/" + GetParam().path);
        clq_trajectories_def def = clq_trajectories_def_init();
        def.rate_hz = GetParam().rate_hz, def.metres_per_unit = GetParam().metres_per_unit;
        const std::string path = assets + "/tracks/" + GetParam().path;
        const clq_status status = clq_trajectories_load(cast_->context, path.c_str(), &def, &read_);
        if (const char *library = absent_library(GetParam().path)) {
            EXPECT_EQ(status, CLQ_UNSUPPORTED) << clq_last_error();
            GTEST_SKIP() << "this build has no " << library;
        }
        ASSERT_EQ(status, CLQ_OK) << clq_last_error();
    }
    void TearDown() override { clq_trajectories_destroy(read_); }

    std::vector<clq_track_point> points_of(uint32_t number) const
    {
        clq_trajectory_person person = clq_trajectory_person_init();
        EXPECT_EQ(clq_trajectories_get_person(read_, number, &person), CLQ_OK);
        const clq_trajectory_sample *samples = clq_trajectories_get_samples(read_) + person.first_sample;
        std::vector<clq_track_point> points;
        for (uint64_t i = 0; i < person.sample_count; ++i)
            // On level ground: slopes are contact_law_test.cpp's.
            points.push_back(
                {samples[i].time_s, {samples[i].x, 0, -samples[i].y}, samples[i].heading_rad + 1.5707963f});
        return points;
    }

    static std::unique_ptr<Cast> cast_;
    clq_trajectories *read_ = nullptr;
};

std::unique_ptr<Cast> FootLaw::cast_;

}  // namespace

TEST_P(FootLaw, HoldsForTenCharacters)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    ASSERT_EQ(clq_trajectories_get_info(read_, &info), CLQ_OK);
    const uint32_t every = std::max(1u, info.person_count / max_people);
    for (const Character &character : characters) {
        const clq_locomotion *walk = cast_->walk_of(character);
        ASSERT_NE(walk, nullptr);
        const test::SoleMeter meter(*walk, character.scale);
        test::Contacts contacts;
        double mean_m = 0, max_m = 0, from_average_m = 0;
        int people = 0;
        for (uint32_t i = 0; i < info.person_count; i += every, ++people) {
            const std::vector<clq_track_point> points = points_of(i);
            clq_track *track = track_of(walk, points, i, character.scale);
            contacts.add(meter.watch(*track));
            if (points.size() > 1) from_average_m += away_from_average_m(*track, points);
            mean_m += track->mean_shift_m, max_m = std::max(max_m, track->max_shift_m);
            clq_track_destroy(track);
        }
        std::printf("%s: %d people, path %.3f m, at most %.3f, %.3f m from its average\n", GetParam().path, people,
                    mean_m / people, max_m, from_average_m / people);
        EXPECT_LE(from_average_m / people, 0.03) << character.name;
        const bool built_in = std::string(character.name).find('.') == std::string::npos;
        (built_in ? test::expect_law : test::expect_law_of_others)(character.name, contacts);
    }
}

TEST(FootLawOfCharacters, HoldsOnWrittenWays)
{
    Cast cast;
    const auto watched = [&](const Character &character, double length_s, const test::WayFunction &way) {
        std::vector<clq_track_point> points;
        for (int i = 0; i <= int(25 * length_s); ++i) {
            const glm::dvec2 p = way(i / 25.0);
            points.push_back({i / 25.0, {p.x, 0, p.y}, NAN});
        }
        const clq_locomotion *walk = cast.walk_of(character);
        clq_track *track = track_of(walk, points, 1, character.scale);
        const test::Contacts contacts = test::SoleMeter(*walk, character.scale).watch(*track);
        clq_track_destroy(track);
        return contacts;
    };
    for (const Character &character : characters) {
        const std::string name = character.name;
        if (name.find('.') == std::string::npos) continue;
        CLAQUE_NEEDS_FILE(assets + "/" + name);
        for (const double speed : {0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 1.6, 2.2, 3.0})
            test::expect_law_of_others(name + test::numbered(", %g m/s", speed),
                                       watched(character, 12, test::ahead(speed)));
        for (const double degrees : {60.0, 120.0, 180.0})
            test::expect_law_of_others(name + test::numbered(", %g degrees", degrees),
                                       watched(character, 8, test::corner(1, degrees)));
        test::expect_law_of_others(name + ", stop and go", watched(character, 24, test::stop_and_go(1, 3, 4)));
        test::expect_law_of_others(name + ", shuffles", watched(character, 24, test::shuffle(0.2, 3)));
    }
}

INSTANTIATE_TEST_SUITE_P(Files, FootLaw, testing::ValuesIn(files), [](const auto &info) {
    std::string name = info.param.path;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});
