#include "samples/io/unfinished.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <unistd.h>

#include <pthread.h>

namespace io
{
namespace
{

// A signal handler may read these: a path is complete before `used` is true.
struct Slot {
    std::atomic<bool> taken{false}, used{false};
    char path[PATH_MAX];
};
constexpr int slot_count = 64;
Slot slots[slot_count];

// Those whose default ends a process and that a process can catch. SIGBUS is WatchedPages' too.
bool is_ending(int number)
{
    for (const int other : {SIGKILL, SIGSTOP, SIGXFSZ, SIGCHLD, SIGCONT, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG, SIGWINCH})
        if (number == other) return false;
    return true;
}

template <class Use>
void for_ending_signals(const Use &use)
{
    for (int number = 1; number <= SIGRTMAX; ++number)
        if (is_ending(number)) use(number);
}

sigset_t ending_signals()
{
    sigset_t all;
    sigemptyset(&all);
    for_ending_signals([&](int number) { sigaddset(&all, number); });
    return all;
}

// Sent by what a thread did itself. The thread cannot go on.
bool is_fault(int number)
{
    for (const int fault : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP})
        if (number == fault) return true;
    return false;
}

pthread_t main_thread = pthread_self();  // which runs initialisers

extern "C" void claque_io_end(int number) { end_by(number); }

}  // namespace

void end_by(int number)
{
    while (passed_to_main_thread(number)) {
        if (!is_fault(number)) return;
        pause();
    }
    remove_unfinished();
    signal(number, SIG_DFL);
    raise(number);  // acts when the handler returns: the signal is blocked in it
}

// Async-signal-safe calls only. The main thread writes all files: where it runs a handler, no file appears in between.
bool passed_to_main_thread(int number)
{
    if (pthread_equal(pthread_self(), main_thread)) return false;
    pthread_kill(main_thread, number);
    return true;
}

void remove_unfinished()
{
    for (const Slot &slot : slots)
        if (slot.used.load(std::memory_order_acquire)) unlink(slot.path);
    for (const Slot &slot : slots)
        if (slot.used.load(std::memory_order_acquire)) rmdir(slot.path);
}

void watch_signals()
{
    const auto handle = [](int number, void (*handler)(int)) {
        struct sigaction present = {}, wanted = {};
        if (sigaction(number, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) return;
        wanted.sa_handler = handler;
        sigemptyset(&wanted.sa_mask);
        sigaction(number, &wanted, nullptr);
    };
    for_ending_signals([&](int number) { handle(number, claque_io_end); });
    handle(SIGXFSZ, SIG_IGN);  // the write fails, and a sentence says it
}

void leave_files_to_parent()
{
    for_ending_signals([](int number) {
        struct sigaction present = {};
        if (sigaction(number, nullptr, &present) == 0 && present.sa_handler == claque_io_end) signal(number, SIG_DFL);
    });
    for (Slot &slot : slots) slot.used = false, slot.taken = false;
    const sigset_t held = ending_signals();
    pthread_sigmask(SIG_UNBLOCK, &held, nullptr);
}

SignalsHeld::SignalsHeld()
{
    const sigset_t held = ending_signals();
    pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

Unfinished::Unfinished(const std::string &path) : slot_(-1)
{
    if (path.size() >= sizeof slots[0].path) return;  // no file can be made there
    for (int i = 0; i < slot_count && slot_ < 0; ++i)
        if (!slots[i].taken.exchange(true)) slot_ = i;
    if (slot_ < 0) return;
    std::memcpy(slots[slot_].path, path.c_str(), path.size() + 1);
    slots[slot_].used.store(true, std::memory_order_release);
}

Unfinished::~Unfinished()
{
    if (slot_ < 0) return;
    slots[slot_].used = false;
    slots[slot_].taken = false;
}

}  // namespace io
