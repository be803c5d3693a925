// How the processes of a run, or the ranks of an MPI job, share its work: how many there are, how many cores each of
// them takes, and that all of them make the same pixels.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "samples/cli/scene_arguments.h"
#include "samples/processes/ranks.h"
#include "samples/processes/team.h"

namespace cli
{

// The number of processes that work, ranks of a job included. `asked`: of --processes; 0: one, or as many as a
// scheduler gave cores.
int process_count(int asked);
// The threads of this process and of each that it starts. `ranks`: those of the job, or null.
int threads_each(const SceneArguments &arguments, int asked, const processes::Ranks *ranks);

// Throws CLI::ValidationError if --processes asks for some in an MPI job, whose ranks share the work.
void check_process_usage(int asked);

// Makes what answers tasks, in the process that answers them.
using MakeAnswering = std::function<processes::Answering(int threads)>;

// Starts the processes, or has the ranks of a job (rank 0 calls it). To be called where no thread and no GL context is;
// `arguments` must live as long as the team. `pages`: those that answers put pixels into, or null. Throws
// std::runtime_error.
std::unique_ptr<processes::Team> make_team(const SceneArguments &arguments, int asked, processes::Ranks *ranks,
                                           uint8_t *pages, const MakeAnswering &make);
// What the other ranks do until rank 0 needs no more answers.
void serve_team(const SceneArguments &arguments, processes::Ranks &ranks, const uint8_t *pages,
                const MakeAnswering &make);

// What pixels depend on must be one and the same in all ranks, as in the jobs of a film (docs/films.md). `now`: the
// provenance of one (provenance.h); `first`: that of the rank that was asked first. Throws scenes::Failure with the
// first difference.
void expect_same_pixels(std::optional<Json> &first, const Json &now, uint32_t worker);

// Calls lead(null) where this process is no rank of a job. In a job, rank 0 leads, and the others serve it. A rank that
// throws ends the job.
void share_work(const std::function<void(processes::Ranks *)> &lead,
                const std::function<void(processes::Ranks &)> &serve);

}  // namespace cli
