#include "lib/stage/schedule/scheduler.h"

#include <algorithm>
#include <cmath>

#include "lib/stage/floats.h"
#include "lib/stage/hash.h"

namespace claque::stage
{

uint64_t order_of_message(const Task &task)
{
    uint64_t h = sum(start_of_sum, (uint64_t(task.agent) << 32) + (uint64_t(task.kind) << 8) + task.has_place);
    h = sum(sum(h, (uint64_t(task.index) << 32) + task.sender), uint64_t(task.agent_class));
    h = sum(sum(sum(h, task.value), task.radius_m), task.per_m_s);
    for (const double coordinate : task.place) h = sum(h, coordinate);
    return h & ~own_order;
}

void Scheduler::reserve(size_t more)
{
    const auto grow = [](auto &vector, size_t wanted) {
        if (vector.capacity() < wanted) vector.reserve(std::max(wanted, 2 * vector.capacity()));
    };
    grow(tasks_, tasks_.size() + more);
    grow(free_, tasks_.capacity());
    grow(heap_, heap_.size() + more);
}

void Scheduler::add(Task task)
{
    task.order = next_order_++;
    put(task);
}

void Scheduler::add_message(const Task &task) { put(task); }

void Scheduler::put(const Task &task)
{
    uint32_t slot;
    if (free_.empty()) {
        slot = static_cast<uint32_t>(tasks_.size());
        tasks_.push_back(task);
    } else {
        slot = free_.back();
        free_.pop_back();
        tasks_[slot] = task;
    }
    heap_.push_back({task.due_s, task.order, slot, task.agent});
    std::push_heap(heap_.begin(), heap_.end(), Later());
}

void Scheduler::sweep(const Worker &worker)
{
    const auto is_pointless = [&](const Key &key) {
        const Task &task = tasks_[key.slot];
        if (is_of_stage(task.kind) || worker.is_alive(task)) return false;
        forget(key.slot);
        return true;
    };
    heap_.erase(std::remove_if(heap_.begin(), heap_.end(), is_pointless), heap_.end());
    std::make_heap(heap_.begin(), heap_.end(), Later());
}

// Moves what is due to the classes. What the stage itself has to do is done here, in the order of time.
void Scheduler::collect(Worker &worker)
{
    while (!heap_.empty() && heap_.front().due_s <= end_s_) {
        const Key key = heap_.front();
        const Task task = tasks_[key.slot];
        std::pop_heap(heap_.begin(), heap_.end(), Later());
        heap_.pop_back();
        if (!heap_.empty()) {
            __builtin_prefetch(&tasks_[heap_.front().slot]);
            if (heap_.front().agent != none) worker.fetch(heap_.front().agent);
        }
        try {
            if (is_of_stage(task.kind)) worker.prepare(task);
            else if (worker.is_alive(task)) {
                queues_[worker.class_of(task)].slots.push_back(key.slot);
                continue;
            }
        } catch (...) {
            heap_.push_back(key);  // it had room a moment ago
            std::push_heap(heap_.begin(), heap_.end(), Later());
            throw;
        }
        forget(key.slot);
    }
}

// Tasks lie anywhere in memory, and so do their agents: those that come soon are asked for.
void Scheduler::fetch(const Queue &queue, Worker &worker) const
{
    if (queue.first + 4 < queue.slots.size()) __builtin_prefetch(&tasks_[queue.slots[queue.first + 4]]);
    if (queue.first + 2 < queue.slots.size()) worker.fetch(tasks_[queue.slots[queue.first + 2]].agent);
}

// False: no task of the class is left; those that have become pointless are dropped on the way.
bool Scheduler::has_task(Queue &queue, Worker &worker)
{
    while (!queue.empty() && !worker.is_alive(tasks_[queue.slots[queue.first]])) forget(queue.slots[queue.first++]);
    return !queue.empty();
}

double Scheduler::price(uint32_t priority, Worker &worker) const
{
    const Queue &queue = queues_[priority];
    const double cost = worker.cost_of(tasks_[queue.slots[queue.first]]);
    return std::min(limits_.now_s ? cost * unit_us_ : cost, limits_.budget);
}

void Scheduler::open(Worker &worker)
{
    ++tick_;
    rest_ = limits_.budget;
    is_open_ = true;
    for (uint32_t c = 0; c < class_count; ++c) {
        Queue &queue = queues_[c];
        if (!has_task(queue, worker)) {
            queue.credit = 0, queue.owed_since = 0;
            continue;
        }
        queue.credit = std::min(queue.credit + limits_.shares[c] * limits_.budget, limits_.budget);
        if (queue.credit < price(c, worker)) queue.owed_since = 0;
        else if (queue.owed_since == 0) queue.owed_since = tick_;
    }
}

// The class whose credit pays its first task, and has done so for longest; of equal ones the last, so that a class that
// has just been served is never served again before another one that is owed. none: there is no such class.
uint32_t Scheduler::most_owed(Worker &worker)
{
    uint32_t found = none;
    for (uint32_t c = 0; c < class_count; ++c) {
        Queue &queue = queues_[c];
        if (queue.owed_since == 0 || !has_task(queue, worker)) continue;
        const double wanted = price(c, worker);
        if (wanted > queue.credit || wanted > rest_) continue;
        if (found == none || queue.owed_since <= queues_[found].owed_since) found = c;
    }
    return found;
}

uint32_t Scheduler::first_paid(Worker &worker)
{
    for (uint32_t c = 0; c < class_count; ++c)
        if (has_task(queues_[c], worker) && (limits_.budget == 0 || price(c, worker) <= rest_)) return c;
    return none;
}

double Scheduler::microseconds() const
{
    try {
        double now_s = 0;
        with_host_floats([&] { now_s = limits_.now_s(limits_.now_user); });
        return now_s * 1e6;
    } catch (...) {
        return 0;
    }
}

void Scheduler::run_first(uint32_t priority, Worker &worker)
{
    Queue &queue = queues_[priority];
    const uint32_t slot = queue.slots[queue.first];
    const Task task = tasks_[slot];
    fetch(queue, worker);
    const bool late = task.due_s <= begin_s_;
    const uint32_t cost = worker.cost_of(task);
    const bool measured = limits_.now_s && limits_.budget > 0;
    const double before_us = measured ? microseconds() : 0;
    worker.run(task, late);
    ++queue.first;
    forget(slot);
    double paid = std::min(double(cost), limits_.budget);
    if (measured) {
        paid = std::max(0.0, microseconds() - before_us);
        unit_us_ += (paid / cost - unit_us_) / 64;
    }
    rest_ -= paid;
    queue.credit = std::max(0.0, queue.credit - paid);
    if (queue.owed_since) queue.owed_since = tick_;
    clq_stage_class_info &info = done[priority];
    ++info.done;
    info.late += late;
    info.cost += cost;
    if (!late) return;
    const double length_s = end_s_ - begin_s_;
    const double own_end_s = end_s_ - std::floor((end_s_ - task.due_s) / length_s) * length_s;
    info.longest_wait_s = std::max(info.longest_wait_s, end_s_ - own_end_s);
}

void Scheduler::run(double begin_s, double end_s, Worker &worker)
{
    begin_s_ = begin_s, end_s_ = end_s;
    collect(worker);
    if (!is_open_) open(worker);
    if (limits_.budget > 0)
        for (uint32_t c = most_owed(worker); c != none; c = most_owed(worker)) {
            run_first(c, worker);
            collect(worker);
        }
    for (uint32_t c = first_paid(worker); c != none; c = first_paid(worker)) {
        run_first(c, worker);
        collect(worker);
    }
    close();
}

void Scheduler::close()
{
    is_open_ = false;
    for (uint32_t c = 0; c < class_count; ++c) {
        Queue &queue = queues_[c];
        queue.slots.erase(queue.slots.begin(), queue.slots.begin() + static_cast<std::ptrdiff_t>(queue.first));
        queue.first = 0;
        done[c].waiting = static_cast<uint32_t>(queue.slots.size());
    }
}

}  // namespace claque::stage
