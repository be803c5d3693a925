// The clocks of claque bench: processor time stands still while the process sleeps, and reports name their clock.
#include "samples/cli/stopwatch.h"

#include <thread>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using BenchClock = cli::Stopwatch::Clock;

class ClocksOfBench : public Command
{
protected:
    ~ClocksOfBench() override { cli::Stopwatch::use(BenchClock::wall); }
};

TEST_F(ClocksOfBench, ProcessorTimeStandsStillWhileTheProcessSleeps)
{
    const cli::Stopwatch wall;
    cli::Stopwatch::use(BenchClock::processor);
    const cli::Stopwatch processor;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const double used_ms = processor.ms();
    EXPECT_GE(wall.ms(), 200) << "a stopwatch keeps the clock that it began with";
    EXPECT_LT(used_ms, 100);
    for (volatile unsigned i = 0; processor.ms() < used_ms + 5; ++i) continue;
    EXPECT_GE(processor.ms(), used_ms + 5);
}

TEST_F(ClocksOfBench, AReportNamesItsClock)
{
    const auto clock_of = [](const Outcome &done) {
        EXPECT_EQ(done.code, 0) << done.err;
        return nlohmann::json::parse(done.out).at("clock").get<std::string>();
    };
    EXPECT_EQ(clock_of(claque({"bench", "readers", "--count", "10", "--json"})), "wall");
    EXPECT_EQ(clock_of(claque({"bench", "readers", "--count", "10", "--json", "--clock", "processor"})), "processor");
    EXPECT_EQ(claque({"bench", "readers", "--clock", "sun"}).code, 2);
}

}  // namespace
}  // namespace cli_test
