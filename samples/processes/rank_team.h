// The ranks of an MPI job as a team. Rank 0 gives out the tasks and answers some of them itself.
#pragma once

#include <deque>

#include "samples/processes/ranks.h"
#include "samples/processes/team.h"

namespace processes
{

class RankTeam : public Team
{
public:
    // Two, so that no rank waits while rank 0 answers a task of its own.
    static constexpr uint32_t tasks_each = 2;

    // Of rank 0. `own` answers its own tasks. All ranks have pages of one size; answers' pixels are copied into these.
    RankTeam(Ranks &ranks, Answering own, uint8_t *pages) : ranks_(ranks), own_(std::move(own)), pages_(pages) {}
    ~RankTeam() override;  // ends serve() of the others

    uint32_t size() const override { return static_cast<uint32_t>(ranks_.count()); }
    uint32_t depth() const override { return tasks_each; }
    void send(uint32_t worker, const std::string &task) override;
    Answer wait() override;
    uint32_t replaced() const override { return 0; }

private:
    Ranks &ranks_;
    Answering own_;
    uint8_t *pages_;
    std::deque<std::string> tasks_;  // of rank 0
};

// What the other ranks do: answers tasks until rank 0 needs no more answers.
void serve(Ranks &ranks, const Answering &answering, const uint8_t *pages);

}  // namespace processes
