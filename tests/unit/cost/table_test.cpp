// Tables as text, Markdown and JSON.
#include "samples/cost/table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace cost
{
namespace
{

const Table table = {"Heads", {"who", "count", "why"}, {{"a|b", Figure{12345.0}, "x"}, {"c", "", "y"}}, {"So."}};

TEST(Tables, NumbersAreGroupedInThrees)
{
    EXPECT_EQ(text_of(figure(4206240)), "4 206 240");
    EXPECT_EQ(text_of(figure(999)), "999");
    EXPECT_EQ(text_of(figure(1000)), "1 000");
    EXPECT_EQ(text_of(figure(-123456)), "-123 456");
    EXPECT_EQ(text_of(figure(0.08)), "0.08");
    EXPECT_EQ(text_of(figure(1180.5)), "1 180.5");
    EXPECT_EQ(text_of(figure(1.0 / 3)), "0.33");
}

TEST(Tables, TextLinesUp)
{
    EXPECT_EQ(text_of(table),
              "Heads\n"
              "  who    count   why\n"
              "  a|b   12 345   x\n"
              "  c              y\n"
              "  So.\n");
}

TEST(Tables, MarkdownEscapesAndAligns)
{
    EXPECT_EQ(markdown_of(table),
              "**Heads**\n\n| who | count | why |\n|---|---:|---|\n| a\\|b | 12 345 | x |\n| c |  | y |\n\nSo.\n");
}

TEST(Tables, JsonKeepsNumbersAsNumbers)
{
    const auto json = json_of(table);
    EXPECT_EQ(json["rows"][0][1], 12345.0);
    EXPECT_EQ(json["rows"][1][1], "");
}

TEST(Tables, LinesBreakBetweenWordsAndNotWithinNumbers)
{
    EXPECT_EQ(wrapped("one two three", 8, ""), "one two\nthree");
    EXPECT_EQ(wrapped("is 35 290 here", 6, ""), "is\n35 290\nhere");
    EXPECT_EQ(wrapped("unbreakable it is", 4, ""), "unbreakable\nit\nis");
    EXPECT_EQ(wrapped("a note of words", 9, "  "), "a note\n  of\n  words");
}

}  // namespace
}  // namespace cost
