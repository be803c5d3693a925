// Shadows on the ground: their position, that no pixel is darkened twice, and what hides them.
#include "tests/gl/support/jointed.h"
#include "tests/gl/support/shadows.h"

namespace gltest
{
namespace
{

TEST_F(Shadows, DarkenNoPixelTwiceHoweverManyTrianglesAndPeopleOverlap)
{
    for (const glm::dvec4 &light : {sun, lamp})
        for (const int32_t bit : {-1, 0, 7}) {
            const Picture picture = shown(people_, options_for(light, bit));
            EXPECT_GT(darkened(picture), 1500u) << bit;
            EXPECT_EQ(wrong_shades(picture), 0u) << bit;
        }
}

TEST_F(Shadows, LieWhereRaysSayThatNoLightComes)
{
    for (const glm::dvec4 &light : {sun, lamp}) {
        const std::vector<bool> expected = ground_.shaded(people_, light, width, height);
        for (const int32_t bit : {-1, 0}) {
            const Picture picture = shown(people_, options_for(light, bit));
            uint32_t wrong = 0;
            for (size_t i = 0; i < expected.size(); ++i) wrong += expected[i] != (picture[3 * i] < lit);
            // Edges of the shadow, which lies 2 mm above the ground: 1.8 and 1.5 % of it.
            EXPECT_LE(wrong * 45, darkened(picture)) << bit;
        }
    }
}

TEST_F(Shadows, AreTheSameWithAStencilBitAndWithout)
{
    const Picture by_mask = shown(people_, options_for(sun, -1)), by_stencil = shown(people_, options_for(sun, 3));
    EXPECT_GT(darkened(by_stencil), 1500u);
    // GL rounds corners to a part of a pixel, and the mask does not: one pixel in llvmpipe, none in softpipe.
    EXPECT_LE(differing(by_mask, by_stencil), 2u);
    EXPECT_GT(differing(by_mask, shown(people_, options_for(lamp, 3))), 200u);
}

TEST_F(Shadows, FallOnThePlaneThatIsAskedFor)
{
    for (Item &item : people_) item.ground[1] = -3;
    passes::ShadowOptions options = options_for(sun, -1);
    const Picture below = shown(people_, options);
    EXPECT_EQ(darkened(below), 0u) << "the ground hides what lies under it";
    options.ground = passes::ShadowGround::plane;
    const Picture plane = shown(people_, options);
    EXPECT_GT(darkened(plane), 1500u);
    options.ground = passes::ShadowGround::host;
    static std::vector<double> asked;
    asked.clear();
    options.height = [](void *, const double *point) { return asked.push_back(point[0]), 0.0; };
    EXPECT_EQ(shown(people_, options), plane);
    EXPECT_EQ(asked.size(), people_.size());
    options.height = [](void *, const double *) { return std::nan(""); };
    EXPECT_EQ(darkened(shown(people_, options)), 0u);
}

TEST_F(Shadows, AreHiddenByWhatStandsBeforeTheGround)
{
    for (const int32_t bit : {-1, 0}) {
        const auto renderer = make_renderer_of(*posed_);
        ground_.draw(*host_, width, height);
        ground_.draw_wall(*host_);
        ASSERT_TRUE(renderer->draw_shadows(ground_.list_of(people_), options_for(sun, bit), nullptr).ok());
        const Picture picture = read();
        uint32_t on_the_wall = 0;
        for (size_t i = 0; i < picture.size(); i += 3) on_the_wall += i / 3 % width < width / 2 && picture[i] != lit;
        EXPECT_EQ(on_the_wall, 0u);
        EXPECT_GT(darkened(picture), 500u);
    }
}

TEST_F(Shadows, LeaveOutItemsWithoutVerticesAndSaySo)
{
    const auto renderer = make_renderer_of(*posed_);
    DrawList list = ground_.list_of(people_);
    passes::ShadowStats stats;
    const Picture all = shown(*renderer, list, options_for(sun, -1), &stats);
    EXPECT_EQ(stats.individuals, 3u);
    list.items[1].vertices = claque::draw::Vertices();
    const claque::base::Status status = renderer->draw_shadows(list, options_for(sun, -1), &stats);
    EXPECT_EQ(status.code, CLQ_OUT_OF_MEMORY);
    EXPECT_EQ(stats.individuals, 2u);
    people_.erase(people_.begin() + 1);
    EXPECT_NE(shown(*renderer, ground_.list_of(people_), options_for(sun, -1), &stats), all);
}

TEST_F(Shadows, FallFromActorsThatAreNotVisibleThemselves)
{
    const Picture all = shown(people_, options_for(sun, -1));
    for (Item &item : people_) item.shadow_only = true;
    passes::ShadowStats stats;
    EXPECT_EQ(shown(people_, options_for(sun, -1), &stats), all);
    EXPECT_EQ(stats.shadow_only, 3u);
}

TEST_F(Shadows, OfPackedVerticesAreThoseOfFloats)
{
    const float step = 1.0f / 8192, offset[3] = {0.1f, 1.0f, -0.05f};
    std::vector<int16_t> positions;
    for (size_t i = 0; i < posed_->positions.size(); ++i) {
        positions.push_back(static_cast<int16_t>(std::lround((posed_->positions[i] - offset[i % 3]) / step)));
        if (i % 3 == 2) positions.push_back(0);
    }
    const std::vector<int8_t> normals(positions.size(), 0);
    for (const int32_t bit : {-1, 0}) {
        const Picture floats = shown(people_, options_for(sun, bit));
        std::vector<Item> packed = people_;
        for (Item &item : packed) {
            item.vertices = claque::draw::Vertices();
            item.vertices.short_positions = positions.data();
            item.vertices.byte_normals = normals.data();
            item.vertices.step = step;
            std::copy_n(offset, 3, item.vertices.offset);
        }
        // Half a step of 1 / 8192 m is a hundredth of a pixel: one pixel in llvmpipe, none in softpipe.
        EXPECT_LE(differing(shown(packed, options_for(sun, bit)), floats), 2u);
    }
}

TEST_F(Shadows, OfPartsOnGlsMatrixStackAreThoseOfMovedVertices)
{
    const Jointed puppet = make_jointed(gltest::puppet(), torture_map(64, 4, 4), 0.3f);
    const auto renderer = make_renderer_of(puppet.posed);
    const float size = 0.8f / puppet.posed.radius;
    Item item = ground_.stand(puppet.posed, {0.3, 0.9, 0}, 0.5f, size);
    item.ground[1] = 0;
    for (const float blob_from : {0.0f, 1e9f}) {
        passes::ShadowOptions options = options_for(sun, -1);
        options.blob_from_m = blob_from;
        const Picture moved = shown(*renderer, ground_.list_of({item}), options);
        EXPECT_GT(darkened(moved), 150u);
        EXPECT_EQ(wrong_shades(moved), 0u);
        Item by_stack = item;
        by_stack.vertices = claque::draw::Vertices();
        by_stack.locals = puppet.locals.data();
        const Picture stacked = shown(*renderer, ground_.list_of({by_stack}), options);
        // An ellipse is found from 32 vertices: every so many of all in one case, and of the corners of triangles in
        // the other. Two samples of a body give ellipses that differ along their edge: 11.7 %. Meshes are the same.
        const bool is_ellipse = blob_from == 0;
        EXPECT_LE(differing(stacked, moved) * 100, is_ellipse ? 14 * darkened(moved) : 0);
    }
}

// An ellipse has another shape, but it lies where the individual's shadow does and is about as large.
TEST_F(Shadows, FromAfarAreEllipsesInTheirPlace)
{
    const Picture mesh = shown({people_[0]}, options_for(sun, -1));
    passes::ShadowOptions options = options_for(sun, -1);
    options.blob_from_m = 2;
    passes::ShadowStats stats;
    const Picture blob = shown({people_[0]}, options, &stats);
    EXPECT_EQ(stats.blobs, 1u);
    EXPECT_LE(stats.vertices, 64u);
    uint32_t both = 0;
    for (size_t i = 0; i < mesh.size(); i += 3) both += mesh[i] < lit && blob[i] < lit;
    // An ellipse has no arms and legs: it holds 81 % of the mesh's shadow, and is 1.17 times as large.
    EXPECT_GT(both * 100, darkened(mesh) * 78);
    EXPECT_LT(darkened(blob) * 100, darkened(mesh) * 125);
    EXPECT_EQ(wrong_shades(shown(people_, options)), 0u);
    options.none_from_m = 2;
    EXPECT_EQ(darkened(shown(people_, options)), 0u);
}

// The lamp is below a head, or the eye is below the ground: nothing is drawn, and there is no error.
TEST_F(Shadows, FallNowhereFromALightOrAnEyeThatIsTooLow)
{
    EXPECT_EQ(darkened(shown(people_, options_for({0.3, 1.2, 0, 1}, -1))), 0u);
    for (Item &item : people_) item.ground[1] = 5;
    EXPECT_EQ(darkened(shown(people_, options_for(sun, -1))), 0u);
}

// A shadow at the eye's own feet reaches behind the eye.
TEST_F(Shadows, ContinueBehindTheEye)
{
    const Ground low({0, 0.25, 2}, {0, 0.3, 0}, 320.0f / 240.0f);
    std::vector<Item> people = {low.stand(*posed_, {0, 0, 0}, 0), low.stand(*posed_, {0, 0, 2.1}, 0)};
    const glm::dvec4 behind(0.05, 0.5, -1, 0);
    const std::vector<bool> expected = low.shaded(people, behind, width, height);
    for (const int32_t bit : {-1, 0}) {
        const auto renderer = make_renderer_of(*posed_);
        low.draw(*host_, width, height);
        ASSERT_TRUE(renderer->draw_shadows(low.list_of(people), options_for(behind, bit), nullptr).ok());
        const Picture picture = read();
        uint32_t wrong = 0;
        for (size_t i = 0; i < expected.size(); ++i)
            if (picture[3 * i] != 0) wrong += expected[i] != (picture[3 * i] < lit);
        EXPECT_GT(darkened(picture), 5000u);
        EXPECT_LE(wrong * 60, darkened(picture)) << bit;  // edges: 1.6 %
    }
}

}  // namespace
}  // namespace gltest
