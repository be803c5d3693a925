// The two flows of a run: decisions in a thread of their own, ahead of the time shown, or in turn with the drawing.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <thread>

#include "samples/stage/run.h"

namespace staged
{

class Flows
{
public:
    // `live`: reach() waits for no decision that another thread makes.
    Flows(Run &run, bool apart, bool live);
    ~Flows();
    Flows(const Flows &) = delete;
    Flows &operator=(const Flows &) = delete;

    // Returns when a time that will be shown is decided. From then on decisions may run up to the lead ahead of it.
    // Throws what a decision threw.
    void reach(double time_s);
    // By how much less than the lead decisions are ahead of the time reached.
    double behind_s() const;
    // How long decisions kept the last reach() from returning.
    double kept_s() const { return kept_s_; }
    // Waits until decisions are the lead ahead of the time reached, where they rest.
    void rest();
    // After rest() and a change of the run's time by the caller.
    void begin_again();

private:
    void work();
    void wait_for(double time_s);
    bool is_ahead(double time_s) const;

    Run &run_;
    const bool apart_, live_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<double> shown_s_{-1};  // the latest time that reach() got
    std::atomic<double> next_end_s_;   // of the tick that comes next
    std::atomic<bool> failed_{false};
    double kept_s_ = 0;
    bool ends_ = false;
    std::exception_ptr failure_;
    std::thread thread_;  // the last one: it uses all above
};

}  // namespace staged
