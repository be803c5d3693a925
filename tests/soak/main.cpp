// soak [--updates N] [--seconds S] [--seed K]
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/soak/soak.h"

int main(int argc, char **argv)
{
    soak::Plan plan;
    for (int i = 1; i < argc; i += 2) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (std::strcmp(argv[i], "--updates") == 0) plan.updates = std::strtoull(value, nullptr, 10);
        else if (std::strcmp(argv[i], "--seconds") == 0) plan.seconds = std::strtod(value, nullptr);
        else if (std::strcmp(argv[i], "--seed") == 0) plan.seed = std::strtoull(value, nullptr, 10);
        else {
            std::fprintf(stderr, "soak [--updates N] [--seconds S] [--seed K]\n");
            return 2;
        }
    }
    testing::InitGoogleTest();
    const soak::Outcome outcome = soak::run(plan);
    if (!outcome.skipped.empty()) std::fprintf(stderr, "soak: %s\n", outcome.skipped.c_str());
    for (const std::string &problem : outcome.problems) std::fprintf(stderr, "soak: %s\n", problem.c_str());
    return outcome.problems.empty() ? outcome.skipped.empty() ? 0 : 77 : 1;
}
