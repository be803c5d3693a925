// Poses and vertices that a host asks for are those that drawing would use.
#include "animcache/inspect.h"

#include <cstring>

#include <gtest/gtest.h>

#include "animcache/caches.h"
#include "tests/law/support/figure.h"

namespace claque::animcache
{

namespace
{

class InspectionTest : public ::testing::TestWithParam<VertexFormat>
{
protected:
    Request request(double clip_time_s) const
    {
        Request made;
        made.tmpl = figure_.get();
        made.pose.version = 1;
        made.pose.clip = testing_support::clip_walk;
        made.pose.clip_time_s = clip_time_s;
        return made;
    }

    static void update(Caches &caches, const Request &request)
    {
        caches.begin().assign(1, request);
        caches.allocate_poses();
        caches.animate(base::Jobs());
        caches.allocate_vertices();
        caches.skin(base::Jobs());
    }

    Settings settings(Mode mode) const
    {
        Settings made;
        made.mode = mode;
        made.vertex_format = GetParam();
        return made;
    }

    bool are_equal(const draw::Vertices &a, const draw::Vertices &b) const
    {
        const size_t n = figure_->levels[0].vertex_count;
        if (a.packed() != b.packed() || a.step != b.step || std::memcmp(a.offset, b.offset, sizeof a.offset) != 0)
            return false;
        if (a.packed())
            return std::memcmp(a.short_positions, b.short_positions, 8 * n) == 0 &&
                   std::memcmp(a.byte_normals, b.byte_normals, 4 * n) == 0;
        return std::memcmp(a.positions, b.positions, 12 * n) == 0 && std::memcmp(a.normals, b.normals, 12 * n) == 0;
    }

    std::unique_ptr<model::Template> figure_ = testing_support::make_figure();
    const model::Template *templates_[1] = {figure_.get()};
};

}  // namespace

TEST_P(InspectionTest, VerticesAreThoseThatDrawingUsesInEveryCacheMode)
{
    for (const Mode mode : {Mode::none, Mode::animation, Mode::full}) {
        Caches caches(std::pmr::get_default_resource(), settings(mode));
        caches.reserve(1, base::Span<const model::Template *const>(templates_, 1));
        Inspection inspection(std::pmr::get_default_resource(), *figure_, GetParam());
        for (const double time_s : {0.1, 0.7}) {
            update(caches, request(time_s));
            const Request &shown = caches.requests()[0];
            const draw::Vertices drawn = caches.vertices_of(shown), asked = inspection.vertices(shown);
            ASSERT_TRUE(drawn.any());
            ASSERT_TRUE(asked.any());
            EXPECT_TRUE(are_equal(drawn, asked)) << time_s;
        }
    }
}

TEST_P(InspectionTest, AMissingPaletteIsEvaluatedAndEqualsTheCachedOne)
{
    Caches caches(std::pmr::get_default_resource(), settings(Mode::full));
    caches.reserve(1, base::Span<const model::Template *const>(templates_, 1));
    update(caches, request(0.4));
    Request without = caches.requests()[0];
    const draw::Pose cached = caches.pose_of(without);
    without.palette = nullptr;
    Inspection inspection(std::pmr::get_default_resource(), *figure_, GetParam());
    const draw::Pose made = inspection.pose(without);
    ASSERT_TRUE(made.palette);
    EXPECT_NE(made.palette, cached.palette);
    const size_t matrices = figure_->rig.palette.size();
    EXPECT_EQ(std::memcmp(made.palette, cached.palette, sizeof(math::Affine) * matrices), 0);
    for (size_t k = 0; k < figure_->rig.rest_weights.size(); ++k) EXPECT_EQ(made.weights[k], cached.weights[k]);
}

TEST_P(InspectionTest, TwoBlendedKeyPosesHaveNoPalette)
{
    Inspection inspection(std::pmr::get_default_resource(), *figure_, GetParam());
    Request blended = request(0.1);
    blended.key_pose.mode = KeyPoseMode::interpolated;
    EXPECT_FALSE(inspection.pose(blended).palette);
}

INSTANTIATE_TEST_SUITE_P(Of, InspectionTest, testing::Values(VertexFormat::floats, VertexFormat::packed));

}  // namespace claque::animcache
