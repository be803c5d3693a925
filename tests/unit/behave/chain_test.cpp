// Several mechanisms on one actor: who has the last word, who is off, who is called (S0 5.3, 7.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/behave/writer.h"
#include "stage.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

// Writes one value to one degree of freedom, and keeps what it was told.
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

TEST(Chain, TheHigherPriorityHasTheLastWordAndEqualOnesTheLaterUse)
{
    Stage stage;
    Puppeteer a, b, c;
    a.value = 0.2f, b.value = 0.4f, c.value = 0.6f;
    const uint32_t first = stage.add(a.mechanism(), 5), second = stage.add(b.mechanism(), 1);
    EXPECT_EQ(stage.at(0, smile), 0.2f);
    stage.add(c.mechanism(), 5);
    EXPECT_EQ(stage.at(0, smile), 0.6f);
    stage.use(0, second, 7);
    EXPECT_EQ(stage.at(0, smile), 0.4f);
    stage.use(0, first, 7);
    EXPECT_EQ(stage.at(0, smile), 0.2f);
    stage.crowd.drop(stage.ids[0], first);
    EXPECT_EQ(stage.at(0, smile), 0.4f);
}

TEST(Chain, WeighsWhatIsWrittenOverWhatIsThere)
{
    Stage stage;
    Puppeteer a, b;
    a.value = 0.5f, b.value = 1, b.weight = 0.25f;
    stage.add(a.mechanism(), 0), stage.add(b.mechanism(), 1);
    EXPECT_FLOAT_EQ(stage.at(0, smile), 0.625f);
}

TEST(Chain, HoldsWritesToTheRangeAndIgnoresWhatIsNoNumber)
{
    Stage stage;
    Puppeteer a;
    stage.add(a.mechanism());
    a.dof = left_lid, a.value = 7;
    EXPECT_EQ(stage.at(0, left_lid), 1.1f);
    a.value = -7;
    EXPECT_EQ(stage.at(0, left_lid), 0.0f);
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        a.value = bad, a.weight = 1;
        EXPECT_EQ(stage.at(0, left_lid), 0.1f) << "its rest";
        a.value = 1, a.weight = bad;
        EXPECT_EQ(stage.at(0, left_lid), bad > 0 ? 1.0f : 0.1f);
    }
    a.dof = dof_count, a.value = a.weight = 1;
    const std::vector<float> dofs = stage.at(0);
    for (uint32_t i = 0; i < dof_count; ++i) EXPECT_EQ(dofs[i], stage.dof(i).rest);
}

