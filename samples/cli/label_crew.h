// Labelled pictures by several processes of this machine, or by the ranks of an MPI job: whole pictures in turn.
#pragma once

#include <functional>
#include <memory>

#include "samples/cli/label_maker.h"
#include "samples/processes/ranks.h"
#include "samples/processes/team.h"

namespace cli
{

class LabelCrew
{
public:
    // Starts the processes, or has the ranks of a job (rank 0 calls it). To be made where no thread and no GL context
    // is; `arguments` must live as long as this. Throws std::runtime_error, as the next calls do.
    explicit LabelCrew(const LabelArguments &arguments, processes::Ranks *ranks = nullptr);

    // What GL calls itself in all of them.
    std::string gl();
    // Calls done(index, files) once for each number, in any order.
    using Done = std::function<void(size_t index, LabelledFiles made)>;
    void make(const std::vector<int> &numbers, const Done &done);

    uint32_t replaced() const { return team_->replaced(); }  // processes that ended and were replaced

    // What the other ranks do: labels until rank 0 has all pictures.
    static void serve(const LabelArguments &arguments, processes::Ranks &ranks);

private:
    std::unique_ptr<processes::Team> team_;
};

}  // namespace cli
