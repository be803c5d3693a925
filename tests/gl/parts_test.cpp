// Culling parts changes no pixel (S0 4.2, phases 3 and 7).
#include <glm/gtc/type_ptr.hpp>

#include "lib/frame/spheres.h"
#include "tests/gl/support/driver.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/jointed.h"
#include "tests/gl/support/spy.h"

namespace gltest
{
namespace
{

using claque::draw::DrawList;

class Parts : public GlTest
{
protected:
    static constexpr float aspect = 4.0f / 3.0f;
    void SetUp() override { make_context(160, 120); }

    Picture draw_with(passes::Renderer &renderer, DrawList list, uint64_t parts, double least_share = 0.02)
    {
        list.items[0].parts = parts;
        return draw(*context_, renderer, list, least_share);
    }
    // By the library's spheres.
    static uint64_t parts_in_view(const Jointed &jointed, const Camera &camera)
    {
        const glm::dmat4 view(glm::make_mat4(camera.model_view));
        const model::Template &tmpl = *jointed.posed.tmpl;
        return claque::frame::parts_in_view(tmpl, tmpl.levels[0], jointed.palette.data(),
                                            {glm::dmat3(view), glm::dvec3(view[3]), 1},
                                            claque::math::frustum_of(camera.projection))
            .parts;
    }
};

TEST_F(Parts, OutOfViewAreCulledWithoutAChangeInThePicture)
{
    const Jointed puppet_on = make_jointed(puppet(), torture_map(128, 8, 3), 0.7f);
    ASSERT_EQ(puppet_on.parts.size(), 11u);
    const uint64_t all = (uint64_t(1) << puppet_on.parts.size()) - 1;
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(puppet_on.posed, options_of(strategy));
        uint32_t partial = 0, drawn = 0;
        const uint32_t cameras = on_softpipe() ? 40 : 200;
        for (uint32_t i = 0; i < cameras; ++i) {
            const Camera camera = hashed_camera(puppet_on.posed, i, aspect);
            const DrawList list = list_of(puppet_on.posed, camera);
            const uint64_t in = parts_in_view(puppet_on, camera);
            const Picture whole = draw_with(*renderer, list, ~uint64_t(0), 0);
            EXPECT_TRUE(draw_with(*renderer, list, in, 0) == whole) << "camera " << i << ", parts " << in;
            partial += in != 0 && in != all;
            drawn += covered(whole) > 0;
        }
        EXPECT_GT(partial, cameras / 2) << "too few cameras cull any part";
        EXPECT_GT(drawn, cameras * 19 / 20)
            << "too many cameras look past it; 197 of 200 did not when this was written";
    }
}

TEST_F(Parts, InViewAreMissingWhenCulled)
{
    const Jointed puppet_on = make_jointed(puppet(), torture_map(128, 8, 3));
    const DrawList list = list_of(puppet_on.posed, camera_on(puppet_on.posed, 2.6f, 0, 0.1f, aspect));
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(puppet_on.posed, options_of(strategy));
        const Picture whole = draw_with(*renderer, list, ~uint64_t(0));
        for (size_t part = 0; part < puppet_on.parts.size(); ++part)
            EXPECT_FALSE(draw_with(*renderer, list, ~(uint64_t(1) << part)) == whole) << "part " << part;
    }
}

TEST_F(Parts, DrawnOneByOneGiveThePictureOfTheWhole)
{
    for (const bool coloured : {false, true}) {
        Jointed puppet_on = make_jointed(puppet(), torture_map(128, 8, 3));
        model::Level &level = puppet_on.posed.tmpl->levels[0];
        for (uint32_t v = 0; v < level.vertex_count && coloured; ++v) {
            const uint32_t from = v < level.source_count ? v : level.copies[v - level.source_count];
            level.colours.insert(level.colours.end(), {uint8_t(from * 7), uint8_t(255 - from), uint8_t(from), 255});
        }
        uint32_t seen = 0;
        for (const passes::Strategy strategy : all_strategies)
            for (uint32_t i = 0; i < 10; ++i) {
                const DrawList whole = list_of(puppet_on.posed, hashed_camera(puppet_on.posed, i, aspect));
                DrawList one_by_one(std::pmr::get_default_resource());
                std::copy_n(whole.projection, 16, one_by_one.projection);
                for (uint32_t part = 0; part < puppet_on.parts.size(); ++part) {
                    one_by_one.items.push_back(whole.items[0]);
                    one_by_one.items.back().parts = uint64_t(1) << part;
                }
                // A new one, without colours from earlier pictures.
                const auto renderer = make_renderer_of(puppet_on.posed, options_of(strategy));
                const Picture parts = draw(*context_, *renderer, one_by_one, 0);
                EXPECT_TRUE(parts == draw(*context_, *renderer, whole, 0)) << i;
                seen += covered(parts) > 400;
            }
        EXPECT_GT(seen, 20u) << "too many cameras look past it";
    }
}

