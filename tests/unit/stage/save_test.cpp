// A stage that is saved in the middle of a run and restored has the same future.
#include "tests/unit/stage/stage_world.h"

namespace
{

const char *const busy_machine = R"toml(
machine = "m"
[variables]
n = 0.0
[crowd]
mood = 0.0
[events]
wave = 1
calm = 2
[masks]
hand = { nodes = ["hand"] }
[states.up]
initial = true
transitions = [ { on = "wave", if = "random(0, 1) < 0.7", to = "down" } ]
[states.up.states.one]
initial = true
enter = [ { play = ["slow", "fast"], speed = [0.8, 1.2], fade = 0.2 },
    { send = "wave", radius = 3, delay = [0, 1], per_m = 0.1 } ]
while = { every = [0.2, 0.6], do = [ { gesture = "wave", mask = "hand", loops = 0 },
    { set = "n", to = "n + random(0, 2)" } ] }
transitions = [ { end = true, before = 0.2, to = "two" }, { if = 'count("", 4) > 5 and n > 3', to = "two" } ]
[states.up.states.two]
enter = [ { end_gesture = true }, { set = "crowd.mood", to = "crowd.mood + 1" } ]
transitions = [ { after = [0.3, 2], to = "one" }, { marker = "down", do = [ { set = "n", to = 0 } ] },
    { if = "crowd.mood > 40", to = "down" } ]
[states.down]
enter = [ { play = "bent", fade = 0.1 } ]
transitions = [ { after = [1, 2], to = "up", history = "deep" }, { on = "calm", to = "up" } ]
)toml";

struct Evening {
    explicit Evening(uint32_t budget = 0) : def(limited(budget)), world(&def) { machine = world.machine(busy_machine); }
    void fill()
    {
        agents.push_back(world.actor_agent(machine));
        for (int i = 1; i < 60; ++i) agents.push_back(world.agent(machine, 0.7 * i, i % 3 ? "" : "owl", uint64_t(i)));
        const std::string text = "[[event]]\nat = 0.3\nsend = \"calm\"\nevery = 1.3\nclass = \"owl\"\n";
        clq_stage_text source = clq_stage_text_init();
        source.text = text.data(), source.text_bytes = text.size();
        EXPECT_EQ(clq_stage_add_timetable(world.stage, &source, 0), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_stage_remove_agent(world.stage, agents[7]), CLQ_OK);
    }
    static clq_stage_def limited(uint32_t budget)
    {
        clq_stage_def def = clq_stage_def_init();
        def.seed = 9, def.budget = budget;
        return def;
    }
    std::vector<uint8_t> saved() const
    {
        std::vector<uint8_t> out;
        EXPECT_EQ(clq_stage_save(world.stage, take, &out), CLQ_OK) << clq_last_error();
        return out;
    }
    static int take(void *user, const void *bytes, size_t size)
    {
        auto &out = *static_cast<std::vector<uint8_t> *>(user);
        out.insert(out.end(), static_cast<const uint8_t *>(bytes), static_cast<const uint8_t *>(bytes) + size);
        return 0;
    }
    std::vector<uint8_t> saved_crowd() const
    {
        std::vector<uint8_t> out;
        EXPECT_EQ(clq_crowd_save(world.arm.crowd, take, &out), CLQ_OK) << clq_last_error();
        return out;
    }
    clq_stage_def def;
    StageWorld world;
    clq_machine machine{};
    std::vector<clq_agent> agents;
};

TEST(SavedStage, HasTheSameFuture)
{
    for (const uint32_t budget : {0u, 4u}) {
        Evening first(budget);
        first.fill();
        first.world.step(4);
        first.world.apply(2.9);  // commands are left
        first.world.send("calm", 6.2);
        const std::vector<uint8_t> stage = first.saved(), crowd = first.saved_crowd();
        Evening second(budget);
        ASSERT_EQ(clq_stage_restore(second.world.stage, second.world.arm.crowd, stage.data(), stage.size()), CLQ_OK)
            << clq_last_error();
        ASSERT_EQ(clq_crowd_restore(second.world.arm.crowd, crowd.data(), crowd.size(), &second.world.arm.tmpl, 1),
                  CLQ_OK)
            << clq_last_error();
        EXPECT_EQ(second.saved(), stage);
        EXPECT_EQ(second.world.info().agents, 59u);
        for (double t = 4; t < 12; t += 0.25) {
            first.world.step(t + 1);
            second.world.step(t + 1);
            EXPECT_EQ(first.world.info().hash, second.world.info().hash) << t;
            first.world.apply(t), second.world.apply(t);
            EXPECT_EQ(clq_crowd_get_hash(first.world.arm.crowd), clq_crowd_get_hash(second.world.arm.crowd)) << t;
        }
        EXPECT_EQ(second.saved(), first.saved());
        EXPECT_GT(first.world.info().transitions, 200u);
        EXPECT_EQ(first.world.info().classes[2].late > 0, budget > 0);
    }
}

