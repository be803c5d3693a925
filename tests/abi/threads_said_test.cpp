// threads.py, where a change of a header can be tried against it.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

TEST(Docs, SayTheThreadsOfEachCall)
{
    const std::string source = CLAQUE_SOURCE_DIR;
    EXPECT_EQ(std::system(("'" + source + "/tests/abi/threads.py' '" + source + "'").c_str()), 0);
}
