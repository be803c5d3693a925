// The coarse test before the first cull phase keeps who is near any view, in order, and hardly anyone else.
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "lib/frame/steps.h"
#include "tests/law/support/scene.h"

namespace claque::frame
{

namespace
{

using namespace testing_support;

class CullBoundsTest : public ::testing::Test
{
protected:
    CullBoundsTest() : scene_(many()) { scene_.add_view(glm::dvec3(0, 20, 0), glm::dvec3(0, 0, -30)); }

    static SceneDef many()
    {
        SceneDef def;
        def.actors = 1001;
        return def;
    }
    // Whether a sphere `larger` times as large as that of a row meets a view.
    bool meets_any(uint32_t row, double larger) const
    {
        const crowd::Transform &transform = scene_.crowd.transform_of(row);
        const double radius =
            larger * std::fabs(double(transform.scale)) * double(scene_.crowd.extent_of(row).refpoint);
        for (const CameraState &eye : eyes_)
            if (test(eye.frustum, transform.position - eye.eye, radius) != math::Containment::outside) return true;
        return false;
    }
    std::vector<uint32_t> kept(Cull cull)
    {
        eyes_.clear();
        for (const auto &view : scene_.views) eyes_.emplace_back(*view);
        Settings settings;
        settings.cull = cull;
        const Given given{scene_.crowd, settings, base::Span<const CameraState>(eyes_), 1, 1, jobs_, host_calls_};
        std::vector<uint32_t> rows(scene_.crowd.row_count());
        std::iota(rows.begin(), rows.end(), 0);
        std::vector<uint8_t> near(rows.size(), 7);
        rows.resize(CullBounds{given, base::Span<uint8_t>(near), base::Span<uint32_t>(rows)}.run());
        return rows;
    }

    Scene scene_;
    std::vector<CameraState> eyes_;
    base::Jobs jobs_;
    base::HostCalls host_calls_;
};

}  // namespace

TEST_F(CullBoundsTest, KeepsActorsNearAnyViewInOrderAndFewOthers)
{
    uint32_t all = 0, outside = 0;
    for (int turn = 0; turn < 40; ++turn) {
        const double a = turn * 0.157;
        scene_.look(0, glm::dvec3(9 * std::cos(a), 1.5, -12), glm::dvec3(30 * std::sin(a), 1, 30 * std::cos(a)));
        scene_.look(1, glm::dvec3(4, 1.5, -40), glm::dvec3(30 * std::sin(3 * a), 1, 60 * std::cos(3 * a)));
        std::vector<uint32_t> exactly;
        for (const uint32_t row : kept(Cull::actor)) {
            EXPECT_TRUE(meets_any(row, 1.001)) << "row " << row << " is far from all views";
            if (meets_any(row, 1)) exactly.push_back(row);
        }
        std::vector<uint32_t> wanted;
        for (uint32_t row = 0; row < scene_.crowd.row_count(); ++row)
            if (meets_any(row, 1)) wanted.push_back(row);
        EXPECT_EQ(exactly, wanted) << turn;
        all += scene_.crowd.row_count(), outside += scene_.crowd.row_count() - static_cast<uint32_t>(wanted.size());
    }
    EXPECT_GT(outside, all / 10);
    EXPECT_LT(outside, all - all / 10);
}

TEST_F(CullBoundsTest, KeepsAllInTraditionalMode)
{
    scene_.look(0, glm::dvec3(0), glm::dvec3(0, 0, 50));
    EXPECT_EQ(kept(Cull::traditional).size(), scene_.crowd.row_count());
}

}  // namespace claque::frame
