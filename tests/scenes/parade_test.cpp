// Rows of one character: whatever its proportions and wherever its file has it, it stands on the ground, and the camera
// above it has all of it in the picture.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "samples/scenes/library.h"
#include "samples/scenes/scene_renderer.h"
#include "tests/gl/support/absent.h"

namespace
{

using namespace scenes;

// The corners of a box, each in a triangle. Each clip lasts a second, and moves it up, sideways and back; one named
// "travel" leads it 4 m sideways.
Own<clq_template> box(Library &library, float low, float wide, float high, float deep,
                      const std::vector<const char *> &clips = {})
{
    float corners[8][3];
    uint32_t indices[8][3];
    for (uint32_t k = 0; k < 8; ++k) {
        corners[k][0] = k & 1 ? wide / 2 : -wide / 2;
        corners[k][1] = k & 2 ? low + high : low;
        corners[k][2] = k & 4 ? deep / 2 : -deep / 2;
        for (uint32_t j = 0; j < 3; ++j) indices[k][j] = (k + j * (j + 1) / 2) % 8;
    }
    clq_node_def node = clq_node_def_init();
    node.name = "box";
    clq_part_def part = clq_part_def_init();
    part.vertex_count = 8, part.positions = &corners[0][0], part.index_count = 24, part.indices = &indices[0][0];
    const float times[3] = {0, 0.5f, 1}, values[9] = {0, 0, 0, 0.8f * high, 0.7f * high, 0.3f * high, 0, 0, 0};
    clq_channel_def channel = clq_channel_def_init();
    channel.key_count = 3, channel.times_s = times, channel.values = values;
    const float way[9] = {0, 0, 0, 2, 0, 0, 4, 0, 0};
    clq_channel_def travel = channel;
    travel.values = way;
    std::vector<clq_clip_def> jumps(clips.size());
    for (size_t i = 0; i < clips.size(); ++i)
        jumps[i].name = clips[i], jumps[i].channel_count = 1,
        jumps[i].channels = std::string(clips[i]) == "travel" ? &travel : &channel;
    clq_template_def def = clq_template_def_init();
    def.name = "box", def.node_count = 1, def.nodes = &node, def.part_count = 1, def.parts = &part;
    def.clip_count = static_cast<uint32_t>(jumps.size()), def.clips = jumps.data();
    clq_template *made = nullptr;
    check(clq_template_build(library.context(), &def, &made));
    return Own<clq_template>(made);
}

Character shown(const Own<clq_template> &tmpl)
{
    Character character;
    character.tmpl = tmpl.get();
    return character;
}

TEST(Parade, IsSeenFromAboveTheGroundWhateverTheCharactersProportions)
{
    Library library(1);
    CrowdOptions options;
    for (const float low : {-1000.0f, -3.0f, 0.0f, 50.0f})
        for (const float wide : {0.01f, 0.5f, 1.8f})
            for (const float high : {0.001f, 0.2f, 1.8f})
                for (const float deep : {0.01f, 0.5f, 1.8f}) {
                    const Own<clq_template> tmpl = box(library, low, wide, high, deep);
                    for (const uint32_t count : {1u, 3u, 12u}) {
                        options.count = count;
                        const auto scene = make_parade(library, options, shown(tmpl));
                        for (const Shot shot : {Shot::overview, Shot::close})
                            for (const double aspect : {0.5, 1.5, 3.0})
                                EXPECT_GT(scene->camera(shot, aspect, 0).eye[1], 0)
                                    << count << " of " << wide << " x " << high << " x " << deep << " from " << low;
                    }
                }
}

TEST(Parade, HasAllOfItsPeopleInThePictureAtAllTimesOfTheirClips)
{
    Library library(1);
    const Own<clq_template> tmpl = box(library, 0, 0.5f, 1.8f, 0.3f, {"jump"});
    for (const uint32_t count : {1u, 2u, 12u}) {
        CrowdOptions options;
        options.count = count, options.exact_poses = true;
        Character character = shown(tmpl);
        character.one_clip = count == 1;
        const auto scene = make_parade(library, options, character);
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(scene->crowd(), scene->actors()[0], &info), CLQ_OK) << clq_last_error();
        EXPECT_NEAR(info.transform.position[1], 0, 1e-6) << "it stands on the ground where it does not jump";
        clq_view *made = nullptr;
        check(clq_view_create(scene->crowd(), &made));
        const Own<clq_view> view(made);
        const clq_camera camera = scene->camera(Shot::overview, 4.0 / 3, 0);
        check(clq_view_set_camera(made, &camera));
        for (const double time_s : {0.0, 0.13, 0.25, 0.37, 0.5, 0.75}) {
            check(clq_crowd_update(scene->crowd(), time_s, &made, 1));
            for (uint32_t i = 0; i < count; ++i) {
                clq_drawn_actor drawn = clq_drawn_actor_init();
                ASSERT_EQ(clq_view_get_drawn_actor(made, i, &drawn), CLQ_OK) << clq_last_error();
                std::vector<float> xyz(3 * size_t(drawn.vertex_count));
                ASSERT_EQ(clq_view_get_vertices(made, i, xyz.data(), nullptr, drawn.vertex_count), CLQ_OK);
                for (size_t v = 0; v < xyz.size(); v += 3) {
                    const auto eye = [&](size_t axis) {
                        const float *m = drawn.model_view + axis;
                        return double(m[0] * xyz[v] + m[4] * xyz[v + 1] + m[8] * xyz[v + 2] + m[12]);
                    };
                    EXPECT_LE(std::abs(eye(0) * double(camera.projection[0])), -eye(2)) << count << " at " << time_s;
                    EXPECT_LE(std::abs(eye(1) * double(camera.projection[5])), -eye(2)) << count << " at " << time_s;
                }
            }
        }
    }
}

