// What other threads tell the decisions, and what they need to know to say it: names of events, classes, variables, and
// which agents there are. One lock, held for an instant; the drawing flow never takes it.
#pragma once

#include <mutex>
#include <vector>

#include "lib/stage/agents/agent.h"
#include "lib/stage/error.h"
#include "lib/stage/schedule/task.h"

namespace claque::stage
{

class Inbox
{
public:
    // The directory. Decisions change it under the lock, and read their own copies without it.
    struct Directory {
        Vocabulary shared;
        std::vector<const Machine *> machines;
        std::vector<uint32_t> machine_of_agent;  // none: it was removed
    };

    // Body: f(const Directory &, i, Task &) fills message i, or throws: then none is posted.
    template <class Body>
    void post_many(uint32_t count, const Body &body)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const size_t before = messages_.size(), most = most_waiting(directory_.machine_of_agent.size());
        if (before + count > most)
            fail(CLQ_LIMIT,
                 "%zu messages wait for clq_stage_step, and here are %u more: %zu may, 2^20 and 64 for each agent",
                 before, count, most);
        try {
            for (uint32_t i = 0; i < count; ++i) {
                messages_.emplace_back();
                body(const_cast<const Directory &>(directory_), i, messages_.back());
                messages_.back().order = order_of_message(messages_.back());
            }
        } catch (...) {
            messages_.resize(before);
            throw;
        }
    }

    template <class Body>
    void post(const Body &body)
    {
        post_many(1, [&](const Directory &directory, uint32_t, Task &task) { body(directory, task); });
    }

    template <class Body>
    void change(const Body &body)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        body(directory_);
    }

    // Swaps out the messages; `out` is empty before.
    void take(std::vector<Task> &out)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        out.swap(messages_);
    }

    // The same, with other messages in place of those that wait.
    template <class Body>
    void replace(const Body &body, std::vector<Task> &messages)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        body(directory_);
        messages_.swap(messages);
    }

    std::vector<Task> copy() const
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return messages_;
    }

private:
    mutable std::mutex mutex_;
    Directory directory_;
    std::vector<Task> messages_;
};

}  // namespace claque::stage
