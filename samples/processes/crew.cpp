#include "samples/processes/crew.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "samples/io/unfinished.h"

namespace processes
{
namespace
{

constexpr int most_ends_in_a_row = 8;  // of one worker without an answer

std::string how_it_ended(int status)
{
    if (WIFSIGNALED(status)) return std::string("by ") + strsignal(WTERMSIG(status));
    return "with " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : status);
}

// A fork copies the calling thread alone: what others hold would stay locked for ever.
void expect_no_threads()
{
    size_t threads = 0;
    std::error_code none;
    for (const auto &one : std::filesystem::directory_iterator("/proc/self/task", none)) threads += !one.path().empty();
    if (threads > 1)
        throw std::runtime_error("processes are to be started before threads: there are " + std::to_string(threads) +
                                 " threads");
}

}  // namespace

Crew::Crew(uint32_t count, Start start, Ends ends) : start_(std::move(start)), ends_(ends), workers_(count)
{
    try {
        for (uint32_t i = 0; i < count; ++i) begin(i);
    } catch (...) {
        end_all();
        throw;
    }
}

Crew::~Crew() { end_all(); }

void Crew::end_all()
{
    for (const Worker &one : workers_)
        if (one.process > 0) kill(one.process, SIGKILL);
    for (const Worker &one : workers_)
        if (one.process > 0)
            while (waitpid(one.process, nullptr, 0) < 0 && errno == EINTR) continue;
}

void Crew::begin(uint32_t worker)
{
    expect_no_threads();
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error(std::string("no socket for another process: ") + std::strerror(errno));
    Channel here(ends[0]), there(ends[1]);
    const pid_t parent = getpid();
    const io::SignalsHeld held;  // the child must not remove its parent's files
    const pid_t process = fork();
    if (process < 0)
        throw std::runtime_error("process " + std::to_string(worker + 1) + " of " + std::to_string(workers_.size()) +
                                 " could not be started: " + std::strerror(errno));
    if (process == 0) {
        // From here on this process ends with its parent, also where that is killed.
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) _exit(0);
        here.close();
        for (Worker &other : workers_) other.channel.close();
        work(worker, std::move(there));
    }
    workers_[worker].process = process;
    workers_[worker].channel = std::move(here);
}

// Ends by _exit: what the parent has in buffers and would do at its end is the parent's.
void Crew::work(uint32_t worker, Channel channel)
{
    io::leave_files_to_parent();
    std::string task;
    Answering answering;
    while (channel.receive(task)) {
        std::string reply;
        try {
            if (!answering) answering = start_(worker);
            reply = answering(task).text;
            if (reply.size() >= Channel::max_bytes)
                throw std::runtime_error("an answer of " + std::to_string(reply.size()) + " bytes is longer than the " +
                                         std::to_string(Channel::max_bytes - 1) +
                                         " that one process takes from another: use one process");
            reply.insert(0, "+");
        } catch (const std::exception &failure) {
            reply = std::string("-") + failure.what();
        } catch (...) {
            reply = "-an unknown error";
        }
        if (!channel.send(reply)) break;
    }
    _exit(0);
}

int Crew::end(Worker &one)
{
    int status = 0;
    kill(one.process, SIGKILL);  // its socket is closed, whatever else it does
    while (waitpid(one.process, &status, 0) < 0 && errno == EINTR) continue;
    one.process = 0, one.busy = false;
    one.channel.close();
    return status;
}

void Crew::dismiss(uint32_t worker)
{
    if (is_there(worker)) end(workers_[worker]);
}

void Crew::replace(uint32_t worker)
{
    Worker &one = workers_[worker];
    const int status = end(one);
    if (++one.ended_in_a_row > most_ends_in_a_row)
        throw std::runtime_error("process " + std::to_string(worker + 1) + " of " + std::to_string(workers_.size()) +
                                 " ended " + std::to_string(one.ended_in_a_row) + " times in a row, the last time " +
                                 how_it_ended(status));
    ++replaced_;
    begin(worker);
}

void Crew::send(uint32_t worker, const std::string &task)
{
    Worker &one = workers_[worker];
    one.task = task, one.busy = true;
    while (!one.channel.send(task)) {
        if (ends_ == Ends::told) return;  // by wait()
        replace(worker), one.busy = true;
    }
}

Team::Answer Crew::wait()
{
    for (;;) {
        std::vector<pollfd> asked;
        std::vector<uint32_t> of;
        for (uint32_t k = 0; k < size(); ++k) {
            const uint32_t i = (first_asked_ + k) % size();
            if (!workers_[i].busy) continue;
            asked.push_back({workers_[i].channel.socket(), POLLIN, 0});
            of.push_back(i);
        }
        if (asked.empty()) throw std::logic_error("no process has a task");
        if (poll(asked.data(), asked.size(), -1) < 0 && errno != EINTR)
            throw std::runtime_error(std::string("processes cannot be waited for: ") + std::strerror(errno));
        for (size_t k = 0; k < asked.size(); ++k) {
            if (asked[k].revents == 0) continue;
            Worker &one = workers_[of[k]];
            std::string reply;
            if (!one.channel.receive(reply) || reply.empty()) {
                if (ends_ == Ends::told) {
                    end(one);
                    return {of[k], "", true};
                }
                replace(of[k]);
                send(of[k], std::string(one.task));
                continue;
            }
            one.busy = false, one.ended_in_a_row = 0;
            first_asked_ = (of[k] + 1) % size();
            if (reply[0] != '+') throw std::runtime_error(reply.substr(1));
            return {of[k], reply.substr(1)};
        }
    }
}

}  // namespace processes
