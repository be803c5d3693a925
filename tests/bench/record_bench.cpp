// What recording costs: frames of a host that moves a thousand people, with and without a record, and the same without
// anything to see; and seeking in what was recorded.
#include <claque/assets.h>
#include <claque/claque.h>

#include <cstdlib>
#include <vector>

#include <benchmark/benchmark.h>

namespace
{

constexpr uint32_t people = 1000, plays_a_frame = 20;

void require(clq_status status)
{
    if (status != CLQ_OK) std::abort();
}

struct Host {
    Host()
    {
        require(clq_context_create(nullptr, &context));
        require(clq_template_builtin(context, "citizen", &citizen));
        require(clq_crowd_create(context, nullptr, &crowd));
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen;
        for (uint32_t i = 0; i < people; ++i) {
            def.seed = i, def.transform.position[0] = i % 40, def.transform.position[2] = -double(i / 40);
            clq_actor made;
            require(clq_actor_create(crowd, &def, &made));
            actors.push_back(made), places.push_back(def.transform);
        }
        require(clq_view_create(crowd, &view));
        clq_look_at_def look = clq_look_at_def_init();
        look.eye[0] = 20, look.eye[1] = 4, look.eye[2] = 10, look.target[0] = 20, look.target[2] = -10;
        clq_camera camera;
        require(clq_camera_look_at(&look, &camera));
        require(clq_view_set_camera(view, &camera));
    }
    ~Host()
    {
        clq_crowd_destroy(crowd);
        clq_template_destroy(citizen);
        clq_context_destroy(context);
    }
    void record(bool keeps)
    {
        clq_recording_def def = clq_recording_def_init();
        def.user = keeps ? &bytes : nullptr;
        def.write = [](void *user, const void *from, size_t size) {
            if (!user) return 0;
            auto &to = *static_cast<std::vector<char> *>(user);
            to.insert(to.end(), static_cast<const char *>(from), static_cast<const char *>(from) + size);
            return 0;
        };
        require(clq_crowd_begin_recording(crowd, &def));
    }
    void calls(uint32_t frame)
    {
        for (clq_transform &place : places) place.position[2] += 0.001;
        require(clq_crowd_set_transforms(crowd, actors.data(), places.data(), people));
        clq_play play = clq_play_init();
        play.clip = 0, play.start_s = frame;
        for (uint32_t k = 0; k < plays_a_frame; ++k)
            require(clq_actor_play(crowd, actors[(frame * plays_a_frame + k) % people], &play));
    }
    clq_context *context = nullptr;
    clq_template *citizen = nullptr;
    clq_crowd *crowd = nullptr;
    clq_view *view = nullptr;
    std::vector<clq_actor> actors;
    std::vector<clq_transform> places;
    std::vector<char> bytes;
};

// range(0): it is recorded; range(1): a view sees it.
void frames(benchmark::State &state)
{
    Host host;
    if (state.range(0)) host.record(false);
    uint32_t frame = 0;
    for (auto _ : state) {
        host.calls(frame);
        require(clq_crowd_update(host.crowd, 0.04 * frame++, &host.view, state.range(1) ? 1 : 0));
    }
    if (!state.range(0)) return;
    clq_recording_info info = clq_recording_info_init();
    require(clq_crowd_get_recording(host.crowd, &info));
    state.counters["bytes/frame"] = double(info.bytes) / double(info.steps);
    state.counters["key states"] = double(info.key_states);
}
BENCHMARK(frames)->ArgNames({"recorded", "seen"})->ArgsProduct({{0, 1}, {0, 1}})->Unit(benchmark::kMicrosecond);

// range(0): steps of the record, which the time must not depend on.
void seeks(benchmark::State &state)
{
    Host host;
    host.record(true);
    for (uint32_t frame = 0; frame < state.range(0); ++frame) {
        host.calls(frame);
        require(clq_crowd_update(host.crowd, 0.04 * frame, nullptr, 0));
    }
    require(clq_crowd_end_recording(host.crowd, nullptr));
    clq_record *record = nullptr;
    require(clq_record_load(host.context, host.bytes.data(), host.bytes.size(), &record));
    require(clq_record_set_templates(record, &host.citizen, 1));
    uint64_t at = 0;
    for (auto _ : state) {
        at = (at + uint64_t(state.range(0)) * 5 / 8 + 7) % uint64_t(state.range(0));
        require(clq_record_play_step(record, host.crowd, at));
    }
    state.counters["MB"] = double(host.bytes.size()) / 1e6;
    clq_record_destroy(record);
}
BENCHMARK(seeks)->ArgName("steps")->Arg(100)->Arg(1000)->Arg(5000)->Unit(benchmark::kMicrosecond);

}  // namespace
