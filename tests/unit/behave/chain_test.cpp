// Several mechanisms on one actor: which one writes last, which ones are disabled, which ones are called (S0 5.3, 7.1).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/behave/writer.h"
#include "lib/crowd/edits.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

// Writes one value to one degree of freedom and records its calls.
struct Puppeteer {
    uint32_t dof = smile;
    float value = 0, weight = 1;
    std::vector<clq_behaviour_call> calls;

    crowd::HostMechanism mechanism(bool memory = false) { return {run, this, memory}; }
    static void run(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
    {
        Puppeteer &self = *static_cast<Puppeteer *>(user);
        self.calls.push_back(*call);
        writer->write(self.dof, self.value, self.weight);
    }
};

crowd::Mechanism with_levels(crowd::MechanismKind kind, float first, float second, float off_m)
{
    crowd::Mechanism out;
    out.kind = std::move(kind);
    out.level_m[0] = first, out.level_m[1] = second;
    out.off_m = off_m;
    return out;
}

uint64_t bits_of(const std::vector<float> &dofs) { return base::fnv(base::fnv_start, dofs.data(), dofs.size() * 4); }

}  // namespace

TEST(Chain, TheHigherPriorityWritesLastAndOfEqualOnesTheLaterAttachment)
{
    TestActors test_actors;
    Puppeteer a, b, c;
    a.value = 0.2f, b.value = 0.4f, c.value = 0.6f;
    const uint32_t first = test_actors.add(a.mechanism(), 5), second = test_actors.add(b.mechanism(), 1);
    EXPECT_EQ(test_actors.at(0, smile), 0.2f);
    test_actors.add(c.mechanism(), 5);
    EXPECT_EQ(test_actors.at(0, smile), 0.6f);
    test_actors.use(0, second, 7);
    EXPECT_EQ(test_actors.at(0, smile), 0.4f);
    test_actors.use(0, first, 7);
    EXPECT_EQ(test_actors.at(0, smile), 0.2f);
    crowd::detach_mechanism(test_actors.crowd, test_actors.ids[0], first);
    EXPECT_EQ(test_actors.at(0, smile), 0.4f);
}

TEST(Chain, BlendsAWriteWithTheValueBeforeItByWeight)
{
    TestActors test_actors;
    Puppeteer a, b;
    a.value = 0.5f, b.value = 1, b.weight = 0.25f;
    test_actors.add(a.mechanism(), 0), test_actors.add(b.mechanism(), 1);
    EXPECT_FLOAT_EQ(test_actors.at(0, smile), 0.625f);
}

TEST(Chain, ClampsWritesToTheRangeAndIgnoresNonFiniteNumbers)
{
    TestActors test_actors;
    Puppeteer a;
    test_actors.add(a.mechanism());
    a.dof = left_lid, a.value = 7;
    EXPECT_EQ(test_actors.at(0, left_lid), 1.1f);
    a.value = -7;
    EXPECT_EQ(test_actors.at(0, left_lid), 0.0f);
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        a.value = bad, a.weight = 1;
        EXPECT_EQ(test_actors.at(0, left_lid), 0.1f) << "its rest";
        a.value = 1, a.weight = bad;
        EXPECT_EQ(test_actors.at(0, left_lid), bad > 0 ? 1.0f : 0.1f);
    }
    a.dof = dof_count, a.value = a.weight = 1;
    const std::vector<float> dofs = test_actors.at(0);
    for (uint32_t i = 0; i < dof_count; ++i) EXPECT_EQ(dofs[i], test_actors.dof(i).rest);
}

TEST(Chain, WritesNothingToDeactivatedNodes)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    test_actors.add(blink());
    Puppeteer host;
    host.dof = open_mouth, host.value = 1;  // a morph target of the neck's node
    test_actors.add(host.mechanism());
    crowd::CommandHistory &history = crowd::command_history(test_actors.crowd, test_actors.ids[0], g);
    history.choice = 0, history.point = glm::vec3(3, 2, 3);
    const auto moved = [&](Skeleton skeleton) {
        std::vector<uint32_t> out;
        // A time at which the lids are not at rest.
        for (double t = 10; t < 20; t += 0.05) {
            const std::vector<float> &dofs = test_actors.at(t, 0, 0, skeleton);
            for (uint32_t i = 0; i < dof_count; ++i)
                if (dofs[i] != test_actors.dof(i).rest && std::find(out.begin(), out.end(), i) == out.end())
                    out.push_back(i);
        }
        return out.size();
    };
    EXPECT_EQ(moved(whole), 11u);
    EXPECT_EQ(moved(without_eyes), 5u);
    EXPECT_EQ(moved(without_neck), 2u);
    EXPECT_EQ(moved(without_spine), 0u);
}

