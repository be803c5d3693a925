#include "samples/cli/progress.h"

#include <cstdio>
#include <unistd.h>

#include "samples/cli/terminal.h"

namespace cli
{

using Clock = std::chrono::steady_clock;

namespace
{

void clear_line() { std::fputs("\r\033[K", raw_errors()); }

}  // namespace

Progress::Progress(std::string doing)
    : doing_(std::move(doing)), terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()), last_(start_)
{
}

Progress::~Progress()
{
    if (shown_) clear_line();
}

void Progress::show(const std::string &text, bool at_once)
{
    const Clock::time_point now = Clock::now();
    if (!terminal_ || (!at_once && shown_ && now - last_ < std::chrono::milliseconds(100))) return;
    clear_line();
    std::fprintf(stderr, "%s: %s", doing_.c_str(), text.c_str());
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
    clear_line();
    std::fprintf(stderr, "%s\n", sentence.c_str());
    shown_ = false;
}

Waiting::Waiting(const std::string &doing)
{
    if (isatty(STDERR_FILENO) != 1) return;
    shows_ = std::thread([this, doing] {
        Progress progress("claque");
        std::unique_lock<std::mutex> lock(mutex_);
        for (int seconds = 0; !is_over_; ++seconds) {
            progress.phase(doing + ", " + std::to_string(seconds) + " s");
            wake_.wait_for(lock, std::chrono::seconds(1), [this] { return is_over_; });
        }
    });
}

Waiting::~Waiting()
{
    if (!shows_.joinable()) return;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_over_ = true;
    }
    wake_.notify_all();
    shows_.join();
}

}  // namespace cli
