// JSON of the samples: reading grows with the text, whatever it lists. This file is compiled with a call at each basic
// block. Its type of JSON is no other source's, so that the linker takes what is compiled here.
#include "samples/io/json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "work_counter.h"

namespace claque::testing
{
namespace
{

using CountedJson =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, int64_t, uint64_t, float>;

// Of a list of as many objects.
uint64_t parsing(size_t count)
{
    std::string text = "[";
    for (size_t i = 0; i < count; ++i) text += std::string(i ? "," : "") + R"({"a":[)" + std::to_string(i) + "]}";
    text += "]";
    return blocks_entered([&] {
        std::string problem;
        EXPECT_EQ(io::parse_json<CountedJson>(text, problem).size(), count);
        EXPECT_EQ(problem, "");
    });
}

TEST(JsonWork, GrowsWithTheTextWhateverItLists)
{
    const uint64_t few = parsing(300), many = parsing(3000);
    EXPECT_GT(few, 30000u) << "nothing is counted";
    EXPECT_LE(many, 16 * few);
}

TEST(JsonWork, EndsWhereTheTextIsTooDeep)
{
    std::string problem;
    const auto deep = [](int depth) { return std::string(size_t(depth), '[') + std::string(size_t(depth), ']'); };
    EXPECT_EQ(io::parse_json<CountedJson>(deep(64), problem).size(), 1u);
    EXPECT_TRUE(io::parse_json<CountedJson>(deep(65), problem).is_discarded());
    EXPECT_EQ(problem, "is nested more than 64 deep");
    // Brackets in texts are none.
    const std::string quoted = "[\"" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"]";
    EXPECT_EQ(io::parse_json<CountedJson>(quoted, problem).size(), 1u);
    EXPECT_EQ(problem, "");
    EXPECT_TRUE(io::parse_json<CountedJson>("[" + std::string(1, '"'), problem).is_discarded());
    EXPECT_EQ(problem, "is not JSON");
}

}  // namespace
}  // namespace claque::testing
