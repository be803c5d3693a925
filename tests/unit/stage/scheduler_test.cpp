// The scheduler keeps its bound under overload, in declared costs and on a fake clock.
#include "lib/stage/schedule/scheduler.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

using namespace claque::stage;

namespace
{

// Tasks whose cost is their index, in the class that they name. The clock is this object's own.
struct FakeWork : Worker {
    bool is_alive(const Task &task) const override { return task.serial == 0; }
    uint32_t class_of(const Task &task) const override { return task.priority; }
    uint32_t cost_of(const Task &task) const override { return task.index; }
    void prepare(const Task &) override { ++prepared; }
    void run(const Task &task, bool late) override
    {
        if (fail_at && --fail_at == 0) throw 3;
        clock_s += 1e-6 * task.index * slowness;
        cost += task.index;
        done.push_back(task.agent);
        ticks.push_back(tick);
        lates += late;
    }
    static double now(void *user) { return static_cast<FakeWork *>(user)->clock_s; }
    double clock_s = 5, slowness = 1;
    uint32_t prepared = 0, cost = 0, tick = 0, fail_at = 0, lates = 0;
    std::vector<uint32_t> done, ticks;
};

Task task_of(uint32_t id, uint32_t priority, uint32_t cost, double due_s)
{
    Task task;
    task.agent = id, task.priority = static_cast<uint8_t>(priority), task.index = cost, task.due_s = due_s;
    return task;
}

Limits limits(double budget)
{
    Limits out;
    out.budget = budget;
    out.shares = {0.5, 0.25, 0.125, 0.125};
    return out;
}

struct Ticker {
    Ticker(const Limits &with) : scheduler(with) {}
    void add(const Task &task)
    {
        scheduler.reserve(1);
        scheduler.add(task);
    }
    void next()
    {
        work.tick = ++tick;
        scheduler.run(0.05 * (tick - 1), 0.05 * tick, work);
    }
    Scheduler scheduler;
    FakeWork work;
    uint32_t tick = 0;
};

TEST(Scheduler, RunsClassesInTheirOrderAndTasksInTheOrderOfTime)
{
    Ticker at(limits(0));
    at.add(task_of(1, 2, 1, 0.01));
    at.add(task_of(2, 0, 1, 0.04));
    at.add(task_of(3, 0, 1, 0.02));
    at.add(task_of(4, 1, 1, 0.03));
    at.add(task_of(5, 0, 1, 0.06));
    at.next();
    EXPECT_EQ(at.work.done, (std::vector<uint32_t>{3, 2, 4, 1}));
    at.next();
    EXPECT_EQ(at.work.done.back(), 5u);
    EXPECT_EQ(at.work.lates, 0u);
}

TEST(Scheduler, RunsMessagesOfOneMomentInTheSameOrderHoweverTheyArrive)
{
    Ticker forwards(limits(1000)), backwards(limits(1000));
    std::vector<Task> messages;
    for (uint32_t i = 0; i < 20; ++i) {
        messages.push_back(task_of(i, 1, 1, 0.01));
        messages.back().sender = 40 - 2 * i;
        messages.back().order = order_of_message(messages.back());
    }
    forwards.scheduler.reserve(messages.size()), backwards.scheduler.reserve(messages.size());
    for (const Task &message : messages) forwards.scheduler.add_message(message);
    std::reverse(messages.begin(), messages.end());
    for (const Task &message : messages) backwards.scheduler.add_message(message);
    forwards.next(), backwards.next();
    EXPECT_EQ(forwards.work.done.size(), 20u);
    EXPECT_EQ(forwards.work.done, backwards.work.done);
}

TEST(Scheduler, ForgetsTasksThatHaveBecomePointlessAtNoCost)
{
    Ticker at(limits(3));
    Task dead = task_of(1, 0, 3, 0.01);
    dead.serial = 1;
    at.add(dead);
    at.add(task_of(2, 0, 3, 0.02));
    at.next();
    EXPECT_EQ(at.work.done, std::vector<uint32_t>{2});
}

size_t waiting_of(const Scheduler &scheduler)
{
    size_t all = scheduler.waiting();
    for (const clq_stage_class_info &info : scheduler.done) all += info.waiting;
    return all;
}

TEST(Scheduler, KeepsNoTaskThatHasRunThatIsPointlessOrThatIsTheStagesOwn)
{
    for (const uint32_t fail_at : {0u, 17u}) {
        Ticker at(limits(20));
        at.work.fail_at = fail_at;
        for (uint32_t round = 0; round < 50; ++round) {
            for (uint32_t i = 0; i < 12; ++i) {
                Task task = task_of(i, i % 4, 1 + i % 5, 0.05 * at.tick + 0.004 * i);
                task.serial = i % 5 == 3;  // dead
                if (i % 6 == 5) task.kind = TaskKind::set;
                at.add(task);
            }
            try {
                at.next();
                EXPECT_EQ(at.scheduler.held(), waiting_of(at.scheduler)) << "round " << round;
            } catch (int) {
                --at.tick;
            }
        }
        for (int i = 0; i < 100; ++i) at.next();
        EXPECT_EQ(waiting_of(at.scheduler), 0u);
        EXPECT_EQ(at.scheduler.held(), 0u);
        EXPECT_GT(at.work.prepared, 50u);
    }
}

TEST(Scheduler, SpendsItsBudgetAndNoMore)
{
    Ticker at(limits(10));
    for (uint32_t i = 0; i < 100; ++i) at.add(task_of(i, i % 4, 1 + i % 3, 0.01));
    uint32_t before = 0;
    while (at.work.done.size() < 100) {
        at.next();
        EXPECT_LE(at.work.cost - before, 10u);
        EXPECT_GT(at.work.cost - before, 7u - (at.work.done.size() == 100 ? 7u : 0u)) << at.tick;
        before = at.work.cost;
    }
    uint64_t late = 0;
    for (const clq_stage_class_info &info : at.scheduler.done) late += info.late;
    EXPECT_EQ(late, at.work.lates);
    EXPECT_GT(late, 80u);
}

// Whatever the other classes are fed with, the first task of each class waits for at most this many ticks.
void expect_bound(bool live, uint32_t largest, uint64_t seed)
{
    Limits with = limits(40);
    Ticker at(with);
    if (live) {
        with.now_s = FakeWork::now, with.now_user = &at.work;
        at.scheduler.~Scheduler();
        new (&at.scheduler) Scheduler(with);
        at.work.slowness = 0.75;
    }
    uint64_t state = seed;
    const auto random = [&](uint32_t below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<uint32_t>((state >> 33) % below);
    };
    std::vector<uint32_t> first_tick[class_count];
    uint32_t next = 0;
    std::vector<uint32_t> costs, classes;
    std::vector<uint32_t> served_at(class_count, 0);
    std::vector<uint32_t> worst(class_count, 0);
    size_t seen = 0;
    for (uint32_t tick = 1; tick < 3000; ++tick) {
        for (uint32_t c = 0; c < class_count; ++c)
            for (uint32_t backlog = at.scheduler.done[c].waiting; backlog < 30; ++backlog) {
                const uint32_t cost = 1 + random(largest);
                costs.push_back(cost), classes.push_back(c);
                at.add(task_of(next++, c, cost, 0.05 * (tick - 1) + 0.001));
            }
        at.next();
        for (; seen < at.work.done.size(); ++seen) {
            const uint32_t c = classes[at.work.done[seen]];
            const double share = with.shares[c] * with.budget;
            const double bound = std::ceil(costs[at.work.done[seen]] / share) + 3;
            const uint32_t waited = at.work.ticks[seen] - served_at[c];
            EXPECT_LE(waited, bound) << "class " << c << ", cost " << costs[at.work.done[seen]];
            worst[c] = std::max(worst[c], waited);
            served_at[c] = at.work.ticks[seen];
        }
    }
    EXPECT_GT(worst[3], largest > 5 ? 1u : 0u) << "the overload must make a class wait";
    uint64_t total = 0;
    for (const clq_stage_class_info &info : at.scheduler.done) total += info.cost;
    for (uint32_t c = 0; c < class_count; ++c)
        EXPECT_GT(double(at.scheduler.done[c].cost), (largest > 7 ? 0.7 : 0.9) * with.shares[c] * double(total))
            << "its share, class " << c;
}

TEST(Scheduler, KeepsItsBoundUnderOverloadInDeclaredCosts)
{
    for (uint64_t seed = 1; seed < 6; ++seed)
        for (const uint32_t largest : {1u, 7u, 40u}) expect_bound(false, largest, seed);
}

TEST(Scheduler, KeepsItsBoundUnderOverloadOnAClock)
{
    for (uint64_t seed = 1; seed < 6; ++seed)
        for (const uint32_t largest : {1u, 7u, 40u}) expect_bound(true, largest, seed);
}

TEST(Scheduler, ATaskThatCostsMoreThanTheBudgetStillRuns)
{
    Ticker at(limits(10));
    at.add(task_of(0, 3, 1000, 0.01));
    for (uint32_t i = 1; i < 100; ++i) at.add(task_of(i, 0, 5, 0.01));
    for (int i = 0; i < 12; ++i) at.next();
    EXPECT_NE(std::find(at.work.done.begin(), at.work.done.end(), 0u), at.work.done.end());
}

TEST(Scheduler, GoesOnAfterAnExceptionWithTheSameTasks)
{
    std::vector<uint32_t> whole;
    for (uint32_t fail_at = 0; fail_at < 20; ++fail_at) {
        Ticker at(limits(10));
        for (uint32_t i = 0; i < 20; ++i) at.add(task_of(i, i % 4, 1 + i % 5, 0.002 * (i % 7)));
        at.work.fail_at = fail_at;
        for (int tick = 0; tick < 9; ++tick) {
            try {
                at.next();
            } catch (int) {
                --at.tick;  // again
                --tick;
            }
        }
        if (fail_at == 0) whole = at.work.done;
        EXPECT_EQ(at.work.done, whole) << "the task at work failed as number " << fail_at;
    }
    EXPECT_EQ(whole.size(), 20u);
}

}  // namespace
