#include "samples/stage/flows.h"

#include <algorithm>

namespace staged
{

Flows::Flows(Run &run, bool apart) : run_(run), apart_(apart), next_end_s_(run.end_of_tick())
{
    if (apart_) thread_ = std::thread([this] { work(); });
}

Flows::~Flows()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

// Whether the next tick ends beyond the lead before a time.
bool Flows::is_ahead(double time_s) const
{
    return next_end_s_ > time_s + std::max(run_.stage().lead_s, 2 * run_.stage().tick_s) + 1e-9;
}

// Up to the end of the tick in which a time lies, and the lead.
void Flows::work()
{
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ends_ || !is_ahead(shown_s_); });
        if (ends_) return;
        lock.unlock();
        try {
            run_.tick();
        } catch (...) {
            lock.lock();
            failure_ = std::current_exception();
            changed_.notify_all();
            return;
        }
        lock.lock();
        next_end_s_ = run_.end_of_tick();
        changed_.notify_all();
    }
}

void Flows::reach(double time_s)
{
    std::unique_lock<std::mutex> lock(mutex_);
    shown_s_ = std::max(shown_s_, time_s);
    if (!apart_) {
        while (!is_ahead(shown_s_)) run_.tick(), next_end_s_ = run_.end_of_tick();
        return;
    }
    changed_.notify_all();
    // Also the tick behind it, which may begin with people that appear at this time.
    changed_.wait(lock, [&] { return failure_ || next_end_s_ >= time_s + 2 * run_.stage().tick_s - 1e-9; });
    if (failure_) std::rethrow_exception(failure_);
}

void Flows::rest()
{
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || !apart_ || is_ahead(shown_s_); });
    if (failure_) std::rethrow_exception(failure_);
}

void Flows::begin_again()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    shown_s_ = -1;
    next_end_s_ = run_.end_of_tick();
    changed_.notify_all();
}

}  // namespace staged
