#include "samples/io/watched_pages.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <unistd.h>

#include "samples/io/unfinished.h"

namespace io
{
namespace
{

// A signal handler may read these: the rest is complete before `end` is not 0.
struct Watched {
    std::atomic<bool> taken{false};
    std::atomic<uintptr_t> end{0};
    uintptr_t begin;
    char sentence[PATH_MAX + 128];
};
constexpr int most_watched = 8;
Watched all_watched[most_watched];

const Watched *watched_at(const void *address)
{
    const uintptr_t at = reinterpret_cast<uintptr_t>(address);
    for (const Watched &one : all_watched)
        if (at < one.end.load(std::memory_order_acquire) && at >= one.begin) return &one;
    return nullptr;
}

std::atomic<bool> is_lost{false};

// Any thread can read what is gone. It says so, and the main thread ends the command. Async-signal-safe calls only.
extern "C" void claque_io_lost(int number, siginfo_t *info, void *)
{
    const Watched *watched = info->si_code > 0 ? watched_at(info->si_addr) : nullptr;
    if (watched && !is_lost.exchange(true)) {
        const ssize_t written = write(STDERR_FILENO, watched->sentence, std::strlen(watched->sentence));
        static_cast<void>(written);  // there is no other place to say it
    }
    if (is_lost) {
        while (passed_to_main_thread(number)) pause();
        remove_unfinished();
        _exit(1);
    }
    end_by(number);
}

int watch(const std::string &path, const char *data, size_t size)
{
    const std::string says = (isatty(STDERR_FILENO) ? "\r\033[K" : "") + std::string("claque: ") + path +
                             " could not be read further: it became shorter, or its disk failed.\n";
    if (says.size() >= sizeof all_watched[0].sentence) return -1;
    for (int i = 0; i < most_watched; ++i) {
        Watched &one = all_watched[i];
        if (one.taken.exchange(true)) continue;
        one.begin = reinterpret_cast<uintptr_t>(data);
        std::memcpy(one.sentence, says.c_str(), says.size() + 1);
        one.end.store(one.begin + size, std::memory_order_release);
        return i;
    }
    return -1;
}

void watch_bus_errors()
{
    struct sigaction wanted = {};
    wanted.sa_sigaction = claque_io_lost;
    wanted.sa_flags = SA_SIGINFO;
    sigemptyset(&wanted.sa_mask);
    sigaction(SIGBUS, &wanted, nullptr);
}

}  // namespace

WatchedPages::WatchedPages(const std::string &path, const char *data, size_t size) : slot_(watch(path, data, size))
{
    watch_bus_errors();
}

WatchedPages::~WatchedPages()
{
    if (slot_ < 0) return;
    all_watched[slot_].end = 0;
    all_watched[slot_].taken = false;
}

}  // namespace io
