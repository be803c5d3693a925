// The scheduler of S1 2.2. Tasks wait for their time in a heap; when they are due they queue in their priority class,
// first in, first out, and the tick's budget decides which of them run. Every class earns a share of each budget, so
// that the oldest task of a class waits for at most ceil(cost / (share * budget)) + 3 ticks, whatever the others do:
// once its credit pays for it, each other class can be served at most once before it.
//
// A tick may be cut short by an exception of a task: its work is then undone, it stays first in its class, and the next
// call of run() goes on where the tick was.
#pragma once

#include <claque/stage.h>

#include <array>
#include <vector>

#include "lib/stage/schedule/task.h"

namespace claque::stage
{

constexpr uint32_t class_count = CLQ_STAGE_CLASS_COUNT;

struct SavedStage;

// Whose tasks they are.
class Worker
{
public:
    virtual ~Worker() = default;
    virtual bool is_alive(const Task &task) const = 0;  // false: it is forgotten, at no cost
    virtual uint32_t class_of(const Task &task) const = 0;
    virtual uint32_t cost_of(const Task &task) const = 0;
    virtual void fetch(uint32_t) const {}               // an agent's task comes soon: its memory may be fetched
    virtual void prepare(const Task &task) = 0;         // a task of the stage; may add tasks. If it throws, nothing is
    virtual void run(const Task &task, bool late) = 0;  // a task of an agent; likewise
};

struct Limits {
    double budget = 0;  // 0: none. Declared cost, or microseconds
    std::array<double, class_count> shares{};
    double (*now_s)(void *user) = nullptr;  // NULL: declared costs are counted
    void *now_user = nullptr;
};

class Scheduler
{
public:
    explicit Scheduler(const Limits &limits) : limits_(limits) {}

    void reserve(size_t more);
    // Adds a task of the stage's own, or a message, whose order is given. Does not throw after reserve().
    void add(Task task);
    void add_message(const Task &task);
    size_t waiting() const { return heap_.size(); }
    size_t held() const { return tasks_.size() - free_.size(); }  // also those that are due
    // Forgets tasks that have become pointless and whose time has not come. Changes nothing that is decided.
    void sweep(const Worker &worker);

    // Runs the tick that begins after begin_s and ends at end_s.
    void run(double begin_s, double end_s, Worker &worker);

    std::array<clq_stage_class_info, class_count> done{};

    // save/tasks.cpp. Between two ticks; tasks that have become pointless are left out.
    void save(SavedStage &out, const Worker &worker) const;
    Scheduler empty_copy() const { return Scheduler(limits_); }
    void restore(const SavedStage &from);
    bool is_open() const { return is_open_; }

private:
    struct Key {
        double due_s;
        uint64_t order;
        uint32_t slot, agent;
    };
    struct Later {  // a type, so that the heap's functions contain it
        bool operator()(const Key &a, const Key &b) const
        {
            return a.due_s > b.due_s || (a.due_s == b.due_s && a.order > b.order);
        }
    };
    struct Queue {
        std::vector<uint32_t> slots;
        size_t first = 0;
        double credit = 0;
        uint64_t owed_since = 0;  // tick; 0: its credit does not pay for its first task
        bool empty() const { return first == slots.size(); }
    };

    void put(const Task &task);
    void fetch(const Queue &queue, Worker &worker) const;
    void collect(Worker &worker);
    void forget(uint32_t slot) { free_.push_back(slot); }
    bool has_task(Queue &queue, Worker &worker);
    double price(uint32_t priority, Worker &worker) const;
    void open(Worker &worker);
    uint32_t most_owed(Worker &worker);
    uint32_t first_paid(Worker &worker);
    void run_first(uint32_t priority, Worker &worker);
    double microseconds() const;
    void close();

    Limits limits_;
    std::vector<Task> tasks_;  // by slot
    std::vector<uint32_t> free_;
    std::vector<Key> heap_;
    std::array<Queue, class_count> queues_;
    uint64_t next_order_ = own_order, tick_ = 0;
    double begin_s_ = 0, end_s_ = 0, rest_ = 0;
    double unit_us_ = 1;  // measured price of one unit of declared cost
    bool is_open_ = false;
};

}  // namespace claque::stage
