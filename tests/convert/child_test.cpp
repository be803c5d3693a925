// Work in a process of its own: what it returns, and every way in which it may end.
#include "samples/convert/child.h"

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "samples/scenes/check.h"

namespace convert_test
{
namespace
{

std::string failure_of(const convert::Limits &limits, const std::function<std::string()> &work)
{
    try {
        convert::run_in_child("The work", limits, work);
    } catch (const scenes::Failure &failure) {
        return failure.what();
    }
    return "none";
}

TEST(Child, BringsBackAllBytes)
{
    std::string large(5000000, 'x');
    large[17] = '\0';
    EXPECT_EQ(convert::run_in_child("The work", {}, [&] { return large; }), large);
    EXPECT_EQ(convert::run_in_child("The work", {}, [] { return std::string(); }), "");
}

TEST(Child, SaysWhatWasThrown)
{
    EXPECT_EQ(failure_of({}, []() -> std::string { throw std::runtime_error("no such joint"); }),
              "The work: no such joint");
    EXPECT_EQ(failure_of({}, []() -> std::string { throw 7; }), "The work: failed without a reason");
}

TEST(Child, SaysThatItCrashed)
{
    const auto crash = [] {
        std::signal(SIGSEGV, SIG_DFL);  // AddressSanitizer has a handler of its own
        return std::raise(SIGSEGV), std::string();
    };
    EXPECT_NE(failure_of({}, crash).find("SIGSEGV"), std::string::npos);
    EXPECT_NE(failure_of({}, []() -> std::string { std::abort(); }).find("SIGABRT"), std::string::npos);
    EXPECT_EQ(failure_of({}, []() -> std::string { std::_Exit(3); }), "The work ended with code 3");
}

TEST(Child, IsStoppedWhenItsTimeIsUp)
{
    convert::Limits limits;
    limits.seconds = 1;
    const auto sleep = [] { return std::this_thread::sleep_for(std::chrono::hours(1)), std::string(); };
    EXPECT_EQ(failure_of(limits, sleep), "The work was stopped after 1 s");
}

TEST(Child, HasNoMoreOfTheProcessorThanOfTheClock)
{
    convert::Limits limits;
    limits.seconds = 7;
    const auto read_limit = [] {
        rlimit found = {};
        getrlimit(RLIMIT_CPU, &found);
        return std::to_string(found.rlim_cur) + " and " + std::to_string(found.rlim_max);
    };
    EXPECT_EQ(convert::run_in_child("The work", limits, read_limit), "7 and 7");
    const auto is_over = [] { return std::raise(SIGXCPU), std::string(); };
    EXPECT_EQ(failure_of(limits, is_over), "The work was stopped after 7 s");
}

TEST(Child, TakesNoMoreMemoryThanAllowed)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers reserve more address space than any limit";
#endif
    convert::Limits limits;
    limits.memory_bytes = 256u << 20;
    const auto hungry = [] {
        std::vector<std::vector<char>> all;
        for (;;) all.emplace_back(16u << 20, 'x');
        return std::string();
    };
    EXPECT_EQ(failure_of(limits, hungry), "The work: needs more memory than it may take");
}

}  // namespace
}  // namespace convert_test
