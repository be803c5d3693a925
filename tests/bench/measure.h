// What every benchmark reports beside its time: nanoseconds of processor time per unit, and `ratio`: how many times
// longer the textbook's way takes for the same work in the same run. Both are of the shortest iteration.
#pragma once

#include <algorithm>
#include <ctime>

#include <benchmark/benchmark.h>

#include "lib/math/simd_level.h"

namespace claque::bench
{

inline double cpu_ns()
{
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

// The shortest of all iterations, so that other load on the machine counts as little as possible.
class Shortest
{
public:
    // Measures one iteration; its lifetime is the iteration's work.
    class Lap
    {
    public:
        explicit Lap(Shortest &of) : of_(of), start_(cpu_ns()) {}
        Lap(const Lap &) = delete;
        Lap &operator=(const Lap &) = delete;
        ~Lap() { of_.ns_ = std::min(of_.ns_, cpu_ns() - start_); }

    private:
        Shortest &of_;
        double start_;
    };
    double ns() const { return ns_; }

private:
    double ns_ = 1e300;
};

// The shortest of several runs of body(), after one that warms up.
template <class Body>
double shortest_ns(int runs, const Body &body)
{
    body();
    Shortest shortest;
    for (int i = 0; i < runs; ++i) {
        const Shortest::Lap lap(shortest);
        body();
        benchmark::ClobberMemory();
    }
    return shortest.ns();
}

// `things`: units of work per iteration; name: "ns/vertex" and the like. textbook_ns: per unit; 0: no comparison.
inline void report(benchmark::State &state, const Shortest &shortest, const char *name, double things,
                   double textbook_ns)
{
    state.counters[name] = shortest.ns() / things;
    if (textbook_ns > 0) state.counters["ratio"] = textbook_ns * things / shortest.ns();
}

inline bool can_run(benchmark::State &state, math::SimdLevel simd_level)
{
    if (math::can_run(simd_level)) return true;
    state.SkipWithError("this processor cannot run it");
    return false;
}

}  // namespace claque::bench
