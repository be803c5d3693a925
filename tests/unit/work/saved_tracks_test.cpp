// Making a track of points, finding its passings and reading a saved track take work in proportion to the points.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/walker.h"
#include "work_counter.h"

namespace
{

using claque::testing::blocks_entered;

void expect_ok(clq_status status) { ASSERT_EQ(status, CLQ_OK) << clq_last_error(); }

// What tracks need.
class SavedTrackWork : public ::testing::Test
{
protected:
    SavedTrackWork()
    {
        expect_ok(clq_context_create(nullptr, &context_));
        expect_ok(clq_template_build(context_, &small_.def, &tmpl_));
        const uint32_t clip = 0;
        const clq_locomotion_def def = Walker::locomotion(tmpl_, &clip);
        expect_ok(clq_locomotion_create(context_, &def, &locomotion_));
    }
    ~SavedTrackWork() override
    {
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }

    // A person walks for 4 s and stands for 2 s, again and again.
    static std::vector<clq_track_point> points(size_t count, double x = 0)
    {
        std::vector<clq_track_point> out;
        double z = 0;
        for (size_t i = 0; i < count; ++i) {
            z += i % 30 < 20 ? 0.24 : 0;
            out.push_back({0.2 * double(i), {x, 0, z}, NAN});
        }
        return out;
    }
    static clq_track_def def_of(const std::vector<clq_track_point> &points)
    {
        clq_track_def def = clq_track_def_init();
        def.point_count = static_cast<uint32_t>(points.size()), def.points = points.data();
        return def;
    }

    SmallTemplate small_;
    Walker walker_{small_};
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
};

void expect_growth(const char *name, uint64_t few, uint64_t many)
{
    EXPECT_GT(few, 3000u) << name << ": nothing is counted";
    EXPECT_LE(many, 16 * few) << name;
    ::testing::Test::RecordProperty(name, std::to_string(double(many) / double(few)));
}

TEST_F(SavedTrackWork, GrowsWithThePoints)
{
    uint64_t work[2][3];
    for (const size_t k : {0u, 1u}) {
        const std::vector<clq_track_point> way = points(k == 0 ? 300 : 3000);
        const clq_track_def def = def_of(way);
        clq_track *made = nullptr, *loaded = nullptr;
        std::string bytes;
        const auto append = [](void *to, const void *from, size_t size) {
            static_cast<std::string *>(to)->append(static_cast<const char *>(from), size);
            return 0;
        };
        work[k][0] = blocks_entered([&] { expect_ok(clq_track_create(locomotion_, &def, &made)); });
        work[k][1] = blocks_entered([&] { expect_ok(clq_track_save(made, append, &bytes)); });
        work[k][2] =
            blocks_entered([&] { expect_ok(clq_track_load(locomotion_, bytes.data(), bytes.size(), &loaded)); });
        clq_track_destroy(made);
        clq_track_destroy(loaded);
    }
    const char *const names[] = {"making", "saving", "loading"};
    for (const size_t i : {0u, 1u, 2u}) expect_growth(names[i], work[0][i], work[1][i]);
}

TEST_F(SavedTrackWork, OfPassingsGrowsWithThePeople)
{
    const auto finding = [&](size_t people) {
        std::vector<std::vector<clq_track_point>> ways;
        for (size_t i = 0; i < people; ++i) ways.push_back(points(20, 0.8 * double(i)));
        std::vector<clq_track_def> defs;
        for (const auto &way : ways) defs.push_back(def_of(way));
        std::vector<const clq_track_def *> all;
        for (const clq_track_def &def : defs) all.push_back(&def);
        size_t found = 0;
        const auto count = static_cast<uint32_t>(people);
        return blocks_entered([&] { expect_ok(clq_find_passings(context_, all.data(), count, nullptr, 0, &found)); });
    };
    expect_growth("people", finding(100), finding(1000));
}

}  // namespace
