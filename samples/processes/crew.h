// Worker processes that answer tasks. They are forked, without exec, by a process that has neither threads nor GL, so
// each starts with all that its parent has read and needs no arguments. A worker that ends is replaced, and its task is
// sent again. If the process that
// made them ends, in any way, its workers end too.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "samples/processes/channel.h"

namespace processes
{

class Crew
{
public:
    // Runs in the worker. What it throws ends the crew's work: wait() throws it as std::runtime_error.
    using Answering = std::function<std::string(const std::string &task)>;
    // Runs in the worker before its first task: a worker that replaces another one has nothing of that one.
    using Start = std::function<Answering(uint32_t worker)>;

    // Starts the workers. To be made where no other thread runs. Throws std::runtime_error.
    Crew(uint32_t count, Start start);
    ~Crew();  // ends all of them at once
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    uint32_t size() const { return static_cast<uint32_t>(workers_.size()); }
    // Gives a worker a task; it must have none. A task may be done more than once, as a worker may end at any moment.
    void send(uint32_t worker, const std::string &task);
    bool is_busy(uint32_t worker) const { return workers_[worker].busy; }

    struct Answer {
        uint32_t worker;
        std::string text;
    };
    // Waits for the next answer; some worker must be busy. Throws std::runtime_error: what a worker threw, or that
    // workers keep ending.
    Answer wait();

    uint32_t replaced() const { return replaced_; }

private:
    struct Worker {
        pid_t process = 0;
        Channel channel;
        std::string task;
        bool busy = false;
        int ended_in_a_row = 0;
    };

    void begin(uint32_t worker);
    void end_all();
    void replace(uint32_t worker);
    [[noreturn]] void work(uint32_t worker, Channel channel);

    Start start_;
    std::vector<Worker> workers_;
    uint32_t replaced_ = 0;
    uint32_t first_asked_ = 0;  // so that no worker waits behind the others
};

}  // namespace processes
