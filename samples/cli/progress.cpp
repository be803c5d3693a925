#include "samples/cli/progress.h"

#include <cstdio>
#include <unistd.h>

namespace cli
{

using Clock = std::chrono::steady_clock;

Progress::Progress(std::string doing)
    : doing_(std::move(doing)), terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()), last_(start_)
{
}

Progress::~Progress()
{
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(const std::string &text, bool at_once)
{
    const Clock::time_point now = Clock::now();
    if (!terminal_ || (!at_once && shown_ && now - last_ < std::chrono::milliseconds(100))) return;
    std::fprintf(stderr, "\r\033[K%s: %s", doing_.c_str(), text.c_str());
    std::fflush(stderr);
    last_ = now;
    shown_ = true;
}

void Progress::phase(const std::string &what) { show(what, true); }

void Progress::step(size_t done, size_t of)
{
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    constexpr size_t wide = 30;
    const size_t full = of > 0 ? wide * done / of : wide;
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%zu of %zu, %.1f s to go", done, of,
                  done > 0 ? seconds * static_cast<double>(of - done) / static_cast<double>(done) : 0.0);
    show("[" + std::string(full, '#') + std::string(wide - full, '.') + "] " + numbers, done == of);
}

void Progress::conclude(const std::string &sentence)
{
    if (!terminal_) return;
    std::fprintf(stderr, "\r\033[K%s\n", sentence.c_str());
    shown_ = false;
}

}  // namespace cli
