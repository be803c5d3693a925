// Batches: which individuals share GL calls, that the picture is right, and that other neighbours stay apart.
#include <cmath>

#include "tests/gl/support/crowds.h"
#include "tests/gl/support/hooked.h"

namespace gltest
{
namespace
{

using Batches = CrowdOf<120>;

TEST_F(Batches, TakeManyIndividualsInOneCall)
{
    passes::DrawStats together, one_by_one;
    shown(many(), {}, &together);
    shown(many(), apart(), &one_by_one);
    const uint32_t vertices = posed_->tmpl->levels[0].vertex_count;
    const uint32_t a_call = passes::Scratch::batch_vertices / vertices;
    ASSERT_GT(a_call, 3u);
    EXPECT_EQ(together.draws, (crowd + a_call - 1) / a_call);
    EXPECT_EQ(one_by_one.draws, crowd);
    EXPECT_EQ(together.individuals, one_by_one.individuals);
    EXPECT_EQ(together.triangles, one_by_one.triangles);
    EXPECT_EQ(together.vertices, one_by_one.vertices);
}

// Rounding in the transform to eye space now and then moves an edge over a pixel's centre.
TEST_F(Batches, ShowWhatSingleCallsShow)
{
    const Picture together = shown(many(), {}), one_by_one = shown(many(), apart());
    ASSERT_GT(covered(one_by_one), 5000u);
    EXPECT_LE(different(together, one_by_one, 0) * 1000, covered(one_by_one));
    DrawList moved = many();
    moved.items[crowd - 1].model_view[12] += 0.05f * posed_->radius;
    EXPECT_GT(different(shown(moved, {}), one_by_one, 0) * 1000, covered(one_by_one));
}

TEST_F(Batches, ShowPackedPeopleAsThoseInFloats)
{
    const float offset[3] = {0.3f, -0.2f, 0.1f}, step = posed_->radius / 8000;
    std::vector<int16_t> positions;
    std::vector<int8_t> normals;
    for (size_t i = 0; i < posed_->positions.size(); ++i) {
        positions.push_back(static_cast<int16_t>(std::lround((posed_->positions[i] - offset[i % 3]) / step)));
        normals.push_back(static_cast<int8_t>(std::lround(127 * posed_->normals[i])));
        if (i % 3 == 2) positions.push_back(0), normals.push_back(0);
    }
    DrawList packed = many();
    for (Item &item : packed.items) {
        item.vertices = claque::draw::Vertices();
        item.vertices.short_positions = positions.data(), item.vertices.byte_normals = normals.data();
        item.vertices.step = step;
        std::copy_n(offset, 3, item.vertices.offset);
    }
    const Picture floats = shown(many(), {}), shorts = shown(packed, {});
    ASSERT_GT(covered(floats), 5000u);
    EXPECT_LE(different(shorts, floats, 2) * 100, covered(floats));
}

TEST_F(Batches, AreTheSameForAllStrategiesAndFormatsOfColours) { expect_the_same_for_all_strategies_and_formats(); }

// Lit from the side, in odd scales and mirrored: normals are transformed as by GL.
TEST_F(Batches, LightTheirIndividualsAsGlWould)
{
    light_from({1, 0.4f, 0.2f, 0});
    const DrawList list = squeezed();
    const Picture together = shown(list, {}), one_by_one = shown(list, apart());
    EXPECT_GT(different(one_by_one, shown(many(), apart()), 40), 1000u);
    EXPECT_LE(different(together, one_by_one, 1) * 500, covered(one_by_one));
}

TEST_F(Batches, AreDrawnBeforeTheHooksOfTheNextActor)
{
    std::vector<uint32_t> seen;
    DrawList list = many();
    Picture before;
    const auto read =
        host_->ask<void (*)(int32_t, int32_t, int32_t, int32_t, gl::Enum, gl::Enum, void *)>("glReadPixels");
    const auto look = [&] {
        before.resize(size_t(3) * width * height);
        read(0, 0, width, height, 0x1907, gl::unsigned_byte, before.data());  // GL_RGB
        seen.push_back(covered(before));
        return 0;
    };
    const Callbacks both(look, look);
    list.items[20].hooks = &both.hooks;
    passes::DrawStats stats;
    shown(list, {}, &stats);
    ASSERT_GE(seen.size(), 2u);
    EXPECT_GT(seen[0], 1000u);    // those before it
    EXPECT_GT(seen[1], seen[0]);  // and then this one alone
    EXPECT_EQ(stats.individuals, crowd);
}

TEST_F(Batches, LeaveActorsWithMoreTrianglesToASingleCall)
{
    passes::RendererOptions few;
    few.batch_triangles = 60;
    passes::DrawStats stats;
    shown(many(), few, &stats);
    EXPECT_EQ(stats.draws, crowd);
}

}  // namespace
}  // namespace gltest
