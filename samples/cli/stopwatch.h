// Times in milliseconds: of the wall, or of the processors that all threads of this process had, GL's included. On a
// machine that others use too the second says what work costs, the first how long it took.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace cli
{

class Stopwatch
{
public:
    enum class Clock { wall, processor };

    Stopwatch() = default;  // the clock of use()
    explicit Stopwatch(Clock clock) : clock_(clock) {}

    // For all stopwatches that are made from now on without a clock of their own. To be called before other threads
    // make any.
    static void use(Clock clock) { chosen_ = clock; }

    double ms() const { return now(clock_) - start_; }

private:
    static double now(Clock clock)
    {
        if (clock == Clock::wall)
            return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
                .count();
        timespec time = {};
        ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }

    static inline Clock chosen_ = Clock::wall;
    Clock clock_ = chosen_;
    double start_ = now(clock_);
};

// Measurements of repeated runs: the minimum shows what the machine can do, the median what a user sees.
struct Times {
    std::vector<double> ms;

    double minimum() const { return ms.empty() ? 0 : *std::min_element(ms.begin(), ms.end()); }
    double median() const
    {
        if (ms.empty()) return 0;
        std::vector<double> sorted = ms;
        std::sort(sorted.begin(), sorted.end());
        const size_t middle = sorted.size() / 2;
        return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }
};

}  // namespace cli
