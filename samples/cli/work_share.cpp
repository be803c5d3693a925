#include "samples/cli/work_share.h"

#include "samples/cli/command.h"
#include "samples/cli/warnings.h"
#include "samples/processes/crew.h"
#include "samples/processes/machine_share.h"
#include "samples/processes/rank_team.h"

namespace cli
{
namespace
{

int cores_each(int asked, const processes::Ranks *ranks)
{
    if (ranks) return processes::cores_of_rank(ranks->count(), ranks->count_here(), core_count());
    return processes::cores_of_worker(process_count(asked), core_count());
}

processes::Answering answering_of(const SceneArguments &a, int asked, const processes::Ranks *ranks,
                                  const MakeAnswering &make)
{
    processes::take_mesa_threads(cores_each(asked, ranks));
    return make(threads_each(a, asked, ranks));
}

}  // namespace

int process_count(int asked)
{
    if (processes::ranks_started() > 1) return processes::ranks_started();
    return asked > 0 ? asked : processes::is_scheduled() ? processes::scheduled_cores() : 1;
}

int threads_each(const SceneArguments &a, int asked, const processes::Ranks *ranks)
{
    return a.threads > 0 || process_count(asked) == 1 ? thread_count(a) : cores_each(asked, ranks);
}

void check_process_usage(int asked)
{
    if (processes::ranks_started() > 1 && asked > 0)
        throw CLI::ValidationError("--processes", "mpirun started " + std::to_string(processes::ranks_started()) +
                                                      " ranks, which share the work");
}

std::unique_ptr<processes::Team> make_team(const SceneArguments &a, int asked, processes::Ranks *ranks, uint8_t *pages,
                                           const MakeAnswering &make)
{
    if (ranks) return std::make_unique<processes::RankTeam>(*ranks, answering_of(a, asked, ranks, make), pages);
    return std::make_unique<processes::Crew>(static_cast<uint32_t>(process_count(asked)), [&a, asked, make](uint32_t) {
        return answering_of(a, asked, nullptr, make);
    });
}

void serve_team(const SceneArguments &a, processes::Ranks &ranks, const uint8_t *pages, const MakeAnswering &make)
{
    processes::serve(ranks, answering_of(a, 0, &ranks, make), pages);
}

void expect_same_pixels(std::optional<Json> &first, const Json &now, uint32_t worker)
{
    if (!first) first = now;
    for (const auto &[key, value] : first->items())
        if (now[key] != value)
            throw scenes::Failure("rank " + std::to_string(worker) + " would draw other pixels: its " + key + " is " +
                                  now[key].dump() + ", another one's is " + value.dump() +
                                  (key == "processor" ? "; --portable makes processors alike" : ""));
}

void share_work(const std::function<void(processes::Ranks *)> &lead,
                const std::function<void(processes::Ranks &)> &serve)
{
    const std::unique_ptr<processes::Ranks> ranks = processes::join_ranks();
    if (!ranks) return lead(nullptr);
    try {
        if (ranks->rank() > 0) silence_warnings();  // rank 0 reads the same files
        if (ranks->rank() > 0) serve(*ranks);
        else lead(ranks.get());
    } catch (const std::exception &failure) {
        ranks->fail(failure.what());
    }
    ranks->finish();
}

}  // namespace cli
