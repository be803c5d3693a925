// Each allocation of each call of the C API fails once: the call says so, nothing has changed, and the next call gives
// what it would have given. CLAQUE_FAULTS=thorough fails allocations 1 to 200 and then every tenth part further, and
// each place that allocates; without it, fewer.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "tests/faults/campaign.h"
#include "tests/support/patterns.h"

namespace faults
{
namespace
{

bool is_thorough()
{
    const char *effort = std::getenv("CLAQUE_FAULTS");
    return effort && std::string(effort) == "thorough";
}

// Without Recast the calls for grounds and walkers are not there.
bool is_absent([[maybe_unused]] const std::filesystem::path &header)
{
#ifdef CLAQUE_HAS_NAVIGATION
    return false;
#else
    return header.filename() == "navigation.h";
#endif
}

std::set<std::string> declared()
{
    std::set<std::string> names;
    const std::string call = R"(CLQ_API [^;(]*?(clq_\w+)\()";
    for (const auto &header : std::filesystem::directory_iterator(CLAQUE_SOURCE_DIR "/include/claque")) {
        if (is_absent(header.path())) continue;
        std::stringstream text;
        text << std::ifstream(header.path()).rdbuf();
        for (const patterns::Match &found : patterns::matches(call, text.str())) names.insert(found[1]);
    }
    return names;
}

TEST(FaultTable, HoldsEveryDeclaredCall)
{
    std::set<std::string> listed;
    for (const Call &call : calls()) listed.insert(call.name);
    const std::set<std::string> all = declared();
    std::vector<std::string> missing, extra;
    std::set_difference(all.begin(), all.end(), listed.begin(), listed.end(), std::back_inserter(missing));
    std::set_difference(listed.begin(), listed.end(), all.begin(), all.end(), std::back_inserter(extra));
    EXPECT_EQ(missing, std::vector<std::string>());
    EXPECT_EQ(extra, std::vector<std::string>());
}

// One world for all: each call is tried in a child process.
World &world()
{
    static const std::unique_ptr<World> one = std::make_unique<World>();
    return *one;
}

class EachCall : public testing::TestWithParam<size_t>
{
};

TEST_P(EachCall, SurvivesEachAllocationThatFails)
{
    const Call &call = calls()[GetParam()];
    const Outcome outcome = try_call(world(), call, is_thorough() ? thorough : brief);
    EXPECT_EQ(outcome.problem, "");
    if (call.traits & quiet) {
        EXPECT_EQ(outcome.allocations, 0u) << "it is listed as one that allocates nothing";
    } else {
        EXPECT_GT(outcome.faults, 0u) << "it never allocated: this test saw nothing";
    }
    EXPECT_EQ(outcome.failed_places, outcome.places) << "places that allocate and were never failed";
    RecordProperty("faults", static_cast<int>(outcome.faults));
    std::printf("faults: %s %s: %llu allocations, %llu failed, %llu of them done without, %llu of %llu places\n",
                call.name.c_str(), call.variant.c_str(), static_cast<unsigned long long>(outcome.allocations),
                static_cast<unsigned long long>(outcome.faults), static_cast<unsigned long long>(outcome.did_without),
                static_cast<unsigned long long>(outcome.failed_places),
                static_cast<unsigned long long>(outcome.places));
}

INSTANTIATE_TEST_SUITE_P(Faults, EachCall, testing::Range(size_t(0), calls().size()), [](const auto &named) {
    std::string name = calls()[named.param].name;
    if (!calls()[named.param].variant.empty()) name += "_" + calls()[named.param].variant;
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

}  // namespace
}  // namespace faults
