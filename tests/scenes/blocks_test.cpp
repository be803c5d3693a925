// Scenery in blocks: a picture does not show what was left out of it, each triangle belongs to one block, the nearest
// block comes first, and the far form has the colours of the near one.
#include "samples/scenes/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "samples/contexts/offscreen.h"
#include "samples/scenes/camera_path.h"
#include "samples/scenes/library.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/scene_renderer.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/stone.h"
#include "tests/gl/support/absent.h"

namespace
{

using namespace scenes;

constexpr int wide = 160, high = 120;

// A context of its own with an empty picture.
struct Canvas {
    std::unique_ptr<contexts::Offscreen> offscreen;
    Gl g;
    std::vector<uint8_t> rgb;

    Canvas()
    {
        std::string why_not;
        offscreen = contexts::make_offscreen(contexts::Kind::any, wide, high, contexts::PixelFormat::rgba8888, why_not);
        if (!offscreen || !load(g, offscreen->get_proc_address(), offscreen->user(), why_not)) throw Failure(why_not);
        g.Viewport(0, 0, wide, high);
    }
    template <class Draw>
    const std::vector<uint8_t> &picture(Draw draw)
    {
        g.DepthMask(1);
        g.ClearColor(0, 0, 0, 1);
        g.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
        draw();
        offscreen->read_rgb(rgb);
        return rgb;
    }
    std::array<int, 3> pixel(int x, int y) const
    {
        const size_t at = 3 * size_t(y * wide + x);
        return {rgb[at], rgb[at + 1], rgb[at + 2]};
    }
};

#define NEEDS_GL() \
    if (const std::string absent = gltest::absent_gl(contexts::Kind::any); !absent.empty()) GTEST_SKIP() << absent

Eye seen_from(double x, double y, double z, double to_x, double to_y, double to_z)
{
    return eye_of(look({x, y, z}, {to_x, to_y, to_z}, 50, double(wide) / high, 0.5, 900));
}

std::vector<Eye> eyes_in(const std::string &scene)
{
    std::vector<Eye> eyes;
    for (int turn = 0; turn < 8; ++turn) {
        const double s = std::sin(turn * 0.785 + 0.1), c = std::cos(turn * 0.785 + 0.1);
        eyes.push_back(seen_from(3 * s, 2.5, 3 * c, -20 * s, 1, -20 * c));
        eyes.push_back(seen_from(45 * s, 30, 45 * c, 8 * c, 0, 8 * s));
    }
    if (const std::string *text = recorded_path(scene)) {
        const CameraPath path(*text, scene);
        for (double t = path.start_s(); t < path.start_s() + 50; t += 4.5)
            eyes.push_back(eye_of(path.camera(t, double(wide) / high)));
    }
    return eyes;
}

void expect_culling_does_not_show(const std::string &name)
{
    Library library(1);
    Canvas canvas;
    CrowdOptions few;
    few.count = 3;
    const std::unique_ptr<Scene> scene = make_scene(name, library, few, {});
    scene->prepare(canvas.g);
    for (const Eye &eye : eyes_in(name)) {
        scene->cull_by(1);
        const auto surroundings = [&] {
            scene->set_light(canvas.g, eye);
            scene->draw_environment(canvas.g, eye);
        };
        const std::vector<uint8_t> culled = canvas.picture(surroundings);
        scene->cull_by(1e6);
        ASSERT_EQ(culled, canvas.picture(surroundings))
            << name << " from " << eye.position[0] << ' ' << eye.position[1] << ' ' << eye.position[2];
    }
}

// A row of boxes along x, each a part; every second one has a coarse form.
Parts boxes()
{
    Parts parts;
    for (int i = 0; i < 20; ++i) {
        const float x = 3 * static_cast<float>(i);
        parts.fine.box({x, 0, 0}, {x + 1, 1, 1}, {1, 1, 1});
        if (i % 2 == 0) parts.coarse.quad({Vec3{x, 0, 1}, {x + 1, 0, 1}, {x + 1, 1, 1}, {x, 1, 1}}, {1, 1, 1});
        parts.end();
    }
    return parts;
}

// The middles of triangles, sorted.
std::vector<std::array<float, 3>> middles(const Geometry &g, const std::vector<uint32_t> &indices)
{
    std::vector<std::array<float, 3>> found;
    for (size_t i = 0; i < indices.size(); i += 3) {
        std::array<float, 3> sum = {0, 0, 0};
        for (size_t k = 0; k < 3; ++k) {
            const Vec3 p = g.vertices()[indices[i + k]].position;
            sum[0] += p.x, sum[1] += p.y, sum[2] += p.z;
        }
        found.push_back(sum);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

TEST(Blocks, APictureOfTheOdeonDoesNotShowWhatWasCulled)
{
    NEEDS_GL();
    expect_culling_does_not_show("odeon");
}

TEST(Blocks, APictureOfThePlazaDoesNotShowWhatWasCulled)
{
    NEEDS_GL();
    expect_culling_does_not_show("plaza");
}

TEST(Blocks, AreEveryTriangleOnce)
{
    const Parts parts = boxes();
    const Blocks whole(parts.fine, 4);
    EXPECT_GT(whole.all().size(), 10u);
    EXPECT_EQ(middles(whole.fine(), whole.fine().indices()), middles(parts.fine, parts.fine.indices()));
    const Blocks in_parts(parts, 4, {1000, {}, {1, 1, 1}});
    EXPECT_EQ(middles(in_parts.fine(), in_parts.fine().indices()), middles(parts.fine, parts.fine.indices()));
    EXPECT_EQ(middles(in_parts.coarse(), in_parts.coarse().indices()), middles(parts.coarse, parts.coarse.indices()));
    Blocks::Choice choice;
    whole.choose(nullptr, {0, 0, 0}, choice);
    EXPECT_EQ(middles(whole.fine(), choice.fine), middles(parts.fine, parts.fine.indices()));
}

TEST(Blocks, TheNearestComesFirst)
{
    const Parts parts = boxes();
    const Blocks blocks(parts.fine, 4);
    Blocks::Choice choice;
    for (const double from : {-10.0, 70.0}) {
        blocks.choose(nullptr, {from, 0, 0}, choice);
        double before = 0;
        for (const uint32_t i : choice.fine) {
            const double away = std::abs(double(blocks.fine().vertices()[i].position.x) - from);
            EXPECT_GT(away, before - 5);
            before = std::max(before, away);
        }
    }
}

TEST(Blocks, BeyondADistanceEachHasItsCoarseFormIfThereIsOne)
{
    const Parts parts = boxes();
    const Blocks blocks(parts, 1, {20, {}, {1, 1, 1}});
    Blocks::Choice choice;
    blocks.choose(nullptr, {0, 0.5, 0.5}, choice);
    // Seven boxes begin before 20 m; of the thirteen behind them six or seven have a coarse form of two triangles.
    const size_t box = parts.all()[0].fine.count;
    EXPECT_EQ(choice.fine.size(), (7 + 7) * box);
    EXPECT_EQ(choice.coarse.size(), 6 * size_t(6));
    blocks.choose(nullptr, {0, 0.5, 1000}, choice);
    EXPECT_EQ(choice.fine.size(), 10 * box);
    EXPECT_EQ(choice.coarse.size(), 10 * size_t(6));
    blocks.choose(nullptr, {30, 0.5, 0.5}, choice);
    EXPECT_GT(choice.fine.size(), 10 * box);
}

TEST(Blocks, AFarFormHasTheColoursThatLightsGiveANearOne)
{
    NEEDS_GL();
    Canvas canvas;
    const Daylight light;
    const Eye eye = seen_from(0, 0, 5, 0, 0, 0);
    for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0.6f, 0, 0.8f}, Vec3{-0.6f, 0.48f, 0.64f}}) {
        Geometry wall;
        const Rgb colour = {0.9f, 0.6f, 0.3f};
        for (const auto &[x, y] : {std::pair(-9.f, -9.f), {9.f, -9.f}, {9.f, 9.f}, {-9.f, 9.f}})
            wall.add({x, y, 0}, normal, 0, 0, colour);
        wall.triangle(0, 1, 2), wall.triangle(0, 2, 3);
        canvas.picture([&] { set_lights(canvas.g, light, eye), wall.draw(canvas.g); });
        const std::array<int, 3> lit = canvas.pixel(wide / 2, high / 2);
        SceneryVertex vertex = wall.vertices()[0];
        shine(light, vertex, {1, 1, 1});
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(vertex.rgba[k], lit[k], 1) << normal.x << ' ' << normal.y << ' ' << k;
    }
}

