// Flows together and apart, on one thread or several: the same commands and the same crowd, bit for bit. Run under
// ThreadSanitizer as well.
#include <atomic>
#include <thread>

#include "tests/unit/stage/stage_world.h"

namespace
{

const char *const people = R"toml(
machine = "people"
[variables]
n = 0.0
[crowd]
mood = 0.0
[events]
startle = 0
nudge = 2
[states.calm]
initial = true
transitions = [ { on = "startle", to = "startled", do = [ { set = "crowd.mood", to = "crowd.mood + 1" } ] } ]
[states.calm.states.rests]
initial = true
enter = [ { play = ["slow", "fast"], speed = [0.8, 1.3], fade = 0.3 } ]
transitions = [ { on = "nudge", if = "random(0, 1) < 0.4", to = "waves" }, { after = [1, 3], to = "waves" } ]
[states.calm.states.waves]
enter = [ { gesture = "wave" }, { send = "nudge", radius = 2.5, delay = [0.1, 0.4] } ]
transitions = [ { end = true, before = 0.3, to = "rests" } ]
[states.startled]
enter = [ { play = "bent", fade = 0.1 }, { call = "note" } ]
transitions = [ { after = 0.9, to = "calm", history = "deep" }, { if = "crowd.mood > 200", to = "calm" } ]
)toml";

constexpr double length_s = 12, frame_s = 1.0 / 30, lead_s = 1;
constexpr int people_count = 120;

struct Result {
    uint64_t commands = 0, crowd = 0, frames = 0;
    bool operator==(const Result &other) const
    {
        return commands == other.commands && crowd == other.crowd && frames == other.frames;
    }
};

void run_jobs(void *user, uint32_t count, void (*job)(void *, uint32_t), void *data)
{
    const uint32_t threads = *static_cast<const uint32_t *>(user);
    std::atomic<uint32_t> next{0};
    const auto work = [&] {
        for (uint32_t i = next++; i < count; i = next++) job(data, i);
    };
    std::vector<std::thread> others;
    for (uint32_t i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread &other : others) other.join();
}

class Theatre
{
public:
    // threads: of the crowd's updates.
    explicit Theatre(uint32_t threads) : threads_(threads), base_()
    {
        clq_context_def context_def = clq_context_def_init();
        context_def.tasks.run = run_jobs, context_def.tasks.user = &threads_;
        EXPECT_EQ(clq_context_create(&context_def, &context_), CLQ_OK);
        clq_crowd_def crowd_def = clq_crowd_def_init();
        EXPECT_EQ(clq_crowd_create(context_, &crowd_def, &crowd_), CLQ_OK);
        std::vector<uint8_t> bytes;
        EXPECT_EQ(clq_template_save(base_.tmpl, take, &bytes), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_template_load(context_, bytes.data(), bytes.size(), &tmpl_), CLQ_OK) << clq_last_error();
        clq_stage_def def = clq_stage_def_init();
        def.seed = 4, def.budget = 30;
        EXPECT_EQ(clq_stage_create(context_, &def, &stage), CLQ_OK);
        fill();
    }
    ~Theatre()
    {
        clq_stage_destroy(stage);
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }
    Theatre(const Theatre &) = delete;
    Theatre &operator=(const Theatre &) = delete;

    void decide(double until_s) { EXPECT_EQ(clq_stage_step(stage, until_s), CLQ_OK) << clq_last_error(); }
    void draw(double time_s)
    {
        EXPECT_EQ(clq_stage_apply(stage, crowd_, time_s, nullptr), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK) << clq_last_error();
        result_.frames = result_.frames * 31 + clq_view_get_hash(view_);
    }
    // The script: two things at a time, sent before it is decided.
    void send(int number) const
    {
        clq_stage_event event = clq_stage_event_init();
        event.name = number % 3 ? "nudge" : "startle";
        event.at_s = 0.5 + 0.73 * (number / 2), event.position[0] = 5.0 * (number % 20);
        event.radius_m = 9, event.delay_s_per_m = 0.05f;
        EXPECT_EQ(clq_stage_send(stage, &event), CLQ_OK) << clq_last_error();
    }
    Result result()
    {
        clq_stage_info info = clq_stage_info_init();
        EXPECT_EQ(clq_stage_get_info(stage, &info), CLQ_OK);
        EXPECT_EQ(info.late_messages, 0u);
        EXPECT_GT(info.transitions, 500u);
        result_.commands = info.hash;
        result_.crowd = clq_crowd_get_hash(crowd_);
        return result_;
    }
    static constexpr int script_length = 30;
    clq_stage *stage = nullptr;

private:
    static int take(void *user, const void *bytes, size_t size)
    {
        auto &out = *static_cast<std::vector<uint8_t> *>(user);
        out.insert(out.end(), static_cast<const uint8_t *>(bytes), static_cast<const uint8_t *>(bytes) + size);
        return 0;
    }
    static void note(void *, const clq_action_call *call) { EXPECT_NE(call->actor.index1, 0u); }

