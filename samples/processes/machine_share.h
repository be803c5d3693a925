// How many processes a job of a scheduler may start, and how many threads each of them takes.
#pragma once

namespace processes
{

// The cores of this job: SLURM_CPUS_PER_TASK, NCPUS (PBS), NSLOTS (Grid Engine), LSB_DJOB_NUMPROC (LSF). 1 if none is
// set.
int scheduled_cores();

// Shares the cores: each process gets as many of Mesa's threads as there are cores for it, or none where that is one,
// so that it rasterises itself. LP_NUM_THREADS of the environment stays. To be called before the first context.
void share_mesa_threads(int processes, int cores);

}  // namespace processes
