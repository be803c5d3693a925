#include "samples/io/mapped.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/io/files.h"
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
constexpr int most_watched = 8;  // files beyond are read, but end the command by the signal
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
    signal(number, SIG_DFL);
    raise(number);
}

// The place where a file is watched; -1: too many are, or its path is too long.
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

std::string Mapped::open(const std::string &path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return why(path, "read");
    struct stat there = {};
    const bool known = fstat(file, &there) == 0;
    if (known && there.st_size > 0) {
        void *data = mmap(nullptr, static_cast<size_t>(there.st_size), PROT_READ, MAP_PRIVATE, file, 0);
        if (data != MAP_FAILED) data_ = static_cast<const char *>(data), size_ = static_cast<size_t>(there.st_size);
    }
    const std::string wrong = known && (there.st_size == 0 || size_ > 0) ? "" : why(path, "read");
    close(file);
    if (size_ > 0) {
        watched_ = watch(path, data_, size_);
        watch_bus_errors();
    }
    return wrong;
}

Mapped::~Mapped()
{
    if (size_ > 0) munmap(const_cast<char *>(data_), size_);
    if (watched_ < 0) return;
    all_watched[watched_].end = 0;
    all_watched[watched_].taken = false;
}

}  // namespace io
