#include "tests/api/throwing_host.h"

#include <cmath>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace throwing
{
namespace
{

Host &host_of(void *user) { return *static_cast<Host *>(user); }

void *allocate(void *user, size_t size_bytes, size_t alignment_bytes)
{
    host_of(user).pass(Kind::allocate);
    return ::operator new(size_bytes, std::align_val_t(alignment_bytes), std::nothrow);
}

// The memory is released first, so that the test leaks nothing.
void release(void *user, void *memory, size_t, size_t alignment_bytes)
{
    ::operator delete(memory, std::align_val_t(alignment_bytes));
    host_of(user).pass(Kind::release);
}

void write_log(void *user, clq_log_level, const char *text)
{
    host_of(user).last_log = text;
    host_of(user).pass(Kind::log);
}

void run_here(uint32_t first, uint32_t last, void (*job)(void *, uint32_t), void *job_data)
{
    for (uint32_t i = first; i < last; ++i) job(job_data, i);
}

void run_on_threads(uint32_t first, uint32_t last, void (*job)(void *, uint32_t), void *job_data)
{
    const uint32_t middle = first + (last - first) / 2;
    std::thread other([&] { run_here(middle, last, job, job_data); });
    run_here(first, middle, job, job_data);
    other.join();
}

template <void (*run)(uint32_t, uint32_t, void (*)(void *, uint32_t), void *)>
void run_tasks(void *user, uint32_t count, void (*job)(void *, uint32_t), void *job_data)
{
    Host &host = host_of(user);
    const bool throws = host.throws_now(Kind::tasks);
    const uint32_t last = !throws || host.moment == Moment::after ? count : host.moment == Moment::half ? count / 2 : 0;
    if (last > 0) run(0, last, job, job_data);
    if (throws) throw std::runtime_error(words);
}

}  // namespace

clq_context_def Host::context_def(bool threads)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = {this, allocate, release};
    def.log = {this, write_log};
    def.tasks = {this, threads ? run_tasks<run_on_threads> : run_tasks<run_here>};
    return def;
}

void Host::arm(Kind kind, uint64_t n, Moment when)
{
    moment = when;
    at_ = n, seen_ = 0;
    kind_ = kind;
}

uint64_t Host::disarm()
{
    kind_ = Kind::none;
    return seen_;
}

bool Host::throws_now(Kind kind)
{
    if (kind_ != kind) return false;
    const uint64_t number = ++seen_;
    return at_ != 0 && number == at_;
}

void Host::pass(Kind kind)
{
    if (throws_now(kind)) throw std::runtime_error(words);
}

double Host::height(void *user, const double point[3])
{
    host_of(user).pass(Kind::ground);
    return 0.2 * std::sin(point[0]);
}

void Host::move(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    host_of(user).pass(Kind::mechanism);
    clq_dof_write(writer, 2, static_cast<float>(0.1 + 0.1 * std::sin(call->time_s)), 0.5f);
}

void Host::remember(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    host_of(user).pass(Kind::memory);
    clq_dof_write(writer, 1, static_cast<float>(0.5 * std::sin(call->time_s)), 0.5f);
}

double Host::now_s(void *user)
{
    host_of(user).pass(Kind::clock);
    return 1e-6 * static_cast<double>(++host_of(user).ticks);
}

int Host::write(void *user, const void *bytes, size_t size_bytes)
{
    host_of(user).pass(Kind::write);
    host_of(user).written.append(static_cast<const char *>(bytes), size_bytes);
    return 0;
}

}  // namespace throwing
