// The manual page of the command names everything that the command itself says it can do, and is set without a warning.
#include <set>

#include <gtest/gtest.h>

#include "tests/embed/scratch.h"
#include "tests/support/patterns.h"

namespace
{

std::set<std::string> all_of(const std::string &text, const std::string &pattern)
{
    std::set<std::string> found;
    for (const patterns::Match &match : patterns::matches(pattern, text)) found.insert(match[1]);
    return found;
}

std::string help_of(const std::string &subcommand)
{
    const auto [code, said] = Scratch().run(std::string("'") + CLAQUE_COMMAND "' " + subcommand + " --help");
    EXPECT_EQ(code, 0) << said;
    return said;
}

// As a reader sees it.
std::string manual()
{
    std::string text = text_of_file(CLAQUE_MAN);
    for (size_t at = 0; (at = text.find("\\-", at)) != std::string::npos; ++at) text.erase(at, 1);
    return text;
}

std::set<std::string> subcommands()
{
    const std::string help = help_of("");
    return all_of(help.substr(help.find("Subcommands:")), "\n  ([a-z][a-z-]*)");
}

TEST(Manual, HasASectionForEachSubcommandAndNoOther)
{
    const std::set<std::string> names = subcommands();
    ASSERT_GT(names.size(), 5u);
    EXPECT_EQ(all_of(manual(), "\n\\.SS claque ([a-z][a-z-]*)"), names);
}

TEST(Manual, NamesEachOptionOfEachSubcommandInItsSection)
{
    const std::string text = manual();
    for (const std::string &name : subcommands()) {
        const size_t from = text.find("\n.SS claque " + name + "\n"), to = text.find("\n.S", from + 1);
        ASSERT_NE(from, std::string::npos) << name;
        const std::string section = text.substr(from, to - from);
        const std::set<std::string> options = all_of(help_of(name), "\n  (?:-[a-z],)?(--[a-z-]+)");
        ASSERT_FALSE(options.empty()) << name;
        EXPECT_EQ(all_of(section, "\n\\.B (?:-[a-z],)?(--[a-z-]+)"), options) << name;
    }
}

TEST(Manual, IsSetWithoutAWarning)
{
    if (!has_command("groff")) GTEST_SKIP() << "needs groff";
    const auto [code, said] = Scratch().run("groff -man -Tutf8 -ww '" CLAQUE_MAN "' > page");
    EXPECT_EQ(code, 0);
    EXPECT_EQ(said, "");
}

}  // namespace
