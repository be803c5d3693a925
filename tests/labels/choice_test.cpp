// Choices of samples: between their limits, all of them, and each a function of its seed, its number and its rule.
#include "samples/labels/variation/choice.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "samples/labels/variation/chance.h"

namespace
{

using labels::Choice;
using labels::choose;
using labels::Rules;

Rules some_rules()
{
    Rules rules;
    rules.time_s = {{10, 20}};
    rules.count = {{3, 5}};
    rules.hour = {{6, 18}};
    rules.jpeg_quality = {{40, 42}};
    rules.colours = {"a", "b", "c"};
    return rules;
}

TEST(Choices, LieBetweenTheirLimitsAndReachThem)
{
    const Rules rules = some_rules();
    std::set<uint32_t> counts;
    std::set<int> qualities;
    std::set<std::string> files;
    std::set<uint32_t> seeds;
    double least = 99, most = 0, sum = 0;
    for (uint32_t sample = 0; sample < 1000; ++sample) {
        const Choice choice = choose(rules, 5, sample, 0);
        EXPECT_GE(choice.time_s, 10);
        EXPECT_LT(choice.time_s, 20);
        least = std::min(least, *choice.hour), most = std::max(most, *choice.hour), sum += *choice.hour;
        counts.insert(*choice.count), qualities.insert(*choice.jpeg_quality), files.insert(choice.colours);
        seeds.insert(choice.scene_seed);
    }
    EXPECT_LT(least, 6.1);
    EXPECT_GT(most, 17.9);
    EXPECT_NEAR(sum / 1000, 12, 0.5);
    EXPECT_EQ(counts, (std::set<uint32_t>{3, 4, 5}));
    EXPECT_EQ(qualities, (std::set<int>{40, 41, 42}));
    EXPECT_EQ(files.size(), 3u);
    EXPECT_EQ(seeds.size(), 1000u);
}

TEST(Choices, DependOnSeedNumberAndTheirRuleAlone)
{
    const Rules rules = some_rules();
    const auto text = [](const Choice &choice) { return labels::choice_json(choice).dump(); };
    EXPECT_EQ(text(choose(rules, 5, 7, 0)), text(choose(rules, 5, 7, 3)));
    EXPECT_NE(text(choose(rules, 5, 7, 0)), text(choose(rules, 5, 8, 0)));
    EXPECT_NE(choose(rules, 5, 7, 0).hour, choose(rules, 6, 7, 0).hour);
    Rules more = rules;
    more.sun = {{0, 1}}, more.read_noise = {{0, 9}};
    more.count.reset();
    EXPECT_EQ(choose(more, 5, 7, 0).hour, choose(rules, 5, 7, 0).hour);
    EXPECT_EQ(choose(more, 5, 7, 0).scene_seed, choose(rules, 5, 7, 0).scene_seed);
    EXPECT_EQ(choose(more, 5, 7, 0).colours, choose(rules, 5, 7, 0).colours);
}

TEST(Choices, OfTwoRulesAreIndependent)
{
    double both = 0;
    for (uint32_t sample = 0; sample < 4000; ++sample)
        both += (labels::chance(1, sample, "light.sun") < 0.5) == (labels::chance(1, sample, "light.sky") < 0.5);
    EXPECT_NEAR(both / 4000, 0.5, 0.04);
}

TEST(Choices, WithoutRulesAreTheTimeAndTheSeedOfTheScene)
{
    const Choice choice = choose(Rules(), 5, 7, 2.5);
    EXPECT_EQ(choice.time_s, 2.5);
    EXPECT_EQ(labels::choice_json(choice).size(), 4u);  // seed, sample, scene_seed, time_s
}

}  // namespace