TEST(Chain, IsDisabledWhereItWritesNothingAndFromItsDistanceOn)
{
    TestActors test_actors;
    Puppeteer host;
    test_actors.add(gaze());
    test_actors.add(blink());
    test_actors.add(with_levels(expression(), 10, 20, 30));
    test_actors.add(host.mechanism());
    crowd::Idle idle(std::pmr::get_default_resource());
    idle.clips = {1};
    test_actors.add(std::move(idle));
    const auto levels = [&](float distance, Skeleton skeleton) {
        const MechanismLevels found =
            mechanism_levels(test_actors.crowd, 0, distance, test_actors.tmpl->levels[skeleton]);
        std::vector<uint32_t> out;
        for (uint32_t i = 0; i < 5; ++i) out.push_back(mechanism_level(found, i));
        return out;
    };
    using L = std::vector<uint32_t>;
    EXPECT_EQ(levels(0, whole), (L{0, 0, 0, 0, 0}));
    EXPECT_EQ(levels(10, whole), (L{0, 0, 1, 0, 0}));
    EXPECT_EQ(levels(29, whole), (L{0, 0, 2, 0, 0}));
    EXPECT_EQ(levels(30, whole), (L{0, 0, off, 0, 0}));
    EXPECT_EQ(levels(0, without_eyes), (L{0, off, 0, 0, 0})) << "the mouth hangs on the neck's node";
    EXPECT_EQ(levels(0, without_neck), (L{0, off, off, 0, 0}));
    EXPECT_EQ(levels(0, without_spine), (L{off, off, off, off, 0})) << "clips move the remaining nodes";
    test_actors.counts = Counts();
    test_actors.at(1, 0, 15, without_eyes);
    EXPECT_EQ(test_actors.counts.calls[0], 1u);
    EXPECT_EQ(test_actors.counts.calls[2], 0u) << "blink";
    EXPECT_EQ(test_actors.counts.calls[5], 1u);
}

TEST(Chain, CountsCallsByKindAndWrites)
{
    TestActors test_actors;
    Puppeteer host;
    test_actors.add(gaze()), test_actors.add(host.mechanism()), test_actors.add(blink());
    test_actors.at(1000.5);
    EXPECT_EQ(test_actors.counts.calls[0], 1u);
    EXPECT_EQ(test_actors.counts.calls[2], 1u);
    EXPECT_EQ(test_actors.counts.calls[5], 1u);
    EXPECT_GE(test_actors.counts.writes, 9u) << "eight by the gaze, one by the host, and the lids during blinks";
    EXPECT_LE(test_actors.counts.writes, 11u);
}

TEST(Chain, PassesTheHostActorTimeDistanceAndLevel)
{
    TestActors test_actors(3);
    Puppeteer host;
    test_actors.add(with_levels(host.mechanism(), 10, 20, 0x1p10f));
    test_actors.at(12.5, 2, 15);
    ASSERT_EQ(host.calls.size(), 1u);
    const clq_behaviour_call &call = host.calls[0];
    EXPECT_EQ(call.actor.index1, test_actors.ids[2].index1);
    EXPECT_EQ(call.actor.generation, test_actors.ids[2].generation);
    EXPECT_EQ(call.level, 1u);
    EXPECT_EQ(call.seed, 102u);
    EXPECT_EQ(call.time_s, 12.5);
    EXPECT_EQ(call.eye_distance_m, 15);
    EXPECT_EQ(call.visible, 1);
}

