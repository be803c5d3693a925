// How the stage finds its neighbours: the grid of its own against a clq_scene, which needs a second crowd with an actor
// for each agent, as decisions are ahead of what is shown. A step: a tenth of the agents has moved, 2000 count those of
// a class within 3 m, and 2000 look for the nearest one of a class. Both have to find the same.
#include <claque/scene.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "lib/stage/agents/neighbours.h"
#include "tests/api/small_template.h"
#include "tests/bench/measure.h"

namespace
{

using namespace claque;

constexpr uint32_t asking = 2000, classes = 4, most_found = 50;
constexpr double radius_m = 3, area_m2 = 4;  // of each agent

void must(clq_status status)
{
    if (status != CLQ_OK) std::abort();
}

struct Answer {
    uint64_t within = 0, nearest = 0;  // sums over those that ask
};

// The places of all people: the same for both.
class Agents
{
public:
    explicit Agents(uint32_t count) : count_(count), side_m_(std::sqrt(area_m2 * count)), places_(3 * size_t(count))
    {
        for (uint32_t i = 0; i < count; ++i) move(i, 1);
    }
    uint32_t count() const { return count_; }
    const double *place(uint32_t i) const { return places_.data() + 3 * size_t(i); }
    uint32_t asker(uint32_t i) const { return static_cast<uint32_t>(uint64_t(i) * count_ / asking); }
    // Those that move in a step.
    template <class Moved>
    void step(const Moved &moved)
    {
        for (uint32_t i = ++steps_ % 10; i < count_; i += 10) move(i, 0.001), moved(i);
    }

private:
    double number()
    {
        return double((state_ = state_ * 6364136223846793005u + 1442695040888963407u) >> 11) / 9007199254740992.0;
    }
    void move(uint32_t i, double share)
    {
        for (const size_t axis : {size_t(0), size_t(2)}) {
            double &x = places_[3 * size_t(i) + axis];
            x = std::fmod(x + share * side_m_ * number(), side_m_);
        }
    }

    uint32_t count_, steps_ = 0;
    double side_m_;
    uint64_t state_ = 1;
    std::vector<double> places_;
};

class OwnGrid
{
public:
    explicit OwnGrid(const Agents &agents) : agents_(agents), grid_(1)
    {
        for (uint32_t i = 0; i < agents.count(); ++i) moved(i);
    }
    void moved(uint32_t i) { grid_.place(i, i % classes, agents_.place(i)); }
    Answer ask()
    {
        Answer sum;
        for (uint32_t k = 0; k < asking; ++k) {
            const uint32_t i = agents_.asker(k);
            grid_.within(agents_.place(i), radius_m, k % classes, found_);
            sum.within += found_.size();
            sum.nearest += grid_.nearest(agents_.place(i), k % classes, i).agent;
        }
        return sum;
    }

private:
    const Agents &agents_;
    stage::Neighbours grid_;
    std::vector<stage::Neighbours::Found> found_;
};

class SecondCrowd
{
public:
    explicit SecondCrowd(const Agents &agents) : agents_(agents), hits_(most_found)
    {
        must(clq_context_create(nullptr, &context_));
        must(clq_template_build(context_, &small_.def, &tmpl_));
        must(clq_crowd_create(context_, nullptr, &crowd_));
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        actors_.resize(agents.count());
        for (uint32_t i = 0; i < agents.count(); ++i) {
            std::copy(agents.place(i), agents.place(i) + 3, def.transform.position);
            must(clq_actor_create(crowd_, &def, &actors_[i]));
        }
        must(clq_scene_create(crowd_, &scene_));
        for (uint32_t i = 0; i < agents.count(); ++i)
            must(clq_scene_set_categories(scene_, &actors_[i], 1, uint64_t(1) << i % classes));
    }
    ~SecondCrowd()
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        must(clq_context_destroy(context_));
    }
    SecondCrowd(const SecondCrowd &) = delete;
    SecondCrowd &operator=(const SecondCrowd &) = delete;

    void moved(uint32_t i)
    {
        clq_transform to = clq_transform_init();
        std::copy(agents_.place(i), agents_.place(i) + 3, to.position);
        moved_.push_back(actors_[i]), to_.push_back(to);
    }
    Answer ask()
    {
        must(clq_crowd_set_transforms(crowd_, moved_.data(), to_.data(), static_cast<uint32_t>(moved_.size())));
        moved_.clear(), to_.clear();
        must(clq_crowd_update(crowd_, time_s_ += 0.05, nullptr, 0));  // in which a scene takes changes over
        Answer sum;
        clq_scene_filter filter = clq_scene_filter_init();
        for (uint32_t k = 0; k < asking; ++k) {
            const uint32_t i = agents_.asker(k);
            uint32_t count = 0;
            filter.any_of = uint64_t(1) << k % classes;
            must(clq_scene_find_within(scene_, time_s_, agents_.place(i), radius_m, &filter, hits_.data(), most_found,
                                       &count));
            sum.within += count;
            must(clq_scene_find_nearest(scene_, time_s_, agents_.place(i), stage::Neighbours::reach_m, &filter,
                                        hits_.data(), 2, &count));
            const uint32_t other = hits_[0].actor.index1 == actors_[i].index1 && count > 1;
            sum.nearest += hits_[other].actor.index1 - 1;
        }
        return sum;
    }

private:
    const Agents &agents_;
    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_scene *scene_ = nullptr;
    std::vector<clq_actor> actors_, moved_;
    std::vector<clq_transform> to_;
    std::vector<clq_scene_hit> hits_;
    double time_s_ = 0;
};

template <class Index>
void step_of(benchmark::State &state)
{
    Agents agents(static_cast<uint32_t>(state.range(0)));
    Index index(agents);
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        agents.step([&](uint32_t i) { index.moved(i); });
        benchmark::DoNotOptimize(index.ask());
    }
    state.counters["shortest_ms"] = shortest.ns() / 1e6;
}

void same_answers(benchmark::State &state)
{
    for (auto _ : state) {
        Agents first(1000), second(1000);
        OwnGrid grid(first);
        SecondCrowd crowd(second);
        for (int i = 0; i < 5; ++i) {
            first.step([&](uint32_t k) { grid.moved(k); });
            second.step([&](uint32_t k) { crowd.moved(k); });
            const Answer a = grid.ask(), b = crowd.ask();
            if (a.within != b.within || a.nearest != b.nearest) {
                std::fprintf(stderr, "the grid finds %llu and the scene %llu within %g m\n",
                             static_cast<unsigned long long>(a.within), static_cast<unsigned long long>(b.within),
                             radius_m);
                std::abort();
            }
        }
    }
}

BENCHMARK(same_answers)->Iterations(1);
BENCHMARK_TEMPLATE(step_of, OwnGrid)->Arg(1000)->Arg(10000)->Iterations(20)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(step_of, SecondCrowd)->Arg(1000)->Arg(10000)->Iterations(20)->Unit(benchmark::kMillisecond);

}  // namespace
