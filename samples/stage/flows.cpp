#include "samples/stage/flows.h"

#include <algorithm>
#include <chrono>

namespace staged
{

Flows::Flows(Run &run, bool apart, bool live) : run_(run), apart_(apart), live_(live), next_end_s_(run.end_of_tick())
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
        // Live frames tell the time without the lock, so a call may go unheard.
        constexpr auto moment = std::chrono::milliseconds(2);
        const auto has_work = [&] { return ends_ || !is_ahead(shown_s_); };
        while (!has_work()) {
            if (live_) changed_.wait_for(lock, moment);
            else changed_.wait(lock);
        }
        if (ends_) return;
        lock.unlock();
        try {
            run_.tick();
        } catch (...) {
            lock.lock();
            failure_ = std::current_exception();
            failed_ = true;
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
    const auto now = [] { return std::chrono::steady_clock::now(); };
    const auto began = now();
    wait_for(time_s);
    kept_s_ = std::chrono::duration<double>(now() - began).count();
}

void Flows::wait_for(double time_s)
{
    if (apart_ && live_ && !failed_) {  // no lock: the thread that holds it might have lost its core
        shown_s_ = std::max<double>(shown_s_, time_s);
        changed_.notify_all();
        return;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    shown_s_ = std::max<double>(shown_s_, time_s);
    if (!apart_) {
        while (!is_ahead(shown_s_)) run_.tick(), next_end_s_ = run_.end_of_tick();
        return;
    }
    changed_.notify_all();
    // Also the tick behind it, which may begin with people that appear at this time.
    changed_.wait(lock, [&] { return failure_ || next_end_s_ >= time_s + 2 * run_.stage().tick_s - 1e-9; });
    if (failure_) std::rethrow_exception(failure_);
}

double Flows::behind_s() const
{
    const double decided_s = next_end_s_ - run_.stage().tick_s;
    return std::max(0.0, shown_s_ + std::max(run_.stage().lead_s, 2 * run_.stage().tick_s) - decided_s);
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
