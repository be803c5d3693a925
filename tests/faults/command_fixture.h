// A subcommand of claque in a folder of its own, run with a fault at one of its operations on files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/run.h"
#include "tests/faults/failing_files.h"
#include "tests/faults/left_files.h"
#include "tests/faults/subcommands.h"

namespace command_faults
{

// CLAQUE_FAULTS=thorough: every operation is tried.
bool is_thorough();

// The parameter is an index of subcommands().
class CommandFixture : public testing::TestWithParam<size_t>
{
protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;

    static const std::filesystem::path &folder();  // has the folders `in` and `out`, and `tmp` for temporary files
    const Subcommand &subcommand() const { return subcommands()[GetParam()]; }
    const std::vector<std::string> &words() const { return subcommand().words; }
    std::vector<std::string> placed() const;  // the words, with paths
    void expect_done() const;

    // An older file or folder in the place of each that the command writes.
    void put_older() const;

    // Runs the command with the fault. Returns whether the fault was reached.
    bool run(const failing_files::Fault &fault, cli_test::Outcome &outcome) const;

    // Each file that is written is the older one or the whole new one; nothing else is left.
    void expect_whole_or_older(bool all_new) const;

    Files whole_, older_;  // after a run without a fault, and before one with it
    std::string printed_;

private:
    void make_needed() const;
    void put_first_picture() const;
    void expect_one_capture(const Files &now, const std::string &folder) const;
};

std::string name_of(const testing::TestParamInfo<size_t> &info);
std::vector<size_t> those_with_faults();  // all but those for signals alone
std::vector<size_t> a_capture();

}  // namespace command_faults