TEST(Chain, RunsOnlyMechanismsWithMemoryForInvisibleActorsAndTheseAreNeverOff)
{
    TestActors test_actors;
    Puppeteer forgetful, elephant;
    test_actors.add(gaze()), test_actors.add(forgetful.mechanism());
    EXPECT_TRUE(test_actors.crowd.behaviours().any_host());
    EXPECT_FALSE(has_memory(test_actors.crowd, 0));
    test_actors.add(elephant.mechanism(true));
    EXPECT_TRUE(has_memory(test_actors.crowd, 0));
    EvaluationContext context;
    context.level = &test_actors.tmpl->levels[whole];
    context.visible = context.wanted = false;
    std::vector<float> dofs(dof_count);
    Counts counts;
    run(test_actors.crowd, 0, context, base::Span<float>(dofs), counts);
    EXPECT_EQ(counts.calls[0], 0u);
    EXPECT_EQ(elephant.calls.size(), 1u);
    elephant.calls.clear();
    counts = Counts();
    context.level = &test_actors.tmpl->levels[without_spine];
    context.levels = mechanism_levels(test_actors.crowd, 0, 1e9f, *context.level);
    run(test_actors.crowd, 0, context, base::Span<float>(dofs), counts);
    EXPECT_EQ(counts.calls[0], 0u);
    EXPECT_EQ(counts.calls[5], 1u);
    EXPECT_EQ(counts.writes, 0u);
    EXPECT_TRUE(forgetful.calls.empty());
    ASSERT_EQ(elephant.calls.size(), 1u);
    EXPECT_EQ(elephant.calls[0].visible, 0);
}

TEST(Chain, ShowsTheSameAtATimeInWhateverOrderTimesAreEvaluated)
{
    TestActors test_actors(4);
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    test_actors.add(wanders), test_actors.add(expression(), 1), test_actors.add(phrase(1), 2),
        test_actors.add(blink(), 3);
    std::vector<uint64_t> forwards, backwards;
    for (int i = -2000; i < 2000; ++i) forwards.push_back(bits_of(test_actors.at(i * 0.037, uint32_t(i & 3))));
    for (int i = 1999; i >= -2000; --i) backwards.push_back(bits_of(test_actors.at(i * 0.037, uint32_t(i & 3))));
    std::reverse(backwards.begin(), backwards.end());
    EXPECT_EQ(forwards, backwards);
    TestActors again(4);
    again.add(wanders), again.add(expression(), 1), again.add(phrase(1), 2), again.add(blink(), 3);
    EXPECT_EQ(bits_of(again.at(31.4, 3)), bits_of(test_actors.at(31.4, 3)));
}

TEST(Chain, NeverLeavesARangeAtAHundredThousandTimes)
{
    TestActors test_actors;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 0.7f, wanders.wander_yaw = wanders.wander_pitch = 3;
    test_actors.add(wanders), test_actors.add(expression(), 1), test_actors.add(phrase(1), 2),
        test_actors.add(blink(), 3);
    for (int i = 0; i < 100000; ++i) {
        const std::vector<float> &dofs = test_actors.at(i * 0.0171 - 500);
        for (uint32_t k = 0; k < dof_count; ++k) {
            ASSERT_GE(dofs[k], test_actors.dof(k).min) << i;
            ASSERT_LE(dofs[k], test_actors.dof(k).max) << i;
        }
    }
}

TEST(Chain, IsDifferentForEveryActorAndTheSameForTwins)
{
    TestActors test_actors(40), other(40, 8);
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    for (TestActors *s : {&test_actors, &other}) s->add(wanders), s->add(expression()), s->add(blink());
    const crowd::Id twin = crowd::clone(test_actors.crowd, test_actors.ids[3], nullptr, 103);
    test_actors.ids.push_back(twin);
    std::vector<std::vector<float>> all;
    for (uint32_t i = 0; i < 40; ++i) all.push_back(test_actors.at(50, i));
    for (uint32_t i = 0; i < 40; ++i) {
        for (uint32_t k = 0; k < i; ++k) EXPECT_NE(all[i], all[k]) << i << " and " << k;
        EXPECT_NE(other.at(50, i), all[i]) << "another crowd's seed";
    }
    EXPECT_EQ(test_actors.at(50, 40), all[3]);
}

TEST(Chain, GivesEveryAttachmentAClockOfItsOwn)
{
    TestActors test_actors(2);
    const uint32_t p = test_actors.add(phrase(0));
    test_actors.use(1, p, 0, 0.25f, 100);
    for (double t = 0; t < 3; t += 0.0625) EXPECT_EQ(test_actors.at(100 - 0.25 + t, 1), test_actors.at(t, 0)) << t;
}

}  // namespace claque::behave
