// Answers of a scene while hosts do all that changes a crowd.
#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

#include "tests/api/scene_people.h"

namespace
{

using scene_people::Crowd;
using scene_people::Person;

// Runs jobs on as many threads.
clq_tasks tasks_of(uint32_t *threads)
{
    clq_tasks tasks = {};
    tasks.user = threads;
    tasks.run = [](void *user, uint32_t count, void (*job)(void *, uint32_t), void *data) {
        std::atomic<uint32_t> next{0};
        const auto work = [&] {
            for (uint32_t i = next++; i < count; i = next++) job(data, i);
        };
        std::vector<std::thread> others;
        for (uint32_t i = 1; i < *static_cast<const uint32_t *>(user); ++i) others.emplace_back(work);
        work();
        for (std::thread &other : others) other.join();
    };
    return tasks;
}

TEST(Scene, AnswersEachQuestionAsBruteForceDoesOverTenThousandOperations)
{
    for (uint64_t seed = 1; seed <= 5 && !testing::Test::HasFatalFailure(); ++seed) {
        Crowd crowd(seed, nullptr, seed % 2 ? 30 : 9);
        crowd.fill(120);
        for (uint32_t step = 0; step < 2000 && !testing::Test::HasFailure(); ++step) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
            crowd.happen();
            scene_people::ask(crowd, step + step / 7);
        }
    }
}

TEST(Scene, PutsEveryoneWhereAnUpdateDrawsThem)
{
    Crowd crowd(77);
    crowd.fill(120);
    uint32_t compared = 0;
    for (uint32_t step = 0; step < 1500; ++step) {
        crowd.happen();
        if (step % 50 != 49) continue;
        const double time_s = crowd.random.in(0, 20);
        ASSERT_EQ(clq_crowd_update(crowd.crowd, time_s, crowd.views, 2), CLQ_OK);
        for (const Person &person : crowd.people) {
            clq_actor_info info = clq_actor_info_init();
            ASSERT_EQ(clq_actor_get_info(crowd.crowd, person.id, &info), CLQ_OK);
            if (!info.visible) continue;
            const clq_scene_actor known = crowd.known(person, time_s);
            ASSERT_TRUE(known.present);
            for (int k = 0; k < 3; ++k) ASSERT_EQ(known.position[k], info.root.position[k]);
            EXPECT_NEAR(known.radius, double(std::fabs(info.root.scale) * info.sklsroot_radius), 1e-4);
            ++compared;
        }
    }
    EXPECT_GT(compared, 500u);
}

TEST(Scene, SaysTheSameWithAnyNumberOfThreads)
{
    std::vector<clq_scene_hit> first;
    for (uint32_t threads : {1u, 2u, 4u}) {
        const clq_tasks tasks = tasks_of(&threads);
        Crowd crowd(5, &tasks);
        crowd.fill(150);
        for (uint32_t step = 0; step < 400; ++step) crowd.happen();
        const double origin[3] = {0, 0, 0};
        std::vector<std::vector<clq_scene_hit>> answers(threads);
        std::vector<std::thread> asking;
        for (uint32_t i = 0; i < threads; ++i)
            asking.emplace_back([&, i] {
                for (int round = 0; round < 50; ++round) {
                    uint32_t count = 0;
                    answers[i].resize(400);
                    EXPECT_EQ(clq_scene_find_within(crowd.scene, crowd.time_s, origin, 25, nullptr, answers[i].data(),
                                                    400, &count),
                              CLQ_OK);
                    answers[i].resize(count);
                }
            });
        for (std::thread &one : asking) one.join();
        if (first.empty()) first = answers[0];
        ASSERT_GT(first.size(), 30u);
        for (const auto &answer : answers) {
            ASSERT_EQ(answer.size(), first.size());
            EXPECT_EQ(std::memcmp(answer.data(), first.data(), first.size() * sizeof first[0]), 0);
        }
    }
}

}  // namespace
