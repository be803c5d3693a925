// The comparison of two folders, and that it can fail: each mutation, in each kind of array alone.
#include "samples/parity/compare.h"

#include <algorithm>
#include <cmath>

#include "samples/parity/verdict.h"
#include "tests/unit/parity/capture_files.h"

namespace parity
{
namespace
{

class Comparing : public parity_test::CaptureFiles
{
protected:
    Comparing()
    {
        write_result("a");
        a = read_capture(folder("a"));
        b = a;
        b.folder = "b";
    }

    Verdict verdict(const char *tolerance) const { return verdict_of(compare(a, b, 67), tolerance_of(tolerance)); }
    double value(const std::string &name) const
    {
        for (const Measure &m : compare(a, b, 67).measures)
            if (m.name == name) return m.value;
        return std::nan("");
    }
    std::string refusal() const
    {
        try {
            compare(a, b, 67);
            return "compared";
        } catch (const Unreadable &error) {
            return error.what();
        }
    }
    void fails(const std::string &measure) const
    {
        for (const char *tolerance : {"exact", "gpu"}) {
            const Verdict v = verdict(tolerance);
            EXPECT_FALSE(v.pass) << tolerance;
            EXPECT_NE(reasons(v, 99).find(measure), std::string::npos) << tolerance << ": " << reasons(v, 99);
        }
    }

