// Cameras that are chosen among people: where the rules say, and with the person in their picture.
#include "samples/labels/variation/standpoint.h"

#include <cmath>

#include "samples/labels/projection.h"
#include "tests/labels/labelled.h"

namespace
{

using labels::CameraRules;
using labels::Head;

class Standpoints : public labels_test::Labelled
{
protected:
    void SetUp() override
    {
        Labelled::SetUp();
        if (IsSkipped()) return;
        open("plaza", 80, 160, 120);
        scene_->place(1);
        labels::Skeletons skeletons(*library_, labels::coco_keypoints());
        heads_ = labels::heads_of(skeletons, scene_->scene(), 1);
        choice_.seed = 4, choice_.sample = 2;
    }
    // Where a point is in the picture of a standpoint, both in [0, 1].
    static std::array<double, 2> in_picture(const clq_camera &camera, const std::array<double, 3> &point)
    {
        labels::Sample picture;
        picture.width = picture.height = 1, picture.camera = camera;
        std::array<double, 2> px = {-1, -1};
        double depth_m = 0;
        labels::project(picture, point, px, depth_m);
        return px;
    }

    std::vector<Head> heads_;
    labels::Choice choice_;
};

TEST_F(Standpoints, KnowWhereHeadsAreAndWhereTheirPeopleStand)
{
    ASSERT_EQ(heads_.size(), 80u);
    const labels::Sample sample = labeller_->label(0, 1);
    ASSERT_GT(sample.people.size(), 20u);
    for (const labels::Person &person : sample.people) {
        const auto head =
            std::find_if(heads_.begin(), heads_.end(), [&](const Head &one) { return one.actor == person.actor; });
        ASSERT_NE(head, heads_.end());
        for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(head->at[k], person.head.world[k], 1e-9);
        // The lowest point of the person, but for a foot that is lifted.
        EXPECT_NEAR(head->ground_m, person.centre[1] - person.size_m[1] / 2, 0.1);
    }
}

TEST_F(Standpoints, LookAtTheirPersonFromWhereTheRulesSay)
{
    CameraRules rules;
    rules.height_m = {1, 4}, rules.distance_m = {3, 6}, rules.fov_deg = {40, 60};
    size_t found = 0;
    std::string why_not;
    for (uint32_t attempt = 0; attempt < 300; ++attempt) {
        const auto one = labels::stand(rules, heads_, choice_, attempt, 4.0 / 3, why_not);
        if (!one) continue;
        ++found;
        const double *eye = one->camera.eye;
        const std::array<double, 3> &head = one->person.at;
        const double level_m = std::hypot(eye[0] - head[0], eye[2] - head[2]);
        EXPECT_NEAR(level_m, one->distance_m, 1e-9);
        EXPECT_GE(level_m, 3);
        EXPECT_LE(level_m, 6);
        EXPECT_GE(eye[1] - one->person.ground_m, 1);
        EXPECT_LE(eye[1] - one->person.ground_m, 4);
        const auto px = in_picture(one->camera, head);
        EXPECT_NEAR(px[0], 0.5, 1e-4);
        EXPECT_NEAR(px[1], 0.5, 1e-4);
        for (const Head &other : heads_)
            EXPECT_GE(std::hypot(std::hypot(eye[0] - other.at[0], eye[1] - other.at[1]), eye[2] - other.at[2]), 0.5);
        EXPECT_NEAR(2 * std::atan(1 / static_cast<double>(one->camera.projection[5])) * 180 / 3.141592653589793,
                    one->fov_deg, 1e-3);
    }
    EXPECT_GT(found, 150u);
}

TEST_F(Standpoints, KeepThePitchOfARuleAndTheHeadInThePicture)
{
    CameraRules rules;
    rules.pitch_deg = {{-40, 10}};
    size_t found = 0;
    std::string why_not;
    for (uint32_t attempt = 0; attempt < 300; ++attempt) {
        const auto one = labels::stand(rules, heads_, choice_, attempt, 1, why_not);
        if (!one) continue;
        ++found;
        // The middle of the picture looks along the pitch.
        const std::array<double, 3> ahead = labels::from_eye(one->camera, {0, 0, -1});
        EXPECT_NEAR(ahead[1] - one->camera.eye[1], std::sin(*one->pitch_deg * 3.141592653589793 / 180), 1e-5);
        const auto px = in_picture(one->camera, one->person.at);
        EXPECT_GE(px[1], 0);
        EXPECT_LT(px[1], 1);
    }
    EXPECT_GT(found, 50u);
    EXPECT_LT(found, 290u);
}

TEST_F(Standpoints, AreRefusedWhereAFaceIsTooNear)
{
    CameraRules rules;
    rules.faces_m = 500;
    std::string why_not;
    for (uint32_t attempt = 0; attempt < 20; ++attempt)
        EXPECT_FALSE(labels::stand(rules, heads_, choice_, attempt, 1, why_not));
    EXPECT_EQ(why_not, "a face is nearer than 500 m");
}

TEST_F(Standpoints, SeeTheirPersonUnlessSceneryIsBetween)
{
    labels::Standpoint from;
    from.person.at = {0, 1.6, 0};
    const auto free_to = [&](double x, double y, double z) {
        const double eye[3] = {x, y, z};
        from.camera = scenes::look(eye, {0, 1.6, 0}, 50, 1, 0.1, 100);
        return labels::has_free_sight(*scene_, from, 1);
    };
    EXPECT_TRUE(free_to(0.5, 6, 3));
    EXPECT_FALSE(free_to(0.5, -1, 3));     // below the ground
    EXPECT_FALSE(free_to(0.5, 0.05, 3));   // nearly on it
    EXPECT_FALSE(free_to(0.5, 1.6, -80));  // behind the buildings
}

}  // namespace
