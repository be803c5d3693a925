// What a second core gains: the same work on one thread and on two, alternating. Wall time, the shortest of each;
// `ratio` is how many times longer one thread takes. `skinning_alone` shares nothing but the machine, so no update can
// gain more than it does; where two threads share one core it is far from 2.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "lib/skin/skin.h"
#include "tests/bench/crowd_scene.h"
#include "tests/bench/measure.h"

namespace
{

using namespace claque;

// The calling thread and one more, which take the tasks as they come. The other sleeps between updates; within one it
// spins, as thread pools do, because an update's loops are microseconds apart.
class TwoThreads
{
public:
    TwoThreads() : other_([this] { serve(); }) {}
    ~TwoThreads()
    {
        round_ = ends;
        wake();
        other_.join();
    }
    clq_tasks tasks() { return {this, run}; }

private:
    using Job = void (*)(void *, uint32_t);
    static constexpr uint32_t ends = ~0u;

    static void run(void *user, uint32_t count, Job job, void *data)
    {
        TwoThreads &self = *static_cast<TwoThreads *>(user);
        self.job_ = job, self.data_ = data, self.count_ = count, self.next_ = 0;
        const uint32_t round = ++self.round_;
        self.wake();
        self.work();
        while (self.done_ != round) std::this_thread::yield();
    }
    void work()
    {
        for (uint32_t i = next_++; i < count_; i = next_++) job_(data_, i);
    }
    void wake()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        changed_.notify_one();
    }
    void serve()
    {
        uint32_t seen = 0;
        while (true) {
            for (int i = 0; i < 100000 && round_ == seen; ++i) benchmark::DoNotOptimize(i);
            if (round_ == seen) {
                std::unique_lock<std::mutex> lock(mutex_);
                changed_.wait(lock, [&] { return round_ != seen; });
            }
            seen = round_;
            if (seen == ends) return;
            work();
            done_ = seen;
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    Job job_ = nullptr;
    void *data_ = nullptr;
    uint32_t count_ = 0;
    std::atomic<uint32_t> next_{0}, round_{0}, done_{0};
    std::thread other_;
};

double wall_ms(const std::chrono::steady_clock::time_point &start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Alternates body(jobs) on one thread and on two.
template <class Body>
void compare(benchmark::State &state, const Body &body)
{
    TwoThreads threads;
    const base::Jobs one, two(threads.tasks());
    double one_ms = 1e300, two_ms = 1e300;
    for (auto _ : state) {
        auto start = std::chrono::steady_clock::now();
        body(one);
        one_ms = std::min(one_ms, wall_ms(start));
        start = std::chrono::steady_clock::now();
        body(two);
        two_ms = std::min(two_ms, wall_ms(start));
    }
    state.counters["one_ms"] = one_ms;
    state.counters["two_ms"] = two_ms;
    state.counters["ratio"] = one_ms / two_ms;
}

void two_threads(benchmark::State &state, animcache::VertexFormat vertex_format)
{
    bench::AllDue scene(uint32_t(state.range(0)), vertex_format);
    double t = 0;
    compare(state, [&](const base::Jobs &jobs) { scene.update(t += 0.0167, jobs); });
}

// 64 tasks, each of which skins its own body again and again.
void skinning_alone(benchmark::State &state)
{
    constexpr uint32_t task_count = 64, turns = 16;
    const model::Level level = bench::make_level(2);
    const std::vector<math::Affine> palette(bench::joint_count + 1);
    const size_t scratch_floats = skin::scratch_floats(level, bench::joint_count, skin::Normals::by_palette);
    std::vector<std::vector<float>> scratch(task_count, std::vector<float>(scratch_floats));
    std::vector<std::vector<float>> out(task_count, std::vector<float>(6 * bench::vertex_count));
    compare(state, [&](const base::Jobs &jobs) {
        jobs.for_each(task_count, [&](uint32_t task) {
            skin::SkinJob job;
            job.level = &level;
            job.palette = {palette.data(), bench::joint_count};
            job.scratch = base::Span<float>(scratch[task]);
            job.out_positions = {out[task].data(), 3 * bench::vertex_count};
            job.out_normals = {out[task].data() + 3 * bench::vertex_count, 3 * bench::vertex_count};
            for (uint32_t i = 0; i < turns; ++i) job.run();
        });
    });
}

BENCHMARK(skinning_alone)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_threads, floats, animcache::VertexFormat::floats)
    ->ArgName("characters")
    ->Arg(1000)
    ->Arg(20000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_threads, packed, animcache::VertexFormat::packed)
    ->ArgName("characters")
    ->Arg(1000)
    ->Arg(20000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
