// Numbers of files are what they say, or refused. Each library has a reader of TOML of its own, and all read the same.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lib/asset/toml_number.h"
#include "lib/stage/machine/toml_number.h"
#include "samples/io/json.h"
#include "samples/io/toml_number.h"
#include "samples/io/whole_number.h"

namespace
{

constexpr const char *rounded = ", a whole number that would be rounded: up to 9007199254740992 none is";

struct Case {
    std::string text;
    double value;       // where nothing is wrong
    std::string wrong;  // "": nothing
};

const Case cases[] = {
    {"0", 0, ""},
    {"-3", -3, ""},
    {"0.1", 0.1, ""},
    {"1e308", 1e308, ""},
    {"5e-324", 5e-324, ""},
    {"0x10", 16, ""},
    {"9007199254740992", 9007199254740992.0, ""},
    {"-9007199254740992", -9007199254740992.0, ""},
    {"9007199254740993", 0, "is 9007199254740993" + std::string(rounded)},
    {"9_007_199_254_740_993", 0, "is 9007199254740993" + std::string(rounded)},
    {"-9007199254740993", 0, "is -9007199254740993" + std::string(rounded)},
    {"0x20000000000001", 0, "is 9007199254740993" + std::string(rounded)},
    {"9007199254740994", 9007199254740994.0, ""},
    {"9223372036854774784", 9223372036854774784.0, ""},
    {"9223372036854775807", 0, "is 9223372036854775807" + std::string(rounded)},
    {"-9223372036854775807", 0, "is -9223372036854775807" + std::string(rounded)},
    {"-9223372036854775808", -9223372036854775808.0, ""},
    {"9223372036854775808", 0, "not TOML"},
    {"-9223372036854775809", 0, "not TOML"},
    {"99999999999999999999999", 0, "not TOML"},
    {"1e400", 0, "not TOML"},
    {"1e-400", 0, "not TOML"},
    {"inf", 0, "is not finite"},
    {"-inf", 0, "is not finite"},
    {"nan", 0, "is not finite"},
    {"true", 0, "is not a number"},
    {"'1'", 0, "is not a number"},
    {"[1]", 0, "is not a number"},
    {"{ a = 1 }", 0, "is not a number"},
    {"1979-05-27", 0, "is not a number"},
};

using Reader = double (*)(const toml::node &node, std::string &wrong);

class NumberReader : public testing::TestWithParam<std::pair<const char *, Reader>>
{
};

TEST_P(NumberReader, TakesWhatADoubleHoldsAndSaysWhatIsWrongWithTheRest)
{
    for (const Case &one : cases) {
        const toml::parse_result parsed = toml::parse("x = " + one.text);
        std::string wrong = "not TOML";
        const double value = parsed ? GetParam().second(*parsed.table().get("x"), wrong) : 0;
        EXPECT_EQ(wrong, one.wrong) << one.text;
        if (one.wrong.empty()) EXPECT_EQ(value, one.value) << one.text;
        else EXPECT_FALSE(parsed && std::isfinite(value)) << one.text;
    }
}

INSTANTIATE_TEST_SUITE_P(All, NumberReader,
                         testing::Values(std::pair("assets", claque::asset::number_in),
                                         std::pair("stage", claque::stage::number_in),
                                         std::pair("samples", io::number_in)),
                         [](const auto &one) { return std::string(one.param.first); });

TEST(JsonNumber, IsWholeAndWithinItsLimitsOrNone)
{
    const auto read = [](const char *text) { return io::whole_in(nlohmann::json::parse(text), -2, 300); };
    for (const auto &[text, value] :
         std::vector<std::pair<const char *, int64_t>>{{"0", 0}, {"-2", -2}, {"300", 300}, {"3e2", 300}, {"7.0", 7}})
        EXPECT_EQ(read(text), std::optional<int64_t>(value)) << text;
    for (const char *text : {"301", "-3", "1.5", "1e300", "-1e300", "4294967296", "4294967297", "18446744073709551615",
                             "18446744073709551616", "-9223372036854775808", "\"7\"", "true", "null", "[7]"})
        EXPECT_FALSE(read(text).has_value()) << text;
}

TEST(WholeNumber, HasEveryDigitOf64BitsOrIsNone)
{
    uint64_t value = 0;
    for (const auto &[text, expected] : std::vector<std::pair<const char *, uint64_t>>{
             {"0", 0}, {"010", 10}, {"9007199254740993", 9007199254740993u}, {"18446744073709551615", UINT64_MAX}}) {
        EXPECT_TRUE(io::read_whole_number(text, value)) << text;
        EXPECT_EQ(value, expected);
    }
    for (const char *text :
         {"", " 1", "1 ", "-1", "+1", "0x10", "1e3", "1.0", "one", "18446744073709551616", "99999999999999999999999"})
        EXPECT_FALSE(io::read_whole_number(text, value)) << text;
}

}  // namespace
