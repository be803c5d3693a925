// The work of questions follows the number of answers and not that of individuals, and so does the work of taking over
// what has changed.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "lib/scene/questions.h"
#include "tests/law/support/figure.h"

namespace claque::scene
{

namespace
{

using namespace testing_support;

// One individual to a square metre, with a scene.
struct Square {
    explicit Square(uint32_t side)
        : figure(make_figure()), crowd(std::pmr::get_default_resource()), scene(std::pmr::get_default_resource(), 1)
    {
        crowd.readers.push_back(&scene.changes());
        for (uint32_t i = 0; i < side * side; ++i) {
            crowd::Transform place;
            place.position = glm::dvec3(i % side, 0, i / side);
            place.scale = 0.2f;
            ids.push_back(crowd::create(crowd, *figure, place, crowd::Play(), i));
        }
        update(0);
    }
    void update(double time_s)
    {
        scene.reserve(crowd);
        scene.take_over(crowd, time_s);
    }
    void shift(uint32_t i, double by)
    {
        crowd::Transform place = crowd.transform_of(ids[i].index1 - 1);
        place.position.x += by;
        crowd::set_transforms(crowd, &ids[i], &place, 1);
    }
    // The work of asking from the middle.
    template <class Ask>
    Effort effort_of(const Ask &ask)
    {
        Effort effort;
        const Asked asked = {scene, crowd, filter, 0, &effort};
        ask(asked, Room{hits, 1000});
        return effort;
    }

    std::unique_ptr<model::Template> figure;
    crowd::Crowd crowd;
    Scene scene;
    Filter filter;
    std::vector<crowd::Id> ids;
    clq_scene_hit hits[1000];
};

constexpr uint32_t small = 24, large = 160;  // sides: 576 and 25600 individuals

// The larger crowd, of 44 times as many, may cost a path down the taller tree more.
template <class Ask>
void expect_alike(const char *question, const Ask &ask)
{
    const auto few = std::make_unique<Square>(small), many = std::make_unique<Square>(large);
    const Effort a = few->effort_of(ask), b = many->effort_of(ask);
    EXPECT_GT(a.tested, 0u) << question;
    EXPECT_LE(b.tested, 2 * a.tested + 30) << question;
    EXPECT_LE(b.nodes, 2 * a.nodes + 100) << question;
}

}  // namespace

TEST(SceneCost, OfQuestionsByPlaceDoesNotGrowWithTheCrowd)
{
    expect_alike("within", [](const Asked &asked, const Room &room) {
        EXPECT_EQ(find_within(asked, {12, 0, 12}, 3, room), 29u);
    });
    expect_alike("nearest", [](const Asked &asked, const Room &room) {
        find_nearest(asked, {12, 0, 12}, HUGE_VAL, {room.hits, 8});
    });
    expect_alike("box", [](const Asked &asked, const Room &room) {
        EXPECT_EQ(find_in_box(asked, {10, -1, 10}, {13, 1, 13}, room), 16u);
    });
    expect_alike("ray", [](const Asked &asked, const Room &room) {
        find_on_ray(asked, {{12, 8, 12}, {0, -1, 0}, HUGE_VAL}, room);
    });
    // Looks down on a few metres.
    expect_alike("frustum", [](const Asked &asked, const Room &room) {
        math::Frustum frustum;
        frustum.count = 4;
        for (int i = 0; i < 4; ++i) {
            const double x = i == 0 ? 1 : i == 1 ? -1 : 0, z = i == 2 ? 1 : i == 3 ? -1 : 0;
            frustum.planes[i] = {glm::dvec3(x, 0, z), 3};
        }
        find_in_frustum(asked, {12, 5, 12}, frustum, room);
    });
}

TEST(SceneCost, OfRareCategoriesFollowsTheirMembersHoweverLargeTheQuestion)
{
    const auto square = std::make_unique<Square>(large);
    const crowd::Id owls[3] = {square->ids[5], square->ids[9000], square->ids[20000]};
    square->scene.set_categories(square->crowd, owls, 3, 4);
    square->filter.all_of = 4;
    const Effort nearest = square->effort_of([](const Asked &asked, const Room &room) {
        EXPECT_EQ(find_nearest(asked, {12, 0, 12}, HUGE_VAL, room), 3u);
    });
    EXPECT_EQ(nearest.tested, 3u);
    const Effort found = square->effort_of([](const Asked &asked, const Room &) {
        clq_actor out[4];
        EXPECT_EQ(find(asked, out, 4), 3u);
        EXPECT_EQ(out[1].index1, 9001u);
    });
    EXPECT_EQ(found.tested, 0u) << "members of bitmaps are answers as they are";
}

TEST(SceneCost, OfWhatIsNotTakenOverIsOneTestEach)
{
    const auto square = std::make_unique<Square>(large);
    for (uint32_t i = 0; i < 40; ++i) square->shift(100 * i, 0.001);
    const auto ask = [](const Asked &asked, const Room &room) { find_within(asked, {12, 0, 12}, 3, room); };
    const Effort before = square->effort_of(ask);
    square->update(0);
    const Effort after = square->effort_of(ask);
    EXPECT_GE(before.tested, after.tested + 38);
    EXPECT_LE(before.tested, after.tested + 41);
}

TEST(SceneCost, OfTakingOverFollowsWhatHasMovedAndSmallStepsStayInTheirBoxes)
{
    const auto square = std::make_unique<Square>(small);
    const uint64_t made = square->scene.placed_count();
    square->update(5);
    EXPECT_EQ(square->scene.placed_count(), made) << "nothing has moved";
    square->shift(7, 0.1);
    square->update(6);
    EXPECT_EQ(square->scene.placed_count(), made + 1) << "it had a box without room to spare";
    for (int step = 0; step < 8; ++step) square->shift(7, 0.1), square->update(7 + step);
    EXPECT_EQ(square->scene.placed_count(), made + 1) << "and now has one of a metre to each side";
    square->shift(7, 5);
    square->update(20);
    EXPECT_EQ(square->scene.placed_count(), made + 2);
}

TEST(SceneCost, WithoutASceneNothingIsMarked)
{
    crowd::Crowd crowd(std::pmr::get_default_resource());
    const auto figure = make_figure();
    crowd::create(crowd, *figure, crowd::Transform(), crowd::Play(), 1);
    EXPECT_TRUE(crowd.readers.empty());
    EXPECT_EQ(crowd.readers.capacity(), 0u);
}

}  // namespace claque::scene
