#include "samples/convert/child.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "samples/io/unfinished.h"
#include "samples/scenes/check.h"

namespace convert
{
namespace
{

using Clock = std::chrono::steady_clock;

// The first byte of what a child sends.
constexpr char done = 'D', failed = 'F';

void limit(int resource, uint64_t value)
{
    const rlimit wanted = {static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
    (void)setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

void send_all(int to, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t sent = write(to, bytes, size);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(1);
        bytes += sent;
        size -= static_cast<size_t>(sent);
    }
}

void enter_child(const Limits &limits, pid_t parent)
{
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    io::leave_files_to_parent();
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int standard : {0, 1, 2}) (void)dup2(nowhere, standard);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which reserve terabytes of address space
    limit(RLIMIT_AS, limits.memory_bytes);
#endif
    limit(RLIMIT_CPU, limits.seconds);
    limit(RLIMIT_CORE, 0);
}

[[noreturn]] void be_child(int out, const std::function<std::string()> &work)
{
    std::string text;
    char first = failed;
    try {
        text = work();
        first = done;
    } catch (const std::bad_alloc &) {
        text = "needs more memory than it may take";
    } catch (const std::exception &error) {
        text = error.what();
    } catch (...) {
        text = "failed without a reason";
    }
    send_all(out, &first, 1);
    send_all(out, text.data(), text.size());
    _exit(0);
}

// A child that is killed and waited for whatever happens.
struct Process {
    pid_t id = -1;
    int from = -1;
    ~Process()
    {
        if (from >= 0) close(from);
        if (id > 0) kill(id, SIGKILL), wait_for();
    }
    int wait_for()
    {
        int state = 0;
        while (waitpid(id, &state, 0) < 0 && errno == EINTR) continue;
        id = -1;
        return state;
    }
};

// All that the child sends until it closes its end.
std::string received(const Process &child, const std::string &what, const Limits &limits)
{
    const Clock::time_point end = Clock::now() + std::chrono::seconds(limits.seconds);
    std::string bytes;
    char piece[65536];
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) throw scenes::Failure(what + " was stopped after " + std::to_string(limits.seconds) + " s");
        pollfd ready = {child.from, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(left)) < 0) {
            if (errno == EINTR) throw scenes::Failure(what + " was stopped by a signal");
            throw scenes::Failure(what + " could not be followed: " + std::strerror(errno));
        }
        if (ready.revents == 0) continue;
        const ssize_t got = read(child.from, piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        if (bytes.size() + static_cast<size_t>(got) > limits.memory_bytes)
            throw scenes::Failure(what + " gave more than " + std::to_string(limits.memory_bytes) + " bytes");
        bytes.append(piece, static_cast<size_t>(got));
    }
}

std::string ending(int state, const Limits &limits)
{
    if (!WIFSIGNALED(state)) return " ended with code " + std::to_string(WEXITSTATUS(state));
    const int number = WTERMSIG(state);
    if (number == SIGXCPU || (number == SIGKILL && limits.seconds == 0))
        return " was stopped after " + std::to_string(limits.seconds) + " s";
    const char *name = sigabbrev_np(number);
    return " crashed (signal " + std::to_string(number) + (name ? std::string(", SIG") + name : "") + ")";
}

}  // namespace

std::string run_in_child(const std::string &what, const Limits &limits, const std::function<std::string()> &work)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw scenes::Failure(what + " could not be started: " + std::strerror(errno));
    const pid_t parent = getpid();
    Process child;
    child.from = ends[0];
    child.id = fork();
    if (child.id == 0) {
        enter_child(limits, parent);
        be_child(ends[1], work);
    }
    close(ends[1]);
    if (child.id < 0) throw scenes::Failure(what + " could not be started: " + std::strerror(errno));
    std::string bytes = received(child, what, limits);
    const int state = child.wait_for();
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0 || bytes.empty())
        throw scenes::Failure(what + ending(state, limits));
    if (bytes[0] != done) throw scenes::Failure(what + ": " + bytes.substr(1));
    bytes.erase(0, 1);
    return bytes;
}

}  // namespace convert