TEST(Blocks, AFarFormHasTheMeanOfItsTexture)
{
    const Image image = plaster(1);
    double sum[3] = {0, 0, 0};
    for (size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 < 3) sum[i % 4] += image.rgba[i] / 255.0 / (double(image.side_px) * image.side_px);
    EXPECT_NEAR(sum[0], double(plaster_mean.r), 0.012);
    EXPECT_NEAR(sum[1], double(plaster_mean.g), 0.012);
    EXPECT_NEAR(sum[2], double(plaster_mean.b), 0.012);
}

TEST(Sky, FillsOnlyWhatIsEmpty)
{
    NEEDS_GL();
    Canvas canvas;
    const Eye eye = seen_from(0, 30, 0, 0, 30, -1);
    Geometry wall;  // 400 m away, farther than the sky's own triangles
    wall.quad({Vec3{-60, 0, -400}, {60, 0, -400}, {60, 60, -400}, {-60, 60, -400}}, {1, 0, 0});
    const Sky sky(1, Sky::Land::hills);
    const auto draw = [&] {
        set_lights(canvas.g, Daylight(), eye);
        canvas.g.Disable(gl::lighting);
        wall.draw(canvas.g);
        sky.draw(canvas.g, eye);
    };
    canvas.picture(draw);
    EXPECT_EQ(canvas.pixel(wide / 2, high / 2), (std::array<int, 3>{255, 0, 0}));
    EXPECT_GT(canvas.pixel(3, 3)[2], 100);
    // It takes no depth: what is drawn later is before it.
    canvas.picture([&] {
        draw();
        canvas.g.Disable(gl::lighting);
        Geometry behind;
        behind.quad({Vec3{-800, -900, -800}, {800, -900, -800}, {800, 900, -800}, {-800, 900, -800}}, {0, 1, 0});
        behind.draw(canvas.g);
    });
    EXPECT_EQ(canvas.pixel(3, 3), (std::array<int, 3>{0, 255, 0}));
    EXPECT_EQ(canvas.pixel(wide / 2, high / 2), (std::array<int, 3>{255, 0, 0}));
}
