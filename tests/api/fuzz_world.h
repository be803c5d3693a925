// A crowd that receives random calls, and the state that a host knows of it: which ids are alive, which are stale, and
// which actors are in which group. Every number follows from a seed, or from bytes that a fuzzer chooses.
#pragma once

#include "tests/api/saved_bytes.h"
#include "tests/api/stub_gl.h"
#include "tests/api/test_world.h"

namespace fuzz
{

// Bytes to be taken one after another, in place of random numbers.
struct Choices {
    const uint8_t *bytes = nullptr;
    size_t size = 0;
};

// A series of random numbers: the choices as long as there are any, then what follows from the seed.
class Random
{
public:
    explicit Random(uint64_t seed, const Choices &choices = {}) : seed_(seed), choices_(choices) {}
    uint64_t number() { return choices_.size ? taken(2) : mixed(seed_, ++drawn_); }
    uint32_t below(uint32_t n)
    {
        if (choices_.size) return taken(n <= 0x100 ? 1 : n <= 0x10000 ? 2 : 3) % n;
        return static_cast<uint32_t>(number() >> 20) % n;
    }
    size_t choices_left() const { return choices_.size; }
    bool one_in(uint32_t n) { return below(n) == 0; }
    double in(double low, double high) { return low + (high - low) * below(100001) / 100000; }
    // Mostly a value in between; once in `rare` one that no sensible host passes.
    double odd(double low, double high, uint32_t rare = 30);
    float oddf(double low, double high, uint32_t rare = 30) { return static_cast<float>(odd(low, high, rare)); }
    uint32_t index(uint32_t n, uint32_t rare = 20);  // below n; once in `rare` n or far beyond

private:
    uint32_t taken(size_t bytes)
    {
        uint32_t out = 0;
        for (; bytes > 0 && choices_.size > 0; --bytes, --choices_.size) out = out << 8 | *choices_.bytes++;
        return out;
    }
    uint64_t seed_, drawn_ = 0;
    Choices choices_;
};

struct Options {
    uint32_t steps = 2000;
    Choices choices;  // if there are any, the run ends with them
    const clq_context_def *context = nullptr;
    bool records = false;  // the run is recorded, and played back at its end
    // Called round every call, to make memory fail. A call that fails then must leave the crowd unchanged, like any
    // other.
    void (*before)(uint64_t bits) = nullptr;
    void (*after)() = nullptr;
};

// The known ids of one state.
struct Known {
    struct Actor {
        clq_actor id;
        clq_group group;
        const clq_template *tmpl;
    };
    std::vector<Actor> actors;
    std::vector<clq_actor> gone;
    std::vector<clq_group> groups, gone_groups;
    std::vector<clq_attachment> objects;  // may be gone with their actors
    uint32_t mechanisms = 0, paths = 0;
};

class World
{
public:
    World(uint64_t seed, const Options &options);
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    void run();
    uint32_t good() const { return good_; }
    uint32_t bad() const { return bad_; }
    uint32_t drawn() const { return drawn_; }  // individuals
    uint32_t picked() const { return picked_; }
    // Of all updates: poses that a budget let wait, actors that showed key-poses, individuals in packed vertices.
    uint32_t deferred() const { return deferred_; }
    uint32_t key_posed() const { return key_posed_; }
    uint32_t packed() const { return packed_; }

private:
    using Step = void (World::*)();

    // Makes a call and checks the rules of all calls.
    template <class Body>
    bool call(const char *name, const Body &body)
    {
        const uint64_t print = clq_crowd_get_hash(crowd_);
        if (options_.before) options_.before(random_.number());
        const clq_status status = body();
        if (options_.after) options_.after();
        judge(name, status, print);
        return status == CLQ_OK;
    }
    void judge(const char *name, clq_status status, uint64_t print_before);
    void check();

    // fuzz_actors.cpp: actors, objects and groups
    void create();
    void destroy();
    void clone();
    void place();
    void play();
    void colours();
    void priority();
    void attach();
    void detach();
    void hooks();
    void new_group();
    void end_group();
    void move_group();
    void join();

    // fuzz_behaviour.cpp
    void add_mechanism();
    void add_path();
    void attach_mechanism();
    void detach_mechanism();
    void command();
    void ground();
    void move_root();

    // fuzz_play.cpp
    void describe_play();
    void blend();
    void watch();
    void follow();

    // fuzz_seeing.cpp: views, updates, queries, states
    void new_view();
    void end_view();
    void look();
    void update();
    void expect_kept_budgets();
    void expect_format(const clq_view *view, uint32_t visible);
    void ask();
    void save();
    void restore();
    void nonsense();

    // fuzz_record.cpp
    void record();
    void replay();

    // fuzz_drawing.cpp
    void draw();
    void draw_shadows();
    void draw_visibility();
    void ask_list();

    // fuzz_scene.cpp
    void new_scene();
    void end_scene();
    void tell_scene();
    void ask_scene();
    void ask_places();
    clq_scene_filter any_filter();

    clq_actor person();  // mostly a live actor
    clq_group any_group();
    clq_mechanism any_mechanism() { return {random_.one_in(20) ? 0 : 1 + random_.index(known_.mechanisms + 1)}; }
    clq_transform any_place();
    clq_dof_pose any_shape();
    void new_renderer();
    void live(clq_crowd_def &def);
    clq_key_poses any_key_poses();
    void leave(clq_group group);

    uint32_t gaits_ = 0, masks_ = 0;
    Options options_;
    Random random_;
    TestWorld test_world_;
    SmallTemplate far_def_, rigid_def_;
    clq_part_def far_parts_[2];
    clq_template *templates_[4] = {nullptr, nullptr, nullptr, nullptr};
    clq_crowd *crowd_ = nullptr, *stranger_ = nullptr;
    clq_view *strange_view_ = nullptr;
    clq_renderer *renderer_ = nullptr;
    std::vector<clq_view *> views_;
    std::vector<clq_scene *> scenes_;
    Known known_, known_then_;
    saved::Bytes bytes_;  // of the state of known_then_
    saved::Bytes recorded_;
    std::vector<uint64_t> step_hashes_;  // of the recorded crowd, at each update
    clq_dof_value values_[64];
    uint32_t used_values_ = 0;
    double time_s_ = 0, now_s_ = 0;
    uint64_t key_pose_bytes_ = 0;
    uint32_t update_budget_ = 0;  // 0: none
    bool is_packed_ = false;
    uint32_t good_ = 0, bad_ = 0, drawn_ = 0, picked_ = 0, deferred_ = 0, key_posed_ = 0, packed_ = 0, step_ = 0;
    uint64_t seed_;
};

}  // namespace fuzz
