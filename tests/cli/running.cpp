#include "tests/cli/running.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

extern char **environ;

namespace cli_test
{
namespace
{

using Steady = std::chrono::steady_clock;

#if defined(__SANITIZE_THREAD__)
constexpr double most_work_s = 2;  // ThreadSanitizer hands a signal on at the thread's next call of the system
#else
constexpr double most_work_s = 0.1;
#endif

double seconds_since(Steady::time_point begin) { return std::chrono::duration<double>(Steady::now() - begin).count(); }

void take_stream(posix_spawn_file_actions_t *actions, int file, int standard)
{
    if (file < 0) posix_spawn_file_actions_addopen(actions, standard, "/dev/null", O_WRONLY, 0);
    else posix_spawn_file_actions_adddup2(actions, file, standard);
}

}  // namespace

Running::Running(const Words &words, int out, int err)
{
    std::vector<char *> argv = {const_cast<char *>(CLAQUE_COMMAND)};
    for (const std::string &word : words) argv.push_back(const_cast<char *>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    take_stream(&actions, out, 1);
    take_stream(&actions, err, 2);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;  // as a shell starts it: a test's own parent may ignore some
    sigemptyset(&usual);
    for (const int number : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&usual, number);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    if (posix_spawn(&child_, CLAQUE_COMMAND, &actions, &attributes, argv.data(), environ) != 0) child_ = 0;
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
}

Running::~Running()
{
    if (child_ > 0) kill(child_, SIGKILL), wait_for_end();
}

bool Running::has_ended()
{
    if (child_ > 0 && waitpid(child_, &state_, WNOHANG) == child_) child_ = 0;
    return child_ == 0;
}

void Running::send(int number) const
{
    if (child_ > 0) kill(child_, number);
}

int Running::wait_for_end()
{
    if (child_ > 0) waitpid(child_, &state_, 0);
    child_ = 0;
    return state_;
}

double Running::cpu_s() const
{
    clockid_t clock;
    timespec time = {};
    if (child_ <= 0 || clock_getcpuclockid(child_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<pid_t> Running::threads() const
{
    std::vector<pid_t> all;
    std::error_code gone;
    for (const auto &one : std::filesystem::directory_iterator("/proc/" + std::to_string(child_) + "/task", gone))
        all.push_back(std::stoi(one.path().filename().string()));
    std::sort(all.begin(), all.end());
    return all;
}

bool Running::work_until(double wanted_s, double wall_s)
{
    const Steady::time_point begin = Steady::now();
    while (!has_ended() && seconds_since(begin) < wall_s) {
        if (cpu_s() >= wanted_s) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

bool Running::stop() const
{
    kill(child_, SIGSTOP);
    siginfo_t about = {};
    waitid(P_PID, static_cast<id_t>(child_), &about, WSTOPPED | WEXITED | WNOWAIT);
    return about.si_code == CLD_STOPPED;
}

bool Running::is_over() const
{
    siginfo_t about = {};
    return waitid(P_PID, static_cast<id_t>(child_), &about, WEXITED | WNOHANG | WNOWAIT) == 0 && about.si_pid != 0;
}

Ended Running::end_by(int number, pid_t thread)
{
    Ended ended;
    if (child_ <= 0 || !stop()) {  // it came to its end by itself
        ended.state = wait_for_end();
        return ended;
    }
    const double before_s = cpu_s();
    const size_t at_once = std::min<size_t>(threads().size(), std::max(1u, std::thread::hardware_concurrency()));
    ended.most_s = most_work_s * static_cast<double>(at_once);
    if (thread == 0) kill(child_, number);
    else syscall(SYS_tgkill, child_, thread, number);
    kill(child_, SIGCONT);
    const Steady::time_point begin = Steady::now();
    while (!is_over()) {
        ended.killed = cpu_s() - before_s > 20 * ended.most_s || seconds_since(begin) > 60;
        if (ended.killed) kill(child_, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ended.wall_ms = 1000 * seconds_since(begin);
    ended.cpu_s = cpu_s() - before_s;  // of a process that is not waited for yet
    ended.state = wait_for_end();
    return ended;
}

}  // namespace cli_test