// Runs of neighbouring parts are one call; drawing all parts takes as many calls as a mesh without parts.
TEST_F(Parts, ThatAreNeighboursAreDrawnTogether)
{
    const Jointed rope_of_8 = make_jointed(rope(8), torture_map(128, 1, 3));
    const DrawList list = list_of(rope_of_8.posed, camera_on(rope_of_8.posed, 2.6f, 0, 0, aspect));
    const model::Level &level = rope_of_8.posed.tmpl->levels[0];
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), options_of(passes::Strategy::fused));
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*rope_of_8.posed.tmpl).ok());
    // Even parts belong to one surface, odd ones to the other: within each, the four are adjacent.
    const struct {
        uint64_t parts;
        uint32_t draws, shown;
    } cases[] = {{~uint64_t(0), 2, 8}, {0xff, 2, 8}, {0x0f, 2, 4}, {0x3c, 2, 4}, {0x11, 2, 2},
                 {0x05, 1, 2},         {0x33, 4, 4}, {0x80, 1, 1}, {0x00, 0, 0}, {~uint64_t(0xff), 0, 0}};
    for (const auto &c : cases) {
        DrawList some = list;
        some.items[0].parts = c.parts;
        spy.reset();
        passes::DrawStats stats;
        ASSERT_TRUE(renderer.draw(some, &stats).ok());
        EXPECT_EQ(stats.draws, c.draws) << c.parts;
        EXPECT_EQ(spy.calls["glDrawElements"], c.draws) << c.parts;
        EXPECT_EQ(stats.parts, c.shown) << c.parts;
        EXPECT_EQ(stats.individuals, c.shown ? 1u : 0u) << c.parts;
        uint32_t triangles = 0;
        for (uint32_t part = 0; part < 8; ++part) triangles += (c.parts >> part & 1) ? level.parts[part].triangles : 0;
        EXPECT_EQ(stats.triangles, triangles) << c.parts;
    }
}

TEST_F(Parts, OfActorsKeptForTheirShadowAloneAreNotDrawn)
{
    const PosedModel posed = small_posed();
    const auto renderer = make_renderer_of(posed);
    const DrawList one = list_of(posed, whole_view(posed));
    const Picture picture = draw(*context_, *renderer, one);
    DrawList two = one;
    two.items.push_back(one.items[0]);
    two.items[1].model_view[12] += 0.8f;
    two.items[1].vertices = {};
    two.items[1].shadow_only = true;
    EXPECT_EQ(draw(*context_, *renderer, two), picture);
    passes::DrawStats stats;
    ASSERT_TRUE(renderer->draw(two, &stats).ok());
    EXPECT_EQ(stats.individuals, 1u);
    EXPECT_EQ(stats.parts, 1u);
}

TEST_F(Parts, OfALevelWithoutTrianglesAskForNothing)
{
    PosedModel posed = small_posed();
    posed.tmpl->levels.emplace_back(std::pmr::get_default_resource());
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), passes::RendererOptions());
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
    DrawList list = list_of(posed, whole_view(posed));
    list.items[0].level = 1;
    list.items[0].vertices = {};
    spy.reset();
    passes::DrawStats stats;
    const Status status = renderer.draw(list, &stats);
    EXPECT_TRUE(status.ok()) << status.text;
    EXPECT_EQ(stats.individuals, 0u);
    EXPECT_EQ(spy.calls["glPushAttrib"], 0u) << "nothing to draw: no GL calls";
}

TEST_F(Parts, WithOffsetsThatDoNotAscendAreRefused)
{
    Jointed puppet_on = make_jointed(puppet(), torture_map(128, 8, 3));
    model::Array<uint32_t> &firsts = puppet_on.posed.tmpl->levels[0].surfaces[0].part_offsets;
    const auto refused = [&](const char *what) {
        const Status status = make_renderer()->prepare(*puppet_on.posed.tmpl);
        EXPECT_EQ(status.code, CLQ_ARGUMENT) << what;
        EXPECT_NE(std::string(status.text).find("part"), std::string::npos) << status.text;
    };
    const model::Array<uint32_t> good = firsts;
    firsts.back() += 3;
    refused("past the end");
    firsts = good;
    firsts[1] = firsts[firsts.size() - 1] + 300;
    refused("falling");
    firsts = good;
    firsts.pop_back();
    refused("too few");
    firsts = good;
    EXPECT_TRUE(make_renderer()->prepare(*puppet_on.posed.tmpl).ok());
}

}  // namespace
}  // namespace gltest
