// A host whose callbacks throw on request: the n-th call of one kind. Its threads are joined before tasks.run leaves.
#pragma once

#include <claque/claque.h>

#include <atomic>
#include <string>

namespace throwing
{

enum class Kind { none, ground, mechanism, memory, clock, tasks, log, allocate, release, write };

// When tasks.run throws: before any job, after half of them, or after all.
enum class Moment { before, half, after };

class Host
{
public:
    clq_context_def context_def(bool threads);  // refers to this host

    // From now on the n-th call of this kind throws; n = 0: none, they are counted.
    void arm(Kind kind, uint64_t n, Moment moment = Moment::before);
    uint64_t disarm();  // the number of calls since arm()

    // Called by callbacks of a kind; may throw.
    void pass(Kind kind);
    bool throws_now(Kind kind);

    static double height(void *user, const double point[3]);
    static void move(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);      // Kind::mechanism
    static void remember(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);  // Kind::memory
    static double now_s(void *user);
    static int write(void *user, const void *bytes, size_t size_bytes);

    std::string last_log;
    std::string written;
    Moment moment = Moment::before;
    std::atomic<uint64_t> ticks{0};

private:
    std::atomic<Kind> kind_{Kind::none};
    std::atomic<uint64_t> at_{0}, seen_{0};
};

constexpr const char *words = "thrown on purpose";

}  // namespace throwing