// The brightness of the picture where it shows a point of the world.
double brightness_at(SceneRenderer &renderer, const clq_camera &camera, Vec3 point, double time_s, int width,
                     int height)
{
    const Eye eye = eye_of(camera);
    const float at[3] = {point.x, point.y, point.z};
    double seen[3], depth = 0;
    for (size_t row = 0; row < 3; ++row) {
        seen[row] = double(eye.view[12 + row]);
        for (size_t k = 0; k < 3; ++k) seen[row] += double(eye.view[4 * k + row] * at[k]);
    }
    depth = -seen[2];
    const double x = (double(eye.projection[0]) * seen[0] / depth + 1) / 2 * width;
    const double y = (1 - double(eye.projection[5]) * seen[1] / depth) / 2 * height;
    EXPECT_TRUE(x > 0 && x < width && y > 0 && y < height) << x << ", " << y;
    const uint8_t *pixel = &renderer.picture(time_s)[3 * (size_t(y) * size_t(width) + size_t(x))];
    return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

TEST(Parade, HasShadowsUnderPeopleWhomAClipLeadsAway)
{
    const std::string absent = gltest::absent_gl(contexts::Kind::any);
    if (!absent.empty()) GTEST_SKIP() << absent;
    Library library(1);
    const Own<clq_template> tmpl = box(library, 0, 0.5f, 1.75f, 0.3f, {"travel"});
    SceneOptions options;
    options.make = [&](Library &of, const CrowdOptions &crowd) {
        Character character = shown(tmpl);
        character.one_clip = true;
        return make_parade(of, crowd, character);
    };
    options.crowd_options.count = 1;
    options.width = 320, options.height = 240;
    SceneRenderer renderer(library, options);
    const clq_camera camera = renderer.scene().camera(Shot::overview, 4.0 / 3, 0);
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(renderer.scene().crowd(), renderer.scene().actors()[0], &info));
    const float begin_x = static_cast<float>(info.transform.position[0]);
    for (const float time_s : {0.0f, 0.25f, 0.6f, 0.9f}) {
        const auto ground = [&](float x) {
            return brightness_at(renderer, camera, {begin_x + x + 0.3f, 0, 0}, time_s, 320, 240);
        };
        const double open = ground(time_s > 0.5f ? 1.0f : 3.0f);
        EXPECT_LT(ground(4 * time_s), 0.85 * open) << "under it, at " << time_s << " s";
        EXPECT_NEAR(ground(time_s > 0.5f ? 0.0f : 4.0f), open, 3) << "where it is not, at " << time_s << " s";
    }
}

// Files with their clips in the order of the alphabet begin with "Death".
TEST(Parade, BeginsWithAClipThatIsNamedForStanding)
{
    Library library(1);
    CrowdOptions options;
    options.count = 4;
    const auto order = [&](const std::vector<const char *> &clips, uint32_t first, bool one = false) {
        const Own<clq_template> tmpl = box(library, 0, 0.5f, 1.8f, 0.3f, clips);
        Character character = shown(tmpl);
        character.first_clip = first, character.one_clip = one;
        const auto scene = make_parade(library, options, character);
        std::vector<uint32_t> found;
        for (const clq_actor actor : scene->actors()) {
            clq_active_clip playing[CLQ_ACTIVE_CLIP_MAX];
            uint32_t count = 0;
            check(clq_actor_get_active_clips(scene->crowd(), actor, 0, playing, &count));
            found.push_back(count == 1 ? playing[0].clip : CLQ_NONE);
        }
        return found;
    };
    EXPECT_EQ(order({"Death", "Armature|Idle_Loop", "Walk"}, 0), (std::vector<uint32_t>{1, 2, 0, 1}));
    EXPECT_EQ(order({"Death", "STANDING", "idle"}, 0), (std::vector<uint32_t>{2, 0, 1, 2}));
    EXPECT_EQ(order({"Death", "Walk"}, 0), (std::vector<uint32_t>{0, 1, 0, 1}));
    EXPECT_EQ(order({"Death", "Idle", "Walk", "Run"}, 2), (std::vector<uint32_t>{2, 3, 2, 3}))
        << "clips that were added";
    EXPECT_EQ(order({"Death", "Idle", "Walk", "Run"}, 2, true), (std::vector<uint32_t>{2, 2, 2, 2}));
}

TEST(Parade, StandsOnTheGroundHoweverFarBelowItTheFileHasTheCharacter)
{
    Library library(1);
    CrowdOptions options;
    options.count = 5;
    for (const float low : {-1000.0f, -3.0f, 50.0f}) {
        const Own<clq_template> tmpl = box(library, low, 0.5f, 1.0f, 0.25f);
        const auto scene = make_parade(library, options, shown(tmpl));
        for (const clq_actor actor : scene->actors()) {
            clq_actor_info info = clq_actor_info_init();
            ASSERT_EQ(clq_actor_get_info(scene->crowd(), actor, &info), CLQ_OK) << clq_last_error();
            EXPECT_NEAR(info.transform.position[1] + double(info.transform.scale * low), 0, 1e-3) << low;
        }
    }
}

}  // namespace
