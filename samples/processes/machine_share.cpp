#include "samples/processes/machine_share.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace processes
{

int scheduled_cores()
{
    for (const char *name : {"SLURM_CPUS_PER_TASK", "NCPUS", "NSLOTS", "LSB_DJOB_NUMPROC"})
        if (const char *value = std::getenv(name)) return std::clamp(std::atoi(value), 1, 256);
    return 1;
}

void share_mesa_threads(int processes, int cores)
{
    const int each = cores / std::max(1, processes);
    setenv("LP_NUM_THREADS", std::to_string(each > 1 ? each : 0).c_str(), 0);
}

}  // namespace processes
