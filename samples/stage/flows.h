// The two flows of a run: decisions in a thread of their own, ahead of the time shown, or in turn with the drawing.
#pragma once

#include <condition_variable>
#include <exception>
#include <thread>

#include "samples/stage/run.h"

namespace staged
{

class Flows
{
public:
    Flows(Run &run, bool apart);
    ~Flows();
    Flows(const Flows &) = delete;
    Flows &operator=(const Flows &) = delete;

    // Returns when a time that will be shown is decided. From then on decisions may run up to the lead ahead of it.
    // Throws what a decision threw.
    void reach(double time_s);
    // Waits until decisions are the lead ahead of the time reached, where they rest.
    void rest();
    // After rest() and a change of the run's time by the caller.
    void begin_again();

private:
    void work();
    bool is_ahead(double time_s) const;

    Run &run_;
    const bool apart_;
    std::mutex mutex_;
    std::condition_variable changed_;
    double shown_s_ = -1;  // the latest time that reach() got
    double next_end_s_;    // of the tick that comes next
    bool ends_ = false;
    std::exception_ptr failure_;
    std::thread thread_;  // the last one: it uses all above
};

}  // namespace staged
