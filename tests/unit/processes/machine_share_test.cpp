// Processes of one job share the cores that the job got, whatever its scheduler counts.
#include "samples/processes/machine_share.h"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace processes
{
namespace
{

class MachineShare : public testing::Test
{
protected:
    void SetUp() override { forget(); }
    void TearDown() override { forget(); }
    static void forget()
    {
        for (const char *name : {"SLURM_JOB_ID", "SLURM_CPUS_PER_TASK", "PBS_JOBID", "NCPUS", "SGE_TASK_ID", "NSLOTS",
                                 "LSB_JOBID", "LSB_DJOB_NUMPROC"})
            unsetenv(name);
    }
    static void schedule(const char *job, const char *cores, const char *count)
    {
        forget();
        setenv(job, "7", 1);
        setenv(cores, count, 1);
    }
};

TEST_F(MachineShare, IsThatOfTheMachineWithoutAScheduler)
{
    setenv("NCPUS", "3", 1);  // some shells set it
    EXPECT_FALSE(is_scheduled());
    EXPECT_EQ(cores_of_worker(2, 16), 8);
    EXPECT_EQ(cores_of_worker(3, 2), 1);
    EXPECT_EQ(cores_of_rank(8, 4, 16), 4) << "four ranks on each of two machines";
}

TEST_F(MachineShare, OfForkedProcessesIsThatOfTheJob)
{
    for (const auto &[job, cores] : {std::pair("SLURM_JOB_ID", "SLURM_CPUS_PER_TASK"), std::pair("PBS_JOBID", "NCPUS"),
                                     std::pair("SGE_TASK_ID", "NSLOTS"), std::pair("LSB_JOBID", "LSB_DJOB_NUMPROC")}) {
        schedule(job, cores, "12");
        EXPECT_TRUE(is_scheduled());
        EXPECT_EQ(scheduled_cores(), 12) << cores;
        EXPECT_EQ(cores_of_worker(3, 64), 4) << cores;
        unsetenv(cores);
        EXPECT_EQ(cores_of_worker(3, 64), 1) << "a job that is not told its cores has one";
        EXPECT_EQ(cores_of_rank(3, 3, 64), 1);
    }
}

// Eight ranks, four on each of two machines.
TEST_F(MachineShare, OfARankFollowsWhatItsSchedulerCounts)
{
    schedule("SLURM_JOB_ID", "SLURM_CPUS_PER_TASK", "6");
    EXPECT_EQ(cores_of_rank(8, 4, 64), 6) << "cores of each rank";
    schedule("PBS_JOBID", "NCPUS", "24");
    EXPECT_EQ(cores_of_rank(8, 4, 64), 6) << "cores of all ranks of a machine";
    schedule("SGE_TASK_ID", "NSLOTS", "48");
    EXPECT_EQ(cores_of_rank(8, 4, 64), 6) << "cores of the whole job";
    schedule("LSB_JOBID", "LSB_DJOB_NUMPROC", "4");
    EXPECT_EQ(cores_of_rank(8, 4, 64), 1);
}

// In a process of its own, as what the environment was is remembered.
TEST_F(MachineShare, GivesMesaThreadsUnlessTheEnvironmentDoes)
{
    const auto says = [](const char *before, int first, int then) {
        if (before) setenv("LP_NUM_THREADS", before, 1);
        else unsetenv("LP_NUM_THREADS");
        take_mesa_threads(first);
        take_mesa_threads(then);
        std::exit(std::atoi(std::getenv("LP_NUM_THREADS")));
    };
    EXPECT_EXIT(says(nullptr, 1, 4), testing::ExitedWithCode(4), "");
    EXPECT_EXIT(says(nullptr, 4, 1), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(says("3", 4, 1), testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace processes
