// Labelled scenes: labels agree with the picture, with each other, and with every number of threads.
#include <cmath>

#include "tests/labels/labelled.h"

namespace
{

using labels::Person;
using labels::Sample;
using labels::Seen;

class LabelsOfAScene : public labels_test::Labelled
{
};

TEST_F(LabelsOfAScene, CoverExactlyThePixelsThatPeopleChange)
{
    open("odeon", 300, 320, 240);
    const Sample sample = labeller_->label(3, 2);
    // The same picture without anybody: what differs is people.
    scene_->update(2);
    scene_->begin_picture();
    scene_->draw_environment();
    const std::vector<uint8_t> empty = scene_->read();
    size_t changed = 0, labelled = 0;
    for (size_t i = 0; i < sample.actor.size(); ++i) {
        const bool same = std::equal(&empty[3 * i], &empty[3 * i] + 3, &sample.rgb[3 * i]);
        if (!same) {
            ASSERT_NE(sample.actor[i], 0u) << "pixel " << i << " shows a person without a label";
            ++changed;
        }
        labelled += sample.actor[i] != 0;
    }
    // A person may have the colour of the stone behind.
    EXPECT_GT(changed, 5000u);
    EXPECT_LE(labelled - changed, labelled / 100);
}

TEST_F(LabelsOfAScene, CountPeopleAsTheirPixelsSay)
{
    open("plaza", 60, 320, 240);
    const Sample sample = labeller_->label(0, 1);
    std::map<uint32_t, size_t> pixels;
    for (const uint32_t actor : sample.actor)
        if (actor != 0) ++pixels[actor];
    size_t whole = 0, hidden = 0;
    for (const Person &person : sample.people) {
        EXPECT_EQ(person.visible_px, pixels[person.actor]);
        EXPECT_LE(person.visible_px, person.whole_px) << person.actor;
        whole += person.visible_px > 0 && person.visible_px == person.whole_px;
        hidden += person.visible_px < person.whole_px;
        if (person.visible_px == 0) continue;
        // Boxes of pixels lie in the box of the vertices, but for GL's rounding.
        EXPECT_GE(person.visible.x0, std::floor(person.whole.x0) - 1);
        EXPECT_LE(person.visible.x1, std::ceil(person.whole.x1) + 1);
        EXPECT_GE(person.visible.y0, std::floor(person.whole.y0) - 1);
        EXPECT_LE(person.visible.y1, std::ceil(person.whole.y1) + 1);
    }
    EXPECT_GT(whole, 5u);
    EXPECT_GT(hidden, 5u);
}

TEST_F(LabelsOfAScene, HaveKeypointsOnThePeopleThatTheyBelongTo)
{
    open("plaza", 20, 640, 480);
    const Sample sample = labeller_->label(0, 1);
    size_t visible = 0, hidden = 0;
    for (const Person &person : sample.people)
        for (const labels::Keypoint &point : person.keypoints) {
            ASSERT_NE(point.seen, Seen::absent);
            if (point.seen == Seen::outside) continue;
            EXPECT_GE(point.px[0], person.whole.x0 - 2);
            EXPECT_LE(point.px[0], person.whole.x1 + 2);
            EXPECT_GE(point.px[1], person.whole.y0 - 2);
            EXPECT_LE(point.px[1], person.whole.y1 + 2);
            visible += point.seen == Seen::visible, hidden += point.seen == Seen::hidden;
            if (point.seen != Seen::visible) continue;
            const size_t at = static_cast<size_t>(point.px[1]) * 640 + static_cast<size_t>(point.px[0]);
            EXPECT_EQ(sample.actor[at], person.actor);
        }
    EXPECT_GT(visible, 100u);
    EXPECT_GT(hidden, 20u);
}

TEST_F(LabelsOfAScene, HideTheFacesOfPeopleThatLookAway)
{
    open("plaza", 80, 640, 480);
    const Sample sample = labeller_->label(0, 1);
    size_t away = 0, towards = 0, seen = 0;
    for (const Person &person : sample.people) {
        if (person.head.seen != Seen::visible) continue;
        // Where +z of the person is, level as people stand, and the way to the eye.
        const auto &q = person.rotation_xyzw;
        const double x = 2 * (q[0] * q[2] + q[1] * q[3]), z = 1 - 2 * (q[0] * q[0] + q[1] * q[1]);
        const double u = sample.camera.eye[0] - person.head.world[0], w = sample.camera.eye[2] - person.head.world[2];
        const double turned = (x * u + z * w) / std::hypot(u, w);
        for (const size_t point : {size_t{0}, size_t{1}, size_t{2}}) {  // nose and eyes
            const Seen state = person.keypoints[point].seen;
            if (turned < -0.85) EXPECT_EQ(state, Seen::hidden) << person.actor << " " << point;
            if (turned > 0.8) seen += state == Seen::visible;
        }
        away += turned<-0.85, towards += turned> 0.8;
    }
    EXPECT_GT(away, 5u);
    EXPECT_GT(towards, 5u);
    EXPECT_GT(seen, 2 * towards);
}

TEST_F(LabelsOfAScene, AreTheSameForAnyNumberOfThreadsAndWhateverWasLabelledBefore)
{
    open("plaza", 40, 160, 120);
    const Sample first = labeller_->label(7, 0.7);
    const auto expect_same = [&](const Sample &other) {
        EXPECT_EQ(other.actor, first.actor);
        EXPECT_EQ(other.zone, first.zone);
        EXPECT_EQ(other.position.size(), first.position.size());
        for (size_t i = 0; i < first.position.size(); ++i)
            ASSERT_TRUE(other.position[i] == first.position[i] ||
                        (std::isnan(other.position[i]) && std::isnan(first.position[i])));
        for (size_t i = 0; i < first.forward.size(); ++i)
            ASSERT_TRUE(other.forward[i] == first.forward[i] ||
                        (std::isnan(other.forward[i]) && std::isnan(first.forward[i])));
    };
    open("plaza", 40, 160, 120, 4);
    labeller_->label(90, 9);
    expect_same(labeller_->label(7, 0.7));
}

// Forward to the next picture, backward from there: a point that is visible in both comes back to where it was.
TEST_F(LabelsOfAScene, HaveFlowThatComesBack)
{
    open("plaza", 20, 320, 240);
    const Sample now = labeller_->label(10, 0.4), next = labeller_->label(11, 0.44);
    size_t compared = 0;
    double farthest = 0;
    for (size_t i = 0; i < now.actor.size(); ++i) {
        if (now.actor[i] == 0 || std::isnan(now.forward[2 * i])) continue;
        const double x = static_cast<double>(i % 320) + 0.5 + static_cast<double>(now.forward[2 * i]),
                     y = static_cast<double>(i / 320) + 0.5 + static_cast<double>(now.forward[2 * i + 1]);
        if (x < 0 || y < 0 || x >= 320 || y >= 240) continue;
        const size_t to = static_cast<size_t>(y) * 320 + static_cast<size_t>(x);
        if (next.actor[to] != now.actor[i] || std::isnan(next.backward[2 * to])) continue;
        // The pixel's centre there is up to half a pixel beside the point, and depths may differ at folds.
        const double gap = std::hypot(static_cast<double>(now.forward[2 * i] + next.backward[2 * to]),
                                      static_cast<double>(now.forward[2 * i + 1] + next.backward[2 * to + 1]));
        compared += 1;
        farthest += gap > 1 ? 1 : 0;
    }
    EXPECT_GT(compared, 1000u);
    EXPECT_LT(farthest, static_cast<double>(compared) / 100);
}

}  // namespace