    void fill()
    {
        clq_action_def action = clq_action_def_init();
        action.name = "note", action.show = note;
        EXPECT_EQ(clq_stage_add_action(stage, &action), CLQ_OK);
        clq_machine_def machine_def = clq_machine_def_init();
        machine_def.source.text = people, machine_def.source.text_bytes = std::string(people).size();
        machine_def.template_count = 1, machine_def.templates = &tmpl_;
        clq_agent_def agent = clq_agent_def_init();
        EXPECT_EQ(clq_stage_add_machine(stage, &machine_def, &agent.machine), CLQ_OK) << clq_last_error();
        agent.tmpl = tmpl_;
        clq_actor_def actor = clq_actor_def_init();
        actor.tmpl = tmpl_;
        for (int i = 0; i < people_count; ++i) {
            actor.transform.position[0] = agent.position[0] = 0.8 * i;
            actor.seed = agent.seed = uint64_t(i);
            EXPECT_EQ(clq_actor_create(crowd_, &actor, &agent.actor), CLQ_OK);
            clq_agent made{};
            EXPECT_EQ(clq_stage_add_agent(stage, &agent, &made), CLQ_OK) << clq_last_error();
        }
        EXPECT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_look_at_def look = clq_look_at_def_init();
        look.eye[0] = 48, look.eye[2] = 40, look.target[0] = 48;
        clq_camera camera{};
        EXPECT_EQ(clq_camera_look_at(&look, &camera), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    }

    uint32_t threads_;
    Arm base_;
    clq_context *context_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_view *view_ = nullptr;
    Result result_;
};

// All in turn on one thread.
Result together(uint32_t threads, double step_s)
{
    Theatre theatre(threads);
    for (int i = 0; i < Theatre::script_length; ++i) theatre.send(i);
    double decided_s = 0;
    for (int frame = 0; frame * frame_s < length_s; ++frame) {
        for (; decided_s < frame * frame_s + lead_s; decided_s += step_s) theatre.decide(decided_s);
        theatre.draw(frame * frame_s);
    }
    theatre.decide(length_s + lead_s);
    return theatre.result();
}

// Decisions, drawing and a script on a thread each. Drawing waits where it would show what is not decided.
Result apart(uint32_t threads)
{
    Theatre theatre(threads);
    std::atomic<int> sent{0};
    std::atomic<double> shown_s{0};
    std::thread script([&] {
        for (int i = 0; i < Theatre::script_length; ++i) {
            theatre.send(Theatre::script_length - 1 - i);
            if (i % 2) std::this_thread::yield();
        }
        sent = 1;
    });
    std::thread decisions([&] {
        while (!sent) std::this_thread::yield();
        for (double until_s = 0; until_s <= length_s + lead_s; until_s += 0.11) {
            while (until_s > shown_s.load() + lead_s + 0.2) std::this_thread::yield();
            theatre.decide(until_s);
        }
        theatre.decide(length_s + lead_s);
    });
    for (int frame = 0; frame * frame_s < length_s; ++frame) {
        while (clq_stage_get_decided_s(theatre.stage) < frame * frame_s) std::this_thread::yield();
        theatre.draw(frame * frame_s);
        shown_s = frame * frame_s;
        clq_stage_info info = clq_stage_info_init();
        EXPECT_EQ(clq_stage_get_info(theatre.stage, &info), CLQ_OK) << "any thread may ask";
    }
    shown_s = 2 * length_s;
    script.join();
    decisions.join();
    return theatre.result();
}

TEST(Flows, TogetherAndApartOnAnyThreadsGiveTheSameBits)
{
    const Result once = together(1, 0.05);
    EXPECT_EQ(together(1, 0.05), once) << "two runs";
    EXPECT_EQ(together(1, 0.33), once) << "another cut of the time into steps";
    for (const uint32_t threads : {1u, 2u, 4u}) {
        EXPECT_EQ(together(threads, 0.07), once) << threads;
        EXPECT_EQ(apart(threads), once) << threads;
    }
}

TEST(Flows, ASecondThreadInOneFlowIsRefused)
{
    struct Waits {
        std::atomic<int> stage{0};
        static void decide(void *user, const clq_action_call *)
        {
            Waits &waits = *static_cast<Waits *>(user);
            waits.stage = 1;
            while (waits.stage != 2) std::this_thread::yield();
        }
    } waits;
    StageWorld world;
    clq_action_def action = clq_action_def_init();
    action.name = "wait", action.decide = Waits::decide, action.user = &waits;
    ASSERT_EQ(clq_stage_add_action(world.stage, &action), CLQ_OK);
    world.agent(world.machine("machine = \"m\"\n[events]\ngo = 0\n[states.a]\nenter = [ { call = \"wait\" } ]\n"));
    std::thread other([&] { EXPECT_EQ(clq_stage_step(world.stage, 1), CLQ_OK); });
    while (waits.stage != 1) std::this_thread::yield();
    EXPECT_EQ(clq_stage_step(world.stage, 2), CLQ_BUSY);
    EXPECT_STREQ(clq_last_error(), "clq_stage_step: another call works in the decisions' flow of the stage");
    EXPECT_EQ(clq_stage_apply(world.stage, world.arm.crowd, 0, nullptr), CLQ_OK) << "drawing does not wait";
    world.send("go", 0.5);
    EXPECT_EQ(clq_stage_get_decided_s(world.stage), 0);
    waits.stage = 2;
    other.join();
    EXPECT_EQ(clq_stage_step(world.stage, 2), CLQ_OK);
}

}  // namespace
