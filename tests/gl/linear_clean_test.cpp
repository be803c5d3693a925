// Bilinear filtering of clean triangles: zones stay exact to the pixel; shades within them are filtered.
#include "passes/linear_clean.h"

#include <cmath>
#include <set>

#include "lib/figures/figure.h"
#include "meshsplit/build.h"
#include "passes/linear_footprint.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

passes::RendererOptions linear_options(passes::Strategy strategy)
{
    passes::RendererOptions options = options_of(strategy);
    options.linear_clean = true;
    return options;
}

PosedModel citizen(bool white)
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    claque::meshsplit::build(claque::figures::citizen(), {}, *tmpl);
    if (white) whiten(*tmpl);
    PosedModel posed;
    posed.tmpl = std::move(tmpl);
    skin(*posed.tmpl, model::none, 0, posed.positions, posed.normals);
    measure(posed);
    return posed;
}

using Smooth = GlTest;

// The law's own picture: with white light and dark zones a filtered texel shows its zone's colour if nothing is mixed.
TEST_F(Smooth, MixesNoZonesUnderAnyStrategy)
{
    const PosedModel posed = citizen(true);
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    for (const float distance : {0.9f, 2.6f, 12.0f})
        for (const passes::Strategy strategy : all_strategies) {
            SCOPED_TRACE(testing::Message() << distance << ", strategy " << int(strategy));
            const Camera camera = camera_on(posed, distance, 0.4f, 0.2f, float(width) / height);
            auto plain = make_renderer_of(posed, options_of(strategy));
            auto filtered = make_renderer_of(posed, linear_options(strategy));
            const auto list = list_of(posed, camera, colours.data());
            const double least_share = 0.1 / double(distance * distance);
            EXPECT_EQ(draw(*context_, *plain, list, least_share), draw(*context_, *filtered, list, least_share));
            plain->destroy(), filtered->destroy();
        }
}

TEST_F(Smooth, FiltersWhatItMayAndShowsTheSameUnderEveryStrategy)
{
    const PosedModel posed = citizen(false);
    const Camera camera = camera_on(posed, 0.9f, 0.4f, 0.2f, float(width) / height);
    Picture first;
    for (const passes::Strategy strategy : all_strategies) {
        auto filtered = make_renderer_of(posed, linear_options(strategy));
        const Picture picture = draw(*context_, *filtered, list_of(posed, camera));
        if (first.empty()) first = picture;
        EXPECT_EQ(picture, first) << "strategy " << int(strategy);
        filtered->destroy();
    }
    auto plain = make_renderer_of(posed);
    const Picture nearest = draw(*context_, *plain, list_of(posed, camera));
    plain->destroy();
    size_t other = 0;
    for (size_t i = 0; i < first.size(); ++i) other += first[i] != nearest[i];
    EXPECT_GT(other, first.size() / 50) << "near by, filtering changes many pixels";
}

TEST_F(Smooth, TakesOneDrawMoreAndReportsTheStepAlongItsEdges)
{
    const PosedModel posed = citizen(false);
    auto plain = make_renderer_of(posed), filtered = make_renderer_of(posed, linear_options(passes::Strategy::fused));
    const Camera camera = whole_view(posed);
    passes::DrawStats one, two;
    ASSERT_TRUE(plain->draw(list_of(posed, camera), &one).ok());
    ASSERT_TRUE(filtered->draw(list_of(posed, camera), &two).ok());
    EXPECT_EQ(one.draws, 1u);
    EXPECT_EQ(two.draws, 2u);
    EXPECT_EQ(two.triangles, one.triangles);
    const passes::LuminanceStep step = filtered->step_of(*posed.tmpl);
    EXPECT_EQ(step.triangles, posed.tmpl->report.triangles);
    EXPECT_GT(step.linear_triangles, step.triangles / 4);
    EXPECT_LE(step.linear_triangles, step.triangles - posed.tmpl->report.dirty);
    EXPECT_GT(step.edges, 0u);
    EXPECT_GT(step.mean, 0);
    EXPECT_GE(step.max, step.mean);
    EXPECT_EQ(plain->step_of(*posed.tmpl).edges, 0u);
    plain->destroy(), filtered->destroy();
}

// Compared with brute force: the four texels of each of many samples.
TEST(LinearFootprint, NeverLetsATriangleThroughThatTakesTwoZonesAnywhere)
{
    model::Template tmpl(std::pmr::get_default_resource());
    claque::meshsplit::build(model_of(sheet(9, 0.2f), torture_map(64, 5, 3), {10, 20, 30, 40, 50}, model::Wrap::repeat),
                             {}, tmpl);
    const model::Texture &texture = tmpl.textures[0];
    const passes::LinearFootprint footprint(texture);
    uint64_t state = 12345;
    const auto random = [&] {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return float(state >> 40) / float(1 << 24);
    };
    const auto key = [&](int64_t x, int64_t y) {
        const auto wrap = [](int64_t at) { return size_t(((at % 64) + 64) % 64); };
        return texture.rgba[4 * (wrap(y) * 64 + wrap(x)) + 3];
    };
    int passed = 0, refused_clean = 0;
    for (int t = 0; t < 4000; ++t) {
        const glm::vec2 middle(random() * 2 - 0.5f, random() * 2 - 0.5f);
        const float size = 0.004f + 0.12f * random() * random();
        glm::vec2 uv[3];
        for (glm::vec2 &corner : uv) corner = middle + size * glm::vec2(random() - 0.5f, random() - 0.5f);
        std::set<int> keys;
        for (int s = 0; s < 300; ++s) {
            float a = random(), b = random();
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const glm::vec2 at = (uv[0] + a * (uv[1] - uv[0]) + b * (uv[2] - uv[0])) * 64.0f - glm::vec2(0.5f);
            for (int k = 0; k < 4; ++k)
                keys.insert(key(int64_t(std::floor(at.x)) + k % 2, int64_t(std::floor(at.y)) + k / 2));
        }
        if (footprint.has_one_zone(uv)) {
            ++passed;
            EXPECT_EQ(keys.size(), 1u) << t;
        } else {
            refused_clean += keys.size() == 1;
        }
    }
    EXPECT_GT(passed, 400);
    EXPECT_LT(refused_clean, passed) << "otherwise filtering would be useless";
}

}  // namespace
}  // namespace gltest
