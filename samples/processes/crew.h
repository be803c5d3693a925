// Worker processes that answer tasks. They are forked, without exec, by a process that has neither threads nor GL, so
// each starts with all that its parent has read and needs no arguments. A worker that ends is replaced, and its task is
// sent again; or that is told, where another process could not take its place. If the process that made them ends, in
// any way, its workers end too.
#pragma once

#include <sys/types.h>
#include <vector>

#include "samples/processes/channel.h"
#include "samples/processes/team.h"

namespace processes
{

class Crew : public Team
{
public:
    // Runs in the worker before its first task: a worker that replaces another one has nothing of that one. What the
    // worker throws ends the crew's work: wait() throws it as std::runtime_error.
    using Start = std::function<Answering(uint32_t worker)>;

    // What follows when a worker ends. replaced: another one is forked, so that no thread may run then either. told:
    // the answer of wait() says so, and the worker gets no more tasks.
    enum class Ends { replaced, told };

    // Starts the workers. To be made where no other thread runs. Throws std::runtime_error.
    Crew(uint32_t count, Start start, Ends ends = Ends::replaced);
    ~Crew() override;  // ends all of them at once
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    uint32_t size() const override { return static_cast<uint32_t>(workers_.size()); }
    uint32_t depth() const override { return 1; }
    // A task may be done more than once, as a worker may end at any moment.
    void send(uint32_t worker, const std::string &task) override;
    bool is_busy(uint32_t worker) const { return workers_[worker].busy; }

    // Throws what a worker threw, or that workers keep ending.
    Answer wait() override;
    // Ends a worker for good.
    void dismiss(uint32_t worker);
    bool is_there(uint32_t worker) const { return workers_[worker].process > 0; }

    uint32_t replaced() const override { return replaced_; }

private:
    struct Worker {
        pid_t process = 0;
        Channel channel;
        std::string task;
        bool busy = false;
        int ended_in_a_row = 0;
    };

    void begin(uint32_t worker);
    static int end(Worker &worker);  // returns how
    void end_all();
    void replace(uint32_t worker);
    [[noreturn]] void work(uint32_t worker, Channel channel);

    Start start_;
    Ends ends_;
    std::vector<Worker> workers_;
    uint32_t replaced_ = 0;
    uint32_t first_asked_ = 0;  // so that no worker waits behind the others
};

}  // namespace processes