TEST(Chain, WritesNothingToNodesThatAreLost)
{
    Stage stage;
    const uint32_t g = stage.add(gaze());
    stage.add(blink());
    Puppeteer host;
    host.dof = open_mouth, host.value = 1;  // a morph target of the neck's node
    stage.add(host.mechanism());
    crowd::Command &told = stage.crowd.command(stage.ids[0], g);
    told.choice = 0, told.point = glm::vec3(3, 2, 3);
    const auto moved = [&](Skeleton skeleton) {
        std::vector<uint32_t> out;
        // Some moment at which lids are not where they rest.
        for (double t = 10; t < 20; t += 0.05) {
            const std::vector<float> &dofs = stage.at(t, 0, 0, skeleton);
            for (uint32_t i = 0; i < dof_count; ++i)
                if (dofs[i] != stage.dof(i).rest && std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
        }
        return out.size();
    };
    EXPECT_EQ(moved(whole), 11u);
    EXPECT_EQ(moved(without_eyes), 5u);
    EXPECT_EQ(moved(without_neck), 2u);
    EXPECT_EQ(moved(without_spine), 0u);
}

TEST(Chain, IsOffWhereAllThatItWritesIsLostAndFromItsDistanceOn)
{
    Stage stage;
    Puppeteer host;
    stage.add(gaze());
    stage.add(blink());
    stage.add(with_levels(expression(), 10, 20, 30));
    stage.add(host.mechanism());
    crowd::Idle idle(std::pmr::get_default_resource());
    idle.clips = {1};
    stage.add(std::move(idle));
    const auto levels = [&](float distance, Skeleton skeleton) {
        const Levels found = levels_of(stage.crowd, 0, distance, stage.tmpl->levels[skeleton]);
        std::vector<uint32_t> out;
        for (uint32_t i = 0; i < 5; ++i) out.push_back(level_at(found, i));
        return out;
    };
    using L = std::vector<uint32_t>;
    EXPECT_EQ(levels(0, whole), (L{0, 0, 0, 0, 0}));
    EXPECT_EQ(levels(10, whole), (L{0, 0, 1, 0, 0}));
    EXPECT_EQ(levels(29, whole), (L{0, 0, 2, 0, 0}));
    EXPECT_EQ(levels(30, whole), (L{0, 0, off, 0, 0}));
    EXPECT_EQ(levels(0, without_eyes), (L{0, off, 0, 0, 0})) << "the mouth hangs on the neck's node";
    EXPECT_EQ(levels(0, without_neck), (L{0, off, off, 0, 0}));
    EXPECT_EQ(levels(0, without_spine), (L{off, off, off, off, 0})) << "clips are played for whatever is left";
    stage.counts = Counts();
    stage.at(1, 0, 15, without_eyes);
    EXPECT_EQ(stage.counts.calls[0], 1u);
    EXPECT_EQ(stage.counts.calls[2], 0u) << "blink";
    EXPECT_EQ(stage.counts.calls[5], 1u);
}

TEST(Chain, CountsCallsByKindAndWrites)
{
    Stage stage;
    Puppeteer host;
    stage.add(gaze()), stage.add(host.mechanism()), stage.add(blink());
    stage.at(1000.5);
    EXPECT_EQ(stage.counts.calls[0], 1u);
    EXPECT_EQ(stage.counts.calls[2], 1u);
    EXPECT_EQ(stage.counts.calls[5], 1u);
    EXPECT_GE(stage.counts.writes, 9u) << "eight of the gaze and one of the host, and lids where they blink";
    EXPECT_LE(stage.counts.writes, 11u);
}

TEST(Chain, TellsTheHostWhoWhenWhereAndHowExactly)
{
    Stage stage(3);
    Puppeteer host;
    stage.add(with_levels(host.mechanism(), 10, 20, 0x1p10f));
    stage.at(12.5, 2, 15);
    ASSERT_EQ(host.calls.size(), 1u);
    const clq_behaviour_call &call = host.calls[0];
    EXPECT_EQ(call.actor.index1, stage.ids[2].index1);
    EXPECT_EQ(call.actor.generation, stage.ids[2].generation);
    EXPECT_EQ(call.level, 1u);
    EXPECT_EQ(call.seed, 102u);
    EXPECT_EQ(call.time_s, 12.5);
    EXPECT_EQ(call.eye_distance, 15);
    EXPECT_EQ(call.seen, 1);
}

TEST(Chain, RunsOnlyMemoriesForWhomNobodyLooksAtAndTheseAreNeverOff)
{
    Stage stage;
    Puppeteer forgetful, elephant;
    stage.add(gaze()), stage.add(forgetful.mechanism());
    EXPECT_TRUE(has_host(stage.crowd, 0));
    EXPECT_FALSE(has_memory(stage.crowd, 0));
    stage.add(elephant.mechanism(true));
    EXPECT_TRUE(has_memory(stage.crowd, 0));
    Moment moment;
    moment.level = &stage.tmpl->levels[whole];
    moment.seen = moment.wanted = false;
    std::vector<float> dofs(dof_count);
    Counts counts;
    run(stage.crowd, 0, moment, base::Span<float>(dofs), counts);
    EXPECT_EQ(counts.calls[0], 0u);
    EXPECT_EQ(elephant.calls.size(), 1u);
    elephant.calls.clear();
    counts = Counts();
    moment.level = &stage.tmpl->levels[without_spine];
    moment.levels = levels_of(stage.crowd, 0, 1e9f, *moment.level);
    run(stage.crowd, 0, moment, base::Span<float>(dofs), counts);
    EXPECT_EQ(counts.calls[0], 0u);
    EXPECT_EQ(counts.calls[5], 1u);
    EXPECT_EQ(counts.writes, 0u);
    EXPECT_TRUE(forgetful.calls.empty());
    ASSERT_EQ(elephant.calls.size(), 1u);
    EXPECT_EQ(elephant.calls[0].seen, 0);
}

TEST(Chain, ShowsTheSameAtAMomentInWhateverOrderMomentsAreAsked)
{
    Stage stage(4);
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    stage.add(wanders), stage.add(expression(), 1), stage.add(phrase(1), 2), stage.add(blink(), 3);
    std::vector<uint64_t> forwards, backwards;
    for (int i = -2000; i < 2000; ++i) forwards.push_back(bits_of(stage.at(i * 0.037, uint32_t(i & 3))));
    for (int i = 1999; i >= -2000; --i) backwards.push_back(bits_of(stage.at(i * 0.037, uint32_t(i & 3))));
    std::reverse(backwards.begin(), backwards.end());
    EXPECT_EQ(forwards, backwards);
    Stage again(4);
    again.add(wanders), again.add(expression(), 1), again.add(phrase(1), 2), again.add(blink(), 3);
    EXPECT_EQ(bits_of(again.at(31.4, 3)), bits_of(stage.at(31.4, 3)));
}

TEST(Chain, NeverLeavesARangeAtAHundredThousandMoments)
{
    Stage stage;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 0.7f, wanders.wander_yaw = wanders.wander_pitch = 3;
    stage.add(wanders), stage.add(expression(), 1), stage.add(phrase(1), 2), stage.add(blink(), 3);
    for (int i = 0; i < 100000; ++i) {
        const std::vector<float> &dofs = stage.at(i * 0.0171 - 500);
        for (uint32_t k = 0; k < dof_count; ++k) {
            ASSERT_GE(dofs[k], stage.dof(k).first) << i;
            ASSERT_LE(dofs[k], stage.dof(k).last) << i;
        }
    }
}

TEST(Chain, IsDifferentForEverybodyAndTheSameForTwins)
{
    Stage stage(40), other(40, 8);
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    for (Stage *s : {&stage, &other}) s->add(wanders), s->add(expression()), s->add(blink());
    const crowd::Id twin = stage.crowd.clone(stage.ids[3], nullptr, 103);
    stage.ids.push_back(twin);
    std::vector<std::vector<float>> all;
    for (uint32_t i = 0; i < 40; ++i) all.push_back(stage.at(50, i));
    for (uint32_t i = 0; i < 40; ++i) {
        for (uint32_t k = 0; k < i; ++k) EXPECT_NE(all[i], all[k]) << i << " and " << k;
        EXPECT_NE(other.at(50, i), all[i]) << "another crowd's seed";
    }
    EXPECT_EQ(stage.at(50, 40), all[3]);
}

TEST(Chain, GivesEveryUseAClockOfItsOwn)
{
    Stage stage(2);
    const uint32_t p = stage.add(phrase(0));
    stage.use(1, p, 0, 0.25f, 100);
    for (double t = 0; t < 3; t += 0.0625) EXPECT_EQ(stage.at(100 - 0.25 + t, 1), stage.at(t, 0)) << t;
}

}  // namespace claque::behave
