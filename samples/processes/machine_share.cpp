#include "samples/processes/machine_share.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace processes
{
namespace
{

struct Scheduled {
    const char *cores;                  // the variable with their number
    enum { rank, machine, job } among;  // which processes have these cores together
};
constexpr Scheduled schedulers[] = {{"SLURM_CPUS_PER_TASK", Scheduled::rank},
                                    {"NCPUS", Scheduled::machine},
                                    {"NSLOTS", Scheduled::job},
                                    {"LSB_DJOB_NUMPROC", Scheduled::job}};

int cores_in(const char *value) { return std::clamp(std::atoi(value), 1, 256); }

}  // namespace

bool is_scheduled()
{
    for (const char *name : {"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "SGE_TASK_ID"})
        if (std::getenv(name)) return true;
    return false;
}

int scheduled_cores()
{
    for (const Scheduled &one : schedulers)
        if (const char *value = std::getenv(one.cores)) return cores_in(value);
    return 1;
}

int cores_of_worker(int workers, int machine_cores)
{
    return std::max(1, (is_scheduled() ? scheduled_cores() : machine_cores) / workers);
}

int cores_of_rank(int ranks, int ranks_here, int machine_cores)
{
    if (!is_scheduled()) return std::max(1, machine_cores / ranks_here);
    for (const Scheduled &one : schedulers)
        if (const char *value = std::getenv(one.cores)) {
            const int sharers = one.among == Scheduled::rank ? 1 : one.among == Scheduled::machine ? ranks_here : ranks;
            return std::max(1, cores_in(value) / sharers);
        }
    return 1;
}

void take_mesa_threads(int cores)
{
    constexpr const char *name = "LP_NUM_THREADS";
    static const bool was_set = std::getenv(name) != nullptr;
    if (!was_set) setenv(name, std::to_string(cores > 1 ? cores : 0).c_str(), 1);
}

}  // namespace processes