TEST(SavedStage, OfAnotherKindIsRefused)
{
    Evening first, second(3);
    first.fill();
    first.world.step(1);
    std::vector<uint8_t> bytes = first.saved();
    EXPECT_EQ(clq_stage_restore(second.world.stage, nullptr, bytes.data(), bytes.size()), CLQ_ARGUMENT);
    Evening third;
    third.world.machine("machine = \"n\"\n[states.a]\n");
    EXPECT_EQ(clq_stage_restore(third.world.stage, nullptr, bytes.data(), bytes.size()), CLQ_ARGUMENT);
    EXPECT_EQ(clq_stage_restore(first.world.stage, nullptr, bytes.data(), bytes.size() - 1), CLQ_FORMAT);
    bytes[100] ^= 1;
    EXPECT_EQ(clq_stage_restore(first.world.stage, nullptr, bytes.data(), bytes.size()), CLQ_FORMAT);
    EXPECT_STREQ(clq_last_error(), "clq_stage_restore: the bytes are no saved stage: they have been changed");
    bytes[8] = 7;
    EXPECT_EQ(clq_stage_restore(first.world.stage, nullptr, bytes.data(), bytes.size()), CLQ_FORMAT);
}

uint64_t fnv(const std::vector<uint8_t> &bytes)
{
    uint64_t h = 0xcbf29ce484222325ULL;
    for (size_t i = 28; i < bytes.size(); ++i) h = (h ^ bytes[i]) * 0x100000001b3ULL;
    return h;
}

// So that changed bytes are read at all.
void give_hash_that_fits(std::vector<uint8_t> &bytes)
{
    const uint64_t h = fnv(bytes);
    for (size_t b = 0; b < 8; ++b) bytes[20 + b] = static_cast<uint8_t>(h >> (8 * b));
}

// Of a stage in the middle of things.
std::vector<uint8_t> saved_after_three_seconds(Evening &run)
{
    run.fill();
    run.world.step(3);
    run.world.apply(2);
    return run.saved();
}

TEST(SavedStage, IsRefusedWhereAnAgentIsInStatesThatDoNotHoldEachOther)
{
    Evening run;
    const std::vector<uint8_t> good = saved_after_three_seconds(run);
    bool named = false;  // one of the bytes is the state of an agent
    for (size_t at = 28; at < good.size() && !named; ++at)
        for (const uint8_t state : {0, 1, 2, 3}) {
            std::vector<uint8_t> bytes = good;
            bytes[at] = state;
            give_hash_that_fits(bytes);
            if (clq_stage_restore(run.world.stage, run.world.arm.crowd, bytes.data(), bytes.size()) != CLQ_FORMAT)
                continue;
            named |= std::string(clq_last_error()).find("states that do not hold each other") != std::string::npos;
        }
    EXPECT_TRUE(named);
}

// What is accepted runs on and can be saved.
TEST(SavedStage, SurvivesAnyBytes)
{
    Evening run;
    const std::vector<uint8_t> good = saved_after_three_seconds(run);
    uint64_t state = 3;
    const auto random = [&](size_t below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<size_t>((state >> 33) % below);
    };
    int accepted = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<uint8_t> bytes = good;
        for (size_t k = 0; k <= random(3); ++k) {
            static constexpr uint8_t values[] = {0, 1, 2, 7, 0x7f, 0x80, 0xff};
            bytes[28 + random(bytes.size() - 28)] = values[random(7)];
        }
        give_hash_that_fits(bytes);
        const clq_status status = clq_stage_restore(run.world.stage, run.world.arm.crowd, bytes.data(), bytes.size());
        EXPECT_TRUE(status == CLQ_OK || status == CLQ_FORMAT || status == CLQ_ARGUMENT) << clq_last_error();
        if (status != CLQ_OK) continue;
        ++accepted;
        const double decided_s = clq_stage_get_decided_s(run.world.stage);
        EXPECT_EQ(clq_stage_step(run.world.stage, decided_s + 0.5), CLQ_OK) << clq_last_error();
        clq_stage_apply(run.world.stage, run.world.arm.crowd, decided_s, nullptr);
        run.saved();
    }
    EXPECT_GT(accepted, 40);
    EXPECT_EQ(clq_stage_restore(run.world.stage, run.world.arm.crowd, good.data(), good.size()), CLQ_OK);
    run.world.step(4);
}

}  // namespace
