// The live clock: no actor steps back.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/crowd/edits.h"
#include "support/scene.h"

namespace claque
{

using namespace testing_support;

namespace
{

// How an eye moves before 400 individuals in rows from 4 to 60 m, and how the frames follow each other.
struct Journey {
    const char *name;
    glm::dvec3 (*eye)(int frame, double time_s);
    double (*frame_s)(int frame);
};

double random_of(int frame, uint64_t series)
{
    return double(base::unit(base::mix(base::mix(series) ^ static_cast<uint64_t>(frame))));
}
double even_frames(int) { return 1 / 60.0; }
double uneven_frames(int frame) { return frame % 97 == 0 ? 0.4 : 0.002 + 0.03 * random_of(frame, 3); }

const Journey journeys[] = {
    {"forward and back", [](int, double t) { return glm::dvec3(0, 1.7, 20 - 20 * std::cos(t * 1.8)); }, even_frames},
    {"forward and back in uneven frames", [](int, double t) { return glm::dvec3(0, 1.7, 20 - 20 * std::cos(t * 1.7)); },
     uneven_frames},
    {"jumps", [](int frame, double) { return glm::dvec3(0, 1.7, 60 * random_of(frame / 7, 1)); }, even_frames},
    {"jumps and looks away in uneven frames",
     [](int frame, double) { return glm::dvec3(frame % 50 < 10 ? 4000 : 0, 1.7, 60 * random_of(frame, 2)); },
     uneven_frames},
    {"a trot that trembles",
     [](int frame, double t) { return glm::dvec3(0, 1.7, 40 - 2 * t + 3 * random_of(frame, 4)); }, even_frames}};

// Of actors that are visible in a hundred frames or more, as all of them have to be.
uint32_t count_steps_back(frame::Clock clock, const Journey &journey)
{
    Scene scene(people(400, clock));
    crowd::Play play;
    play.clip = clip_walk;
    for (uint32_t i = 0; i < 400; ++i) {
        crowd::Transform place;
        place.position = glm::dvec3(0.01 * (i % 20), 1, -4 - 56.0 * i / 400);
        crowd::set_transforms(scene.crowd, &scene.ids[i], &place, 1);
        crowd::play(scene.crowd, scene.ids[i], play);
    }
    std::vector<double> shown(400, -1);
    std::vector<bool> stepped(400, false);
    std::vector<uint32_t> frames(400, 0);
    double t = 50;
    for (int f = 0; f < 400; ++f, t += journey.frame_s(f)) {
        scene.look(0, journey.eye(f, t - 50), glm::dvec3(0, 1, -500));
        EXPECT_TRUE(scene.try_update(t).ok());
        for (uint32_t i = 0; i < 400; ++i) {
            const frame::ActorVisibility seen = scene.frame.visibility(scene.crowd, i);
            if (!seen.visible) continue;
            ++frames[i];
            if (seen.shown_s < shown[i]) stepped[i] = true;
            shown[i] = seen.shown_s;
            EXPECT_LE(seen.shown_s, t);
        }
    }
    EXPECT_GE(*std::min_element(frames.begin(), frames.end()), 100u) << journey.name;
    return static_cast<uint32_t>(std::count(stepped.begin(), stepped.end(), true));
}

}  // namespace

TEST(LiveLaw, ActorsStepBackInReferenceModeAndNoneInLiveMode)
{
    for (const Journey &journey : journeys) {
        const uint32_t reference = count_steps_back(frame::Clock::reference, journey);
        std::printf("%s: of 400 actors, %u step back in reference mode\n", journey.name, reference);
        EXPECT_GT(reference, 100u) << journey.name;
        EXPECT_EQ(count_steps_back(frame::Clock::live, journey), 0u) << journey.name;
    }
}

TEST(LiveLaw, TimeThatRunsBackForgetsWhatWasShown)
{
    Scene live(people(80, frame::Clock::live));
    live.update(20);
    live.update(20.4);
    Scene fresh(people(80, frame::Clock::live));
    EXPECT_EQ(live.update(20.39), fresh.update(20.39));
    EXPECT_EQ(live.update(-3), Scene(people(80, frame::Clock::live)).update(-3));
}

TEST(LiveLaw, AnActorIsNotBoundByTheOneThatHadItsRowBefore)
{
    SceneDef def = people(40, frame::Clock::live), free_def = people(40, frame::Clock::reference);
    Scene live(def), reference(free_def);
    uint32_t earlier = 0;
    for (Scene *scene : {&live, &reference}) {
        scene->update(20);
        for (uint32_t row = 0; row < 40; ++row) {
            const crowd::Transform place = scene->crowd.transform_of(row);
            crowd::destroy(scene->crowd, scene->ids[row]);
            scene->ids[row] = crowd::create(scene->crowd, *scene->templates[0], place, crowd::Play(), row);
        }
        scene->update(20.001);
    }
    for (uint32_t row = 0; row < 40; ++row) {
        const frame::ActorVisibility a = live.frame.visibility(live.crowd, row);
        const frame::ActorVisibility b = reference.frame.visibility(reference.crowd, row);
        ASSERT_EQ(a.visible, b.visible);
        if (!a.visible) continue;
        EXPECT_EQ(a.shown_s, b.shown_s) << row;
        earlier += b.shown_s < 19.95;
    }
    EXPECT_GT(earlier, 5u) << "too few ticks lie before that of the actor before";
}

TEST(LiveLaw, ACameraThatComesNearerIsAnsweredAtOnceAsInReferenceMode)
{
    Scene live(people(80, frame::Clock::live)), reference;
    for (Scene *scene : {&live, &reference}) {
        scene->look(0, glm::dvec3(0, 1.7, 40), glm::dvec3(0, 1, -30));
        scene->update(9);
        scene->look(0, glm::dvec3(0, 1.7, 0), glm::dvec3(0, 1, -30));
    }
    EXPECT_EQ(live.update(9.3), reference.update(9.3));
}

}  // namespace claque