    Capture a, b;
};

TEST_F(Comparing, ACaptureWithItselfPassesEverything)
{
    for (const Tolerance &t : named_tolerances()) EXPECT_TRUE(verdict(t.name.c_str()).pass) << t.name;
    const Comparison c = compare(a, b, 67);
    EXPECT_TRUE(c.not_compared.empty());
    for (const Measure &m : c.measures) {
        if (m.name == "colour.ssim") EXPECT_NEAR(m.value, 1, 1e-12);
        else if (m.name == "colour.psnr_db") EXPECT_TRUE(std::isinf(m.value));
        else EXPECT_EQ(m.value, 0) << m.name;
    }
}

TEST_F(Comparing, EveryMeasureIsMade)
{
    const Comparison c = compare(a, b, 67);
    ASSERT_EQ(c.measures.size(), measure_kinds().size());
    for (size_t i = 0; i < c.measures.size(); ++i) EXPECT_EQ(c.measures[i].name, measure_kinds()[i].name);
}

TEST_F(Comparing, OtherScenesAreRefused)
{
    b.time_s = 1.54;
    EXPECT_EQ(refusal(), "b shows the time 1.54 s, and " + a.folder + " 1.5 s");
    b = a;
    b.width = 17;
    EXPECT_EQ(refusal(), a.folder + " has a picture of 17 x 12, and " + a.folder + " one of 16 x 12");
    b = Capture();
    b.folder = "b";
    b.width = 16;
    b.height = 12;
    b.time_s = 1.5;
    EXPECT_EQ(refusal(), a.folder + " and b have no array in common: nothing to compare");
}

TEST_F(Comparing, AbsentDataIsReportedAndNotCompared)
{
    b.depth.reset();
    a.normals.reset();
    b.normals.reset();
    const Comparison c = compare(a, b, 67);
    ASSERT_EQ(c.not_compared.size(), 2u);
    EXPECT_EQ(c.not_compared[0].group + ": " + c.not_compared[0].why, "normals: neither has normals.npy");
    EXPECT_EQ(c.not_compared[1].group + ": " + c.not_compared[1].why, "depth: the result has no depth.npy");
    EXPECT_EQ(
        reasons(verdict("exact"), 9),
        "normals was not compared (neither has normals.npy), depth was not compared (the result has no depth.npy)");
    EXPECT_TRUE(verdict("loose").pass);
}

TEST_F(Comparing, APictureOfColoursAloneIsNotEnough)
{
    for (Capture *c : {&a, &b}) {
        c->actors.reset(), c->positions.reset(), c->normals.reset();
        c->depth.reset(), c->actor.reset(), c->zone.reset();
    }
    for (const char *tolerance : {"exact", "gpu", "coarse"}) {
        const Verdict v = verdict(tolerance);
        EXPECT_FALSE(v.pass) << tolerance;
        EXPECT_EQ(v.lacking.size(), 6u) << tolerance << ": " << reasons(v, 9);
    }
    EXPECT_TRUE(verdict("loose").pass);
}

TEST_F(Comparing, ExactAndGpuFailWherePeopleVerticesNormalsIdsDepthOrColourAreAbsent)
{
    const struct {
        const char *group;
        void (*forget)(Capture &);
    } cases[] = {
        {"actors", [](Capture &c) { c.actors.reset(); }},   {"positions", [](Capture &c) { c.positions.reset(); }},
        {"normals", [](Capture &c) { c.normals.reset(); }}, {"actor_ids", [](Capture &c) { c.actor.reset(); }},
        {"zone_ids", [](Capture &c) { c.zone.reset(); }},   {"depth", [](Capture &c) { c.depth.reset(); }},
        {"colour", [](Capture &c) { c.colour.reset(); }}};
    const Capture whole = a;
    for (const auto &one : cases) {
        a = b = whole;
        one.forget(a), one.forget(b);
        for (const char *tolerance : {"exact", "gpu"}) {
            const Verdict v = verdict(tolerance);
            EXPECT_FALSE(v.pass) << tolerance << " without " << one.group;
            EXPECT_EQ(reasons(v, 9).find(std::string(one.group) + " was not compared"), 0u) << reasons(v, 9);
        }
    }
}

TEST_F(Comparing, WithoutATableTheOrderOfTheOtherHolds)
{
    b.actors.reset();
    EXPECT_EQ(value("positions.max_m"), 0);
    b.positions->resize(27);
    EXPECT_NE(refusal().find("without actors.npy in both"), std::string::npos);
    a.actors.reset();
    b.positions = a.positions;
    EXPECT_EQ(value("positions.max_m"), 0);
    EXPECT_TRUE(std::isnan(value("positions.max_relative")));
}

TEST_F(Comparing, OneIndividualMissingIsFoundInTheTable)
{
    b.actors->erase(b.actors->begin() + 1);
    fails("actors.missing is 1");
    EXPECT_EQ(value("positions.max_m"), 0);  // of actors in both
    std::swap(a, b);
    fails("actors.added is 1");
}

TEST_F(Comparing, AnotherLevelIsFoundInTheTable)
{
    (*b.actors)[0].kind = "man, level 3";
    fails("actors.changed is 1");
}

TEST_F(Comparing, OneIndividualMissingIsFoundInEachPicture)
{
    const auto erase = [this](auto &map, auto nothing) {
        for (size_t i = 0; i < map.values.size(); ++i)
            if (a.actor->values[i] == 5) map.values[i] = nothing;
    };
    erase(*b.actor, 0u);
    fails("actor_ids.");
    EXPECT_EQ(value("actor_ids.outside"), 48);  // except the columns that border on the background
    b = a;
    erase(*b.depth, 1.0f);
    fails("depth.");
    EXPECT_FALSE(verdict("gpu").find("depth.worst_actor")->kept);
    b = a;
    for (size_t i = 0; i < b.colour->rgb.size(); ++i)
        if (a.actor->values[i / 3] == 5) b.colour->rgb[i] = 0;
    fails("colour.");
    EXPECT_GT(value("colour.worst_zone"), 50);
}

TEST_F(Comparing, OneZoneOfAnotherColourIsFoundWherePixelSharesHideIt)
{
    for (size_t i = 0; i < b.colour->rgb.size(); ++i)
        if (a.actor->values[i / 3] == 5 && a.zone->values[i / 3] == 1 && i % 3 == 1) b.colour->rgb[i] += 3;
    const Verdict v = verdict("gpu");
    EXPECT_FALSE(v.find("colour.worst_zone")->kept);
    EXPECT_EQ(value("colour.worst_zone"), 3);
}

// Actor 5's column at the background shows nothing in the result.
TEST_F(Comparing, DepthAndColourCountWhereIdsAgree)
{
    for (size_t i = 0; i < b.actor->values.size(); ++i) {
        if (i % 16 != 8) continue;
        b.actor->values[i] = 0, b.zone->values[i] = 0, b.depth->values[i] = 1;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) b.colour->rgb[c] = 0;
    }
    EXPECT_EQ(value("actor_ids.different"), 12.0 / 192);
    for (const char *measure : {"depth.max", "depth.p99_9", "depth.worst_actor", "colour.over_1", "colour.bias",
                                "colour.worst_zone", "colour.worst_bias"})
        EXPECT_EQ(value(measure), 0) << measure;
    EXPECT_GT(value("colour.max"), 0);  // of the whole picture
    b.actor.reset(), b.zone.reset();
    EXPECT_GT(value("depth.max"), 0.3);
    EXPECT_GT(value("colour.over_8"), 0.05);
}

TEST_F(Comparing, AtAnotherZoneColourDoesNotCountAndDepthDoes)
{
    const size_t at = 5 * 16 + 4;  // the first row of zone 2
    b.zone->values[at] = 1;
    b.colour->rgb[3 * at] = 0, b.depth->values[at] += 0.125f;
    EXPECT_EQ(value("colour.over_1"), 0);
    EXPECT_EQ(value("depth.max"), 0.125);
}

TEST_F(Comparing, AFewTexelsOfAnotherZonePassGpuAndAWholeZoneDoesNot)
{
    const auto only_zones = [this] {
        Verdict v = verdict("gpu");
        v.lacking.clear();
        return reasons(v, 9);
    };
    a.width = b.width = 200, a.height = b.height = 100;
    for (Capture *c : {&a, &b}) {
        c->depth.reset(), c->colour.reset();
        c->actor = Map<uint32_t>(200, 100, 2);
        c->zone = Map<uint16_t>(200, 100, 1);
        for (int y = 50; y < 56; ++y)
            for (int x = 50; x < 56; ++x) c->zone->values[c->zone->index(x, y)] = 2;
    }
    for (const int x : {10, 20, 30}) b.zone->values[b.zone->index(x, 20)] = 2;
    EXPECT_EQ(value("zone_ids.outside"), 3);
    EXPECT_EQ(value("zone_ids.outside_share"), 3.0 / 20000);
    EXPECT_EQ(only_zones(), "");
    for (int y = 51; y < 55; ++y)
        for (int x = 51; x < 55; ++x) b.zone->values[b.zone->index(x, y)] = 1;  // 16 of 20 000 pixels, one zone whole
    EXPECT_EQ(only_zones(), "zone_ids.worst_zone is 1 (at most 0.5)");
    EXPECT_LT(value("zone_ids.outside_share"), 0.001);
    for (int x = 0; x < 20; ++x) b.zone->values[b.zone->index(x, 90)] = 2;
    EXPECT_NE(only_zones().find("zone_ids.outside_share"), std::string::npos) << only_zones();
}

TEST_F(Comparing, OneIndividualMissingAmongManyIsFoundByItsShare)
{
    for (size_t i = 0; i < b.actor->values.size(); ++i)
        if (b.actor->values[i] == 2 && i / 16 > 0 && i / 16 < 11) b.actor->values[i] = 0;
    EXPECT_EQ(value("actor_ids.worst_actor"), 10.0 / 12);
    EXPECT_FALSE(verdict("coarse").find("actor_ids.worst_actor")->kept);
}

TEST_F(Comparing, AVertexThatMovesByMoreThanRoundingIsFound)
{
    (*b.positions)[10] += 0.0005f;
    fails("positions.");
    b = a;
    (*b.positions)[10] += 0.00005f;
    EXPECT_FALSE(verdict("exact").pass);
    EXPECT_TRUE(verdict("gpu").pass);
}

TEST_F(Comparing, ManyFloatsNearZeroAreExplainedAndPassGpu)
{
    (*a.positions)[0] = 1e-9f, (*b.positions)[0] = -2e-10f;
    EXPECT_GT(value("positions.ulp_max"), 1e9);
    for (const Measure &m : compare(a, b, 67).measures)
        if (m.name == "positions.ulp_max") EXPECT_EQ(m.where, "between 1e-09 and -2e-10");
    EXPECT_TRUE(verdict("gpu").pass);
}

TEST_F(Comparing, ANormalThatTurnsIsFound)
{
    (*b.normals)[3] = 0.05f;
    fails("normals.");
}

TEST_F(Comparing, NonFiniteNumbersAreFound)
{
    (*b.positions)[4] = std::nanf("");
    fails("positions.not_finite");
    b = a;
    (*b.normals)[4] = INFINITY;
    fails("normals.not_finite");
    b = a;
    b.depth->values[3] = std::nanf("");
    fails("depth.not_finite");
}

}  // namespace
}  // namespace parity
