// How many cores of a machine each of several processes takes. In a job of a scheduler (Slurm, PBS, Grid Engine, LSF)
// they share what the job got: the other cores belong to other jobs.
#pragma once

namespace processes
{

bool is_scheduled();
// The number that the scheduler tells: SLURM_CPUS_PER_TASK, NCPUS (PBS), NSLOTS (Grid Engine),
// LSB_DJOB_NUMPROC (LSF). 1 if none is set.
int scheduled_cores();

// At least 1. `machine_cores`: all of this machine, which count without a scheduler.
int cores_of_worker(int workers, int machine_cores);  // of those that one process starts
// Slurm counts the cores of each rank, PBS those of all ranks on a machine, Grid Engine and LSF those of the job.
int cores_of_rank(int ranks, int ranks_here, int machine_cores);

// Mesa gets as many threads as this process has cores, or none where that is one, so that it rasterises itself. The
// last call before the first context counts, unless LP_NUM_THREADS was set before the first call.
void take_mesa_threads(int cores);

}  // namespace processes
