// Tolerances and verdicts.
#include <limits>

#include <gtest/gtest.h>

#include "samples/parity/measures.h"
#include "samples/parity/verdict.h"

namespace parity
{
namespace
{

std::string refusal(const std::string &toml)
{
    try {
        tolerance_from(toml, "t.toml");
        return "accepted";
    } catch (const Unreadable &error) {
        return error.what();
    }
}

Comparison comparison(std::vector<Measure> measures)
{
    Comparison c;
    c.measures = std::move(measures);
    c.not_compared = {{"depth", "the result has no depth.npy"}};
    return c;
}

TEST(Tolerances, EveryLimitNamesAMeasure)
{
    for (const Tolerance &t : named_tolerances())
        for (const Limit &limit : t.limits) EXPECT_TRUE(find_kind(limit.measure)) << t.name << ": " << limit.measure;
}

TEST(Tolerances, MayComeFromAFileAndBeginWithANamedOne)
{
    const Tolerance t = tolerance_from(
        "base = 'gpu'\nrequire = ['positions', 'depth']\n"
        "[at_most]\npositions.max_relative = 1e-5\n'colour.max' = 4\n"
        "[at_least]\ncolour.psnr_db = 40\n",
        "t.toml");
    EXPECT_EQ(t.required, tolerance_of("gpu").required) << "these are among what gpu requires";
    EXPECT_EQ(tolerance_from("base = 'loose'\nrequire = ['positions', 'depth']\n", "t.toml").required,
              (std::vector<std::string>{"positions", "depth"}));
    EXPECT_EQ(t.limits.size(), tolerance_of("gpu").limits.size() + 2);
    for (const Limit &limit : t.limits)
        if (limit.measure == "positions.max_relative") {
            EXPECT_EQ(limit.bound, 1e-5);
        }
}

TEST(Tolerances, ThatMakeNoSenseAreRefusedWithTheLine)
{
    EXPECT_EQ(refusal("[at_most]\ncolour.maxx = 1\n"), "t.toml, line 2: there is no measure 'colour.maxx'");
    EXPECT_EQ(refusal("[at_most]\ncolour.psnr_db = 1\n"), "t.toml, line 2: colour.psnr_db belongs into [at_least]");
    EXPECT_EQ(refusal("[at_least]\ncolour.max = 1\n"), "t.toml, line 2: colour.max belongs into [at_most]");
    EXPECT_EQ(refusal("[at_most]\ncolour.max = 'one'\n"), "t.toml, line 2: colour.max has to be a number");
    EXPECT_EQ(refusal("[at_most]\ncolour.max = nan\n"), "t.toml, line 2: colour.max has to be a number");
    EXPECT_EQ(refusal("[at_most]\ncolour.max = 9007199254740993\n"),
              "t.toml, line 2: colour.max is 9007199254740993, a whole number that would be rounded: up to "
              "9007199254740992 none is");
    EXPECT_EQ(refusal("[at_most]\ncolour.max = inf\n"), "accepted") << "no bound";
    EXPECT_EQ(refusal("\nrequire = 'depth'\n"), "t.toml, line 2: 'require' has to be a list of strings");
    EXPECT_EQ(refusal("require = ['deep']\n").substr(0, 56),
              "t.toml, line 1: 'require' may name actors, positions, no");
    EXPECT_EQ(refusal("base = 'best'\n"), "t.toml, line 1: 'base' may be exact, gpu, coarse or loose");
    EXPECT_EQ(refusal("max = 1\n"), "t.toml, line 1: 'max' is not one of base, require, [at_most] and [at_least]");
    EXPECT_EQ(refusal("# nothing\n"), "t.toml sets no limit");
    std::string deep = "# a key of many parts\n[a";
    for (int i = 0; i < 300000; ++i) deep += ".a";
    EXPECT_EQ(refusal(deep + "]\n"), "t.toml, line 2: a key has more than 16 parts");
    EXPECT_EQ(refusal("\u00DF = 1\n"), "t.toml, line 1: a letter outside of strings and comments is not ASCII");
    EXPECT_EQ(refusal("[at_most\n").substr(0, 14), "t.toml, line 1");
    EXPECT_THROW(tolerance_of("/nowhere/at.toml"), Unreadable);
    EXPECT_THROW(tolerance_of("/"), Unreadable);
}

TEST(Verdicts, PassAtTheLimitAndFailBeyond)
{
    const Tolerance t = tolerance_from("[at_most]\ncolour.max = 2\n[at_least]\ncolour.ssim = 0.9\n", "t.toml");
    EXPECT_TRUE(verdict_of(comparison({{"colour.max", 2, "", {}}, {"colour.ssim", 0.9, "", {}}}), t).pass);
    const Verdict worse = verdict_of(comparison({{"colour.max", 3, "", {}}, {"colour.ssim", 0.9, "", {}}}), t);
    EXPECT_FALSE(worse.pass);
    EXPECT_EQ(reasons(worse, 3), "colour.max is 3 (at most 2)");
    EXPECT_EQ(reasons(verdict_of(comparison({{"colour.max", 3, "", {}}, {"colour.ssim", 0.5, "", {}}}), t), 1),
              "colour.ssim is 0.5 (at least 0.9) and 1 more");
}

TEST(Verdicts, AValueThatIsNoNumberFails)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(verdict_of(comparison({{"colour.max", nan, "", {}}}), tolerance_of("exact")).pass);
    EXPECT_FALSE(verdict_of(comparison({{"colour.ssim", nan, "", {}}}), tolerance_of("loose")).pass);
}

TEST(Verdicts, RequestedDataMustBeCompared)
{
    const Comparison c = comparison({{"colour.max", 0, "", {}}});
    EXPECT_TRUE(verdict_of(c, tolerance_of("loose")).pass);
    const Verdict v = verdict_of(c, tolerance_from("base = 'loose'\nrequire = ['depth', 'colour']\n", "t.toml"));
    EXPECT_FALSE(v.pass);
    EXPECT_EQ(reasons(v, 3), "depth was not compared (the result has no depth.npy)");
}

TEST(Verdicts, ExactGpuAndCoarseRequireEveryGroup)
{
    for (const char *name : {"exact", "gpu", "coarse"})
        for (const std::string &group : measure_groups()) {
            Comparison c;
            c.not_compared = {{group, "neither has it"}};
            EXPECT_EQ(reasons(verdict_of(c, tolerance_of(name)), 3), group + " was not compared (neither has it)");
        }
}

}  // namespace
}  // namespace parity
