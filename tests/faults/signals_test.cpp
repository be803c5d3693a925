// A signal arrives before each operation with which a subcommand of claque writes: it ends the command, every file is
// the older or the new one, and neither a draft nor a temporary folder is left. CLAQUE_FAULTS=thorough tries every
// operation; without it, fewer of those that are many.
#include <csignal>

#include "tests/faults/command_fixture.h"

namespace
{

using namespace command_faults;
using failing_files::Fault;
using failing_files::How;
using failing_files::Operation;

class CommandSignals : public CommandFixture
{
protected:
    void send_each(bool without_exchange)
    {
        int tried = 0;
        for (const Operation operation :
             {Operation::write, Operation::sync, Operation::rename, Operation::make_folder}) {
            for (uint64_t n = 1; !HasFailure(); n += is_thorough() || n < 2 ? 1 : n) {
                SCOPED_TRACE("operation " + std::to_string(static_cast<int>(operation)) + ", number " +
                             std::to_string(n));
                put_older();
                const int number = n % 2 ? SIGINT : SIGTERM;
                cli_test::Outcome outcome;
                if (!run({operation, n, How::signal, number, false, without_exchange}, outcome)) {
                    EXPECT_EQ(outcome.code, 0) << outcome.err;
                    break;
                }
                ++tried;
                EXPECT_EQ(outcome.signal, number) << outcome.code << ": " << outcome.err;
                expect_whole_or_older(false);
                ASSERT_LT(n, 1000u);
                if (n == 2 && subcommand().is_slow && !is_thorough()) break;
            }
        }
        EXPECT_GE(tried, 3);
        RecordProperty("signals", tried);
    }
};

TEST_P(CommandSignals, EndTheCommandAtAnyWriteAndLeaveNoDraft) { send_each(false); }

// Those that write files, the slow ones only if all is to be tried: quicker ones share their code.
std::vector<size_t> writers()
{
    std::vector<size_t> found;
    for (size_t i = 0; i < subcommands().size(); ++i) {
        const Subcommand &one = subcommands()[i];
        if (one.is_slow && !one.is_for_signals && !is_thorough()) continue;
        for (const std::string &word : one.words)
            if (word[0] == '>' && (found.empty() || found.back() != i)) found.push_back(i);
    }
    return found;
}

INSTANTIATE_TEST_SUITE_P(Of, CommandSignals, testing::ValuesIn(writers()), name_of);

using FolderSignals = CommandSignals;

TEST_P(FolderSignals, DoTheSameWhereFoldersCannotBeExchanged) { send_each(true); }

INSTANTIATE_TEST_SUITE_P(Of, FolderSignals, testing::ValuesIn(a_capture()), name_of);

}  // namespace
