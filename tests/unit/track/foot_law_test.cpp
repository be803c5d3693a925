// The foot law on files that others made: no foot of ten characters slides by more than 20 mm while it carries weight,
// and feet carry it for most of the time.
// Prints the table of docs/measurements.md.
#include <claque/assets.h>
#include <claque/trajectories.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "lib/api/track_handle.h"
#include "tests/support/collected_file.h"
#include "tests/unit/track/feet.h"

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
    // Of the time in which people walk, the most in which the track holds neither foot, and how deep a foot that swings
    // may then be in the ground. Other people's walks show few contacts: what is not held, the law does not see.
    double most_flying_share, most_deep_m;
};
const Character characters[] = {
    {"citizen", "walk", "jog", "stand", 1, 0.1, 0.025},
    {"patrician", "walk", "jog", "stand", 1, 0.1, 0.025},
    {"plebeian", "walk", "jog", "stand", 1, 0.1, 0.025},
    {"decurion", "walk", "jog", "stand", 1, 0.1, 0.025},
    {"humanoids/kaykit/Barbarian.glb", "Walking_A", "Running_A", "Idle", 0.73, 0.94, 0.07},
    {"humanoids/kaykit/Mage.glb", "Walking_A", "Running_A", "Idle", 0.65, 0.98, 0.065},
    {"humanoids/kaykit/Rogue.glb", "Walking_A", "Running_A", "Idle", 0.8, 0.91, 0.08},
    {"humanoids/quaternius-ultimate/Casual_Male.gltf", "Walk", "Run", "Idle", 0.54, 0.5, 0.015},
    {"humanoids/quaternius-ultimate/Kimono_Female.gltf", "Walk", "Run", "Idle", 0.54, 0.5, 0.015},
    {"humanoids/gdquest/gdbot.glb", "walk", "run", "Idle", 1, 0.2, 0.06},
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

constexpr uint32_t max_people = 16;  // of a file, evenly spread over it

class FootLaw : public testing::TestWithParam<File>
{
protected:
    static void SetUpTestSuite() { ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    static void TearDownTestSuite()
    {
        for (auto &[name, locomotion] : walks_) clq_locomotion_destroy(locomotion);
        walks_.clear();
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
    }
    void SetUp() override
    {
        CLAQUE_NEEDS_FILE(assets + "/tracks/" + GetParam().path);
        clq_trajectories_def def = clq_trajectories_def_init();
        def.rate_hz = GetParam().rate_hz, def.metres_per_unit = GetParam().metres_per_unit;
        const std::string path = assets + "/tracks/" + GetParam().path;
        const clq_status status = clq_trajectories_load(context_, path.c_str(), &def, &read_);
        if (const char *library = absent_library(GetParam().path)) {
            EXPECT_EQ(status, CLQ_UNSUPPORTED) << clq_last_error();
            GTEST_SKIP() << "this build has no " << library;
        }
        ASSERT_EQ(status, CLQ_OK) << clq_last_error();
    }
    void TearDown() override { clq_trajectories_destroy(read_); }

    static const clq_locomotion *walk_of(const Character &character)
    {
        clq_locomotion *&made = walks_[character.name];
        if (made) return made;
        clq_template *tmpl = nullptr;
        const bool built_in = std::string(character.name).find('.') == std::string::npos;
        const std::string path = assets + "/" + character.name;
        if (built_in) {
            EXPECT_EQ(clq_template_builtin(context_, character.name, &tmpl), CLQ_OK) << clq_last_error();
        } else {
            clq_asset *asset = nullptr;
            EXPECT_EQ(clq_asset_load_file(context_, path.c_str(), nullptr, &asset), CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_asset_build(context_, asset, 256, &tmpl), CLQ_OK) << clq_last_error();
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
        EXPECT_EQ(clq_locomotion_create(context_, &def, &made), CLQ_OK) << path << ": " << clq_last_error();
        clq_template_destroy(tmpl);
        return made;
    }

    clq_track *track_of(const clq_locomotion *walk, uint32_t number, double scale) const
    {
        clq_trajectory_person person = clq_trajectory_person_init();
        EXPECT_EQ(clq_trajectories_get_person(read_, number, &person), CLQ_OK);
        const clq_trajectory_sample *samples = clq_trajectories_get_samples(read_) + person.first_sample;
        std::vector<clq_track_point> points;
        for (uint64_t i = 0; i < person.sample_count; ++i)
            points.push_back(
                {samples[i].time_s, {samples[i].x, samples[i].z, -samples[i].y}, samples[i].heading_rad + 1.5707963f});
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
        def.scale = static_cast<float>(scale), def.seed = number;
        clq_track *made = nullptr;
        EXPECT_EQ(clq_track_create(walk, &def, &made), CLQ_OK) << clq_last_error();
        return made;
    }

    static clq_context *context_;
    static std::map<std::string, clq_locomotion *> walks_;
    clq_trajectories *read_ = nullptr;
};

clq_context *FootLaw::context_ = nullptr;
std::map<std::string, clq_locomotion *> FootLaw::walks_;

}  // namespace

TEST_P(FootLaw, HoldsForTenCharacters)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    ASSERT_EQ(clq_trajectories_get_info(read_, &info), CLQ_OK);
    const uint32_t every = std::max(1u, info.person_count / max_people);
    for (const Character &character : characters) {
        const clq_locomotion *walk = walk_of(character);
        ASSERT_NE(walk, nullptr);
        test::Soles soles(*walk);
        test::FootDrift drift;
        test::Swings swings;
        double mean_m = 0, max_m = 0;
        int people = 0;
        for (uint32_t i = 0; i < info.person_count; i += every, ++people) {
            clq_track *track = track_of(walk, i, character.scale);
            drift.add(test::drift_of(soles, *track, 0.04));
            swings.add(test::swings_of(soles, *track, 0.23));
            mean_m += track->mean_shift_m, max_m = std::max(max_m, track->max_shift_m);
            clq_track_destroy(track);
        }
        std::printf("feet: %s | %s | %d people, %zu steps | %.1f | %.1f | %.1f mm | path %.3f m, at most %.3f\n",
                    GetParam().path, character.name, people, drift.each.size(), 1e3 * drift.mean(),
                    1e3 * drift.at_share(0.95), 1e3 * drift.max(), mean_m / people, max_m);
        EXPECT_LT(drift.max(), 0.020) << character.name;  // viewers notice 21 mm
        EXPECT_GT(drift.each.size(), 10u);
        EXPECT_LE(swings.flying_s, character.most_flying_share * swings.moving_s + 1) << character.name;
        EXPECT_LE(swings.deepest_m, character.most_deep_m) << character.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, FootLaw, testing::ValuesIn(files), [](const auto &info) {
    std::string name = info.param.path;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});
