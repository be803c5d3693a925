// Each operation on a file that a subcommand of claque makes fails once: the command ends with one sentence that names
// the file, what was there before is still there, and nothing else is left. CLAQUE_FAULTS=thorough fails every
// operation; without it, fewer of those that are many, and for a command that takes seconds only the first of each
// kind.
#include "tests/faults/command_fixture.h"
#include "tests/faults/fault_kinds.h"

namespace
{

using cli_test::claque;
using cli_test::Outcome;
using namespace command_faults;
using Words = std::vector<std::string>;

class CommandFaults : public CommandFixture
{
protected:
    void judge(const Kind &kind, const Outcome &outcome) const
    {
        const bool failed = outcome.code != 0;
        if (kind.is_fault && !subcommand().recovers) {
            EXPECT_TRUE(failed) << "the fault went unnoticed";
        }
        if (!kind.is_fault && kind.operation != Operation::close) {
            EXPECT_FALSE(failed) << outcome.err;
        }
        expect_whole_or_older(!failed);
        if (!failed) return;
        EXPECT_TRUE(outcome.code == 1 || outcome.code == 2) << outcome.code;
        const std::string last = last_line(outcome.err);  // after reports and warnings
        EXPECT_EQ(last.rfind("claque: ", 0), 0u) << outcome.err;
        EXPECT_NE(last.find(folder().string() + "/"), std::string::npos) << outcome.err;
        if (!subcommand().goes_on) return;
        expect_done();
        expect_whole_or_older(true);
    }

    void fail_each(bool without_exchange)
    {
        uint64_t tried = 0;
        for (const Kind &kind : kinds) {
            if (!kind.is_fault && subcommand().is_slow && !is_thorough()) continue;
            for (uint64_t n = 1;; n += is_thorough() ? 1 : 3 * n) {
                SCOPED_TRACE(std::string(kind.name) + ", number " + std::to_string(n));
                put_older();
                Outcome outcome;
                if (!run({kind.operation, n, kind.how, kind.error, false, without_exchange}, outcome)) {
                    EXPECT_EQ(outcome.code, 0) << outcome.err;
                    break;
                }
                ++tried;
                judge(kind, outcome);
                if (HasFailure()) return;
                ASSERT_LT(n, 1000u);
                const bool once = !kind.is_fault || kind.how == How::for_good || subcommand().is_slow;
                if (once && !is_thorough()) break;
            }
        }
        EXPECT_GT(tried, 3u);
        RecordProperty("faults", static_cast<int>(tried));
    }
};

TEST_P(CommandFaults, EndWithASentenceAndLeaveWhatWasThere) { fail_each(false); }

INSTANTIATE_TEST_SUITE_P(Of, CommandFaults, testing::ValuesIn(those_with_faults()), name_of);

using FolderFaults = CommandFaults;

TEST_P(FolderFaults, AreTheSameWhereFoldersCannotBeExchanged) { fail_each(true); }

INSTANTIATE_TEST_SUITE_P(Of, FolderFaults, testing::ValuesIn(a_capture()), name_of);

using FullDisk = CommandFaults;

// What is printed, and every file that can be written, by itself.
TEST_P(FullDisk, IsNamedAndLeavesWhatWasThere)
{
    if (!printed_.empty()) {
        const Outcome outcome = claque(placed(), "/dev/full");
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(last_line(outcome.err), "claque: standard output could not be written.\n");
    }
    for (size_t i = 0; i < words().size(); ++i) {
        if (words()[i][0] != '>' || words()[i].back() == '/') continue;
        put_older();
        Words all = placed();
        all[i] = "/dev/full";
        const Outcome outcome = claque(all);
        EXPECT_EQ(outcome.code, 1) << words()[i];
        EXPECT_EQ(last_line(outcome.err), "claque: /dev/full could not be written: No space left on device.\n");
        for (const auto &[name, text] : files_below(folder() / "out")) {
            EXPECT_TRUE(older_.count(name) || (subcommand().goes_on && whole_.count(name))) << name << " is left";
        }
        if (subcommand().is_slow && !is_thorough()) continue;
        all[i] = "-";
        const Outcome streamed = claque(all, "/dev/full");
        EXPECT_NE(streamed.code, 0) << words()[i] << " to a standard output that is full";
        EXPECT_NE(streamed.err.find("standard output"), std::string::npos) << streamed.err;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FullDisk, testing::ValuesIn(those_with_faults()), name_of);

}  // namespace
