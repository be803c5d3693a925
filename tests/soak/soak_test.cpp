// A short soak, and that one sees a leak and a fresh run that shows something else.
#include "tests/soak/soak.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace soak
{
namespace
{

class Soak : public testing::Test
{
protected:
    void run_one(Plan plan)
    {
        plan.updates = 6000;
        outcome_ = run(plan);
        if (!outcome_.skipped.empty()) GTEST_SKIP() << outcome_.skipped;
    }
    bool says(const char *problem) const
    {
        return std::find(outcome_.problems.begin(), outcome_.problems.end(), problem) != outcome_.problems.end();
    }
    Outcome outcome_;
};

TEST_F(Soak, OfSomeThousandUpdatesStaysAsItIs)
{
    run_one({});
    EXPECT_EQ(outcome_.problems, std::vector<std::string>());
}

TEST_F(Soak, SeesWhatStaysInMemory)
{
    Plan plan;
    plan.leaks = true;
    run_one(plan);
    if (IsSkipped()) return;
    EXPECT_TRUE(says("the context's memory grows"));
    EXPECT_FALSE(says("what is shown differs from a fresh run"));
}

TEST_F(Soak, SeesAFreshRunThatShowsSomethingElse)
{
    Plan plan;
    plan.forgets = true;
    run_one(plan);
    if (IsSkipped()) return;
    EXPECT_TRUE(says("what is shown differs from a fresh run"));
    EXPECT_TRUE(says("a picture differs from a fresh run's"));
    EXPECT_FALSE(says("the context's memory grows"));
}

}  // namespace
}  // namespace soak
