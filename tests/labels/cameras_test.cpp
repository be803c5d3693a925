// Cameras and boxes: what they say of the world is where the picture shows it, by formulas of this file alone.
#include <cmath>

#include "samples/labels/collections.h"
#include "samples/labels/projection.h"
#include "tests/labels/labelled.h"

namespace
{

using labels::Json;
using Vector = std::array<double, 3>;

Vector vector_of(const Json &json) { return {json[0], json[1], json[2]}; }

// v turned by a quaternion, through its matrix.
Vector turned(const Json &q, const Vector &v, bool back = false)
{
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    Vector out = {0, 0, 0};
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c) out[r] += (back ? m[c][r] : m[r][c]) * v[c];
    return out;
}

Vector minus(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// A point of the world in the picture, as the page on labels says.
std::array<double, 2> pixel_of(const Json &camera, const Vector &world)
{
    const Vector eye = turned(camera["rotation_xyzw"], minus(world, vector_of(camera["eye"])));
    return {camera["cx"].get<double>() + camera["fx"].get<double>() * eye[0] / -eye[2],
            camera["cy"].get<double>() - camera["fy"].get<double>() * eye[1] / -eye[2]};
}

class CamerasOfLabels : public labels_test::Labelled
{
protected:
    void SetUp() override
    {
        Labelled::SetUp();
        if (IsSkipped()) return;
        open("plaza", 60, 200, 120);
        sample_ = labeller_->label(3, 0.5);
        take();
    }
    void take()
    {
        const std::set<std::string> formats = {"boxes3d", "heads"};
        for (const labels::FrameFile &file :
             labels::collections({labels::frame_json(sample_)}, formats, labels::coco_keypoints()))
            all_[file.path] = Json::parse(file.bytes);
    }

    labels::Sample sample_;
    std::map<std::string, Json> all_;
};

TEST_F(CamerasOfLabels, ProjectHeadsToTheirPixels)
{
    const Json &frame = all_.at("cameras.json")[0], &people = all_.at("heads.json")[0]["people"];
    EXPECT_EQ(frame["frame"], 3);
    EXPECT_EQ(frame["time_s"], 0.5);
    EXPECT_EQ(frame["width"], 200);
    EXPECT_EQ(frame["height"], 120);
    size_t tested = 0;
    for (const Json &person : people) {
        if (person["head"]["seen"] == "absent" || person["head"]["seen"] == "outside") continue;
        const auto px = pixel_of(frame["camera"], vector_of(person["head"]["world"]));
        EXPECT_NEAR(px[0], person["head"]["px"][0].get<double>(), 1e-4);
        EXPECT_NEAR(px[1], person["head"]["px"][1].get<double>(), 1e-4);
        ++tested;
    }
    EXPECT_GT(tested, 20u);
}

TEST_F(CamerasOfLabels, HaveTheCentreOfACroppedView)
{
    sample_.camera.projection[8] = 0.3f, sample_.camera.projection[9] = -0.2f;
    take();
    const Json &camera = all_.at("cameras.json")[0]["camera"];
    size_t tested = 0;
    for (const labels::Person &person : sample_.people) {
        std::array<double, 2> expected;
        double depth_m = 0;
        if (!labels::project(sample_, person.centre, expected, depth_m)) continue;
        const auto px = pixel_of(camera, person.centre);
        EXPECT_NEAR(px[0], expected[0], 1e-3);
        EXPECT_NEAR(px[1], expected[1], 1e-3);
        ++tested;
    }
    EXPECT_GT(tested, 20u);
}

// A point along the axes of a box, in halves of its size: beyond 1 it lies outside.
Vector in_box(const Json &box, const Vector &world)
{
    Vector out = turned(box["rotation_xyzw"], minus(world, vector_of(box["centre"])), true);
    for (size_t k = 0; k < 3; ++k) out[k] /= box["size_m"][k].get<double>() / 2;
    return out;
}

TEST_F(CamerasOfLabels, HaveBoxesWithAllPixelsOfTheirPerson)
{
    std::map<uint32_t, Json> boxes;
    for (const Json &person : all_.at("boxes3d.json")[0]["people"])
        boxes[person["id"].get<uint32_t>()] = person["box3d"];
    size_t tested = 0;
    for (size_t i = 0; i < sample_.actor.size(); ++i) {
        if (sample_.actor[i] == 0) continue;
        const Vector at = in_box(boxes.at(sample_.actor[i]),
                                 {sample_.position[3 * i], sample_.position[3 * i + 1], sample_.position[3 * i + 2]});
        for (const double one : at) ASSERT_LT(std::abs(one), 1.001) << "pixel " << i;
        ++tested;
    }
    EXPECT_GT(tested, 500u);
}

TEST_F(CamerasOfLabels, HaveBoxesThatTouchTheirPersonOnEachSide)
{
    std::map<uint32_t, Json> boxes;
    for (const Json &person : all_.at("boxes3d.json")[0]["people"])
        boxes[person["id"].get<uint32_t>()] = person["box3d"];
    clq_view_stats stats = clq_view_stats_init();
    scenes::check(clq_view_get_stats(scene_->view(), &stats));
    ASSERT_GT(stats.visible, 20u);
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor drawn = clq_drawn_actor_init();
        scenes::check(clq_view_get_drawn_actor(scene_->view(), i, &drawn));
        std::vector<float> xyz(3 * static_cast<size_t>(drawn.vertex_count));
        scenes::check(clq_view_get_vertices(scene_->view(), i, xyz.data(), nullptr, drawn.vertex_count));
        Vector low = {9, 9, 9}, high = {-9, -9, -9};
        for (size_t v = 0; v < drawn.vertex_count; ++v) {
            Vector eye;
            for (size_t r = 0; r < 3; ++r) {
                eye[r] = static_cast<double>(drawn.model_view[12 + r]);
                for (size_t c = 0; c < 3; ++c)
                    eye[r] += static_cast<double>(drawn.model_view[4 * c + r]) * static_cast<double>(xyz[3 * v + c]);
            }
            const Vector at = in_box(boxes.at(drawn.actor.index1), labels::from_eye(sample_.camera, eye));
            for (size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
        }
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(low[k], -1, 1e-3);
            EXPECT_NEAR(high[k], 1, 1e-3);
        }
    }
}

}  // namespace
