// A host under floating-point settings of its own, whose callbacks note those that they meet.
#pragma once

#include <claque/claque.h>

#include <map>
#include <mutex>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/host_floats.h"

namespace floats_host
{

using host_floats::Callback;
using host_floats::Words;

// What the callbacks of a host met, by their names.
class NotingHost
{
public:
    explicit NotingHost(const Words &floats) : floats_(floats) {}

    // Runs `work` as the callback `name` of this host.
    template <class Work>
    auto called(const char *name, const Work &work)
    {
        const Words found = host_floats::now();
        const Callback calm(floats_);
        if (is_calling) {
            const std::lock_guard<std::mutex> lock(mutex_);
            (found.control == floats_.control ? right_ : wrong_)[name] += 1;
        }
        return work();
    }

    // Runs `call` under the settings of this host, which it must leave as they were.
    template <class Call>
    void call(const Call &call) const
    {
        const bool was_calling = is_calling;
        is_calling = true;
        const Words before = host_floats::now();
        host_floats::set(floats_);
        const Words found = host_floats::now();
        const clq_status status = call();
        const Words left = host_floats::now();
        host_floats::set(before);
        is_calling = was_calling;
        EXPECT_EQ(status, CLQ_OK) << clq_last_error();
        EXPECT_TRUE(left == found) << std::hex << left.control << " " << left.raised;
    }

    const Words &floats() const { return floats_; }
    const std::map<std::string, int> &right() const { return right_; }
    const std::map<std::string, int> &wrong() const { return wrong_; }

private:
    static inline thread_local bool is_calling = false;

    Words floats_;
    std::mutex mutex_;
    std::map<std::string, int> right_, wrong_;
};

// With its allocator, log and tasks, half of which run on a thread of their own.
clq_context_def context_of(NotingHost &host);
double height(void *user, const double point[3]);
void move(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);
double now_s(void *user);
int write(void *user, const void *, size_t);
clq_actor_hooks hooks_of(NotingHost &host);
// For clq_renderer_def.get_proc_address: functions that a draw calls most note what they meet.
clq_gl_function find(void *user, const char *name);

}  // namespace floats_host
