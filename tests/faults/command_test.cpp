// Each operation on a file that a subcommand of claque makes fails once: the command ends with one sentence that names
// the file, what was there before is still there, and nothing else is left. CLAQUE_FAULTS=thorough fails every
// operation; without it, fewer of those that are many, and for a command that takes seconds only the first of each
// kind.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/cli/run.h"
#include "tests/faults/failing_files.h"
#include "tests/faults/fault_kinds.h"
#include "tests/faults/left_files.h"
#include "tests/faults/subcommands.h"

namespace
{

namespace fs = std::filesystem;
using cli_test::claque;
using cli_test::Outcome;
using namespace command_faults;
using failing_files::Fault;
using failing_files::How;
using failing_files::Operation;
using Words = std::vector<std::string>;

bool is_thorough()
{
    const char *effort = std::getenv("CLAQUE_FAULTS");
    return effort && std::string(effort) == "thorough";
}

fs::path the_folder;

std::string place_of(const std::string &word)
{
    if (word[0] == '<') return the_folder / "in" / word.substr(1);
    if (word[0] == '>') return the_folder / "out" / word.substr(1);
    return word;
}

Words placed(const Words &words)
{
    Words all;
    for (const std::string &word : words) all.push_back(place_of(word));
    return all;
}

void expect_done(const Words &words, std::string *printed = nullptr)
{
    const Outcome done = claque(placed(words));
    if (printed) *printed = done.out;
    ASSERT_EQ(done.code, 0) << words[0] << ": " << done.err;
}

class CommandFaults : public testing::TestWithParam<size_t>
{
protected:
    static void SetUpTestSuite()
    {
        std::string name = testing::TempDir() + "claque-commands-XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        the_folder = fs::path(name) / "files";
        for (const char *below : {"in", "out"}) fs::create_directories(the_folder / below);
        // Failures of the cache are no failures of the command: it lies outside what is watched.
        setenv("XDG_CACHE_HOME", (name + "/cache").c_str(), 1);
        command_faults::make_inputs(the_folder / "in");
    }
    static void TearDownTestSuite() { fs::remove_all(the_folder.parent_path()); }

    void SetUp() override
    {
        if (subcommand().draws && !cli_test::why_no_context("any").empty())
            GTEST_SKIP() << cli_test::why_no_context("any");
        make_needed();
        if (HasFatalFailure()) return;
        fs::remove_all(the_folder / "out");
        fs::create_directory(the_folder / "out");
        expect_done(words(), &printed_);
        whole_ = files_below(the_folder / "out");
        put_older();
        older_ = files_below(the_folder / "out");
    }

    const Subcommand &subcommand() const { return subcommands()[GetParam()]; }
    const Words &words() const { return subcommand().words; }

    // Inputs that the command itself writes.
    void make_needed() const
    {
        const auto needs = [&](const char *name) {
            return std::find(words().begin(), words().end(), name) != words().end() && !fs::exists(place_of(name));
        };
        if (needs("<p.clq")) expect_done({"prepare", "<p.glb", "--out", "<p.clq"});
        if (needs("<p.toml")) expect_done({"colours", "save", "<p.glb", "--out", "<p.toml"});
        if (needs("<z.png"))
            expect_done({"prepare", "citizen", "--propose", "2", "--zones-out", "<z.png", "--out", "<z.clq"});
        if (needs("<counts.json"))
            expect_done(
                {"bench", "hundred_actors", "--frames", "1", "--size", "32x24", "--operations", "<counts.json"});
        for (const char *folder : {"<a/", "<b/"})
            if (needs(folder))
                expect_done({"parity", "capture", "<p.glb", "--count", "2", "--size", "32x24", "--out", folder});
    }

    // An older file or folder in the place of each that the command writes.
    void put_older() const
    {
        fs::remove_all(the_folder / "out");
        fs::create_directory(the_folder / "out");
        for (const std::string &word : words()) {
            if (word[0] != '>') continue;
            if (word.back() == '/' && subcommand().goes_on) put_first_picture();
            else if (word.back() == '/') {
                fs::create_directory(place_of(word));
                std::ofstream(place_of(word) + "capture.json") << "older";
                std::ofstream(place_of(word) + "atlas.npy") << "older";
            } else {
                std::ofstream(place_of(word)) << "older";
            }
        }
    }

    // What a run that was stopped before its second picture leaves, and older files about all pictures.
    void put_first_picture() const
    {
        for (const auto &[name, text] : whole_) {
            if (text == "/" || name.find('/') == std::string::npos || name.find("000001") != std::string::npos)
                continue;
            const fs::path path = the_folder / "out" / name;
            fs::create_directories(path.parent_path());
            const bool is_of_all = path.parent_path().parent_path() == the_folder / "out";
            std::ofstream(path) << (is_of_all && path.filename() != "settings.json" ? "older" : text);
        }
    }

    // Runs the command with the fault. Returns whether the fault was reached.
    bool run(const Fault &fault, Outcome &outcome) const
    {
        const std::string reached = the_folder.parent_path() / "reached";
        fs::remove(reached);
        const std::string text = the_folder.string() + "/\n" + std::to_string(static_cast<int>(fault.operation)) + " " +
                                 std::to_string(fault.n) + " " + std::to_string(static_cast<int>(fault.how)) + " " +
                                 std::to_string(fault.error) + " " + std::to_string(fault.without_exchange);
        setenv("CLAQUE_FAULT", text.c_str(), 1);
        setenv("CLAQUE_FAULT_REACHED", reached.c_str(), 1);
        setenv("LD_PRELOAD", CLAQUE_FAILING_FILES, 1);
        setenv("ASAN_OPTIONS", "intercept_tls_get_addr=0:verify_asan_link_order=0", 1);
        outcome = claque(placed(words()));
        unsetenv("LD_PRELOAD"), unsetenv("CLAQUE_FAULT");
        return fs::exists(reached);
    }

    // Each file that is written is the older one or the whole new one.
    void expect_whole_or_older(bool all_new) const
    {
        const Files now = files_below(the_folder / "out");
        for (const auto &[name, text] : now) {
            const auto made = whole_.find(name), before = older_.find(name);
            const bool has_times = name.find('/') == std::string::npos;
            const bool is_new =
                made != whole_.end() &&
                (text == made->second || (has_times && without_times(name, text) == without_times(name, made->second)));
            const bool is_older = before != older_.end() && text == before->second;
            EXPECT_TRUE(is_new || (is_older && !all_new)) << name << " of " << text.size() << " bytes";
        }
        if (all_new) {
            EXPECT_EQ(now.size(), whole_.size());
        } else {
            for (const auto &[name, text] : older_)
                if (fs::path(name).has_extension() && (subcommand().goes_on || name.find('/') == std::string::npos)) {
                    EXPECT_TRUE(now.count(name)) << name << " is gone";
                }
        }
        for (const std::string &word : words())
            if (word[0] == '>' && word.back() == '/' && !subcommand().goes_on) expect_one_capture(now, word.substr(1));
    }

    // No mixture of an older capture and a newer one.
    void expect_one_capture(const Files &now, const std::string &folder) const
    {
        const auto below = [&](const Files &all) {
            Files some;
            for (const auto &[name, text] : all)
                if (name.compare(0, folder.size(), folder) == 0) some.emplace(name, text);
            return some;
        };
        EXPECT_TRUE(below(now) == below(older_) || below(now) == below(whole_)) << folder;
    }

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
        EXPECT_NE(last.find(the_folder.string() + "/"), std::string::npos) << outcome.err;
        if (!subcommand().goes_on) return;
        expect_done(words());
        expect_whole_or_older(true);
    }

    void fail_each(bool without_exchange)
    {
        uint64_t tried = 0;
        for (const Kind &kind : kinds) {
            if (!kind.is_fault && subcommand().is_slow && !is_thorough()) continue;
            for (uint64_t n = 1;; n += is_thorough() || n < 2 ? 1 : n) {
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

    Files whole_, older_;
    std::string printed_;
};

TEST_P(CommandFaults, EndWithASentenceAndLeaveWhatWasThere) { fail_each(false); }

std::string name_of(const testing::TestParamInfo<size_t> &info) { return subcommands()[info.param].name; }

INSTANTIATE_TEST_SUITE_P(Of, CommandFaults, testing::Range(size_t(0), subcommands().size()), name_of);

using FolderFaults = CommandFaults;

TEST_P(FolderFaults, AreTheSameWhereFoldersCannotBeExchanged) { fail_each(true); }

INSTANTIATE_TEST_SUITE_P(Of, FolderFaults, testing::ValuesIn([] {
                             std::vector<size_t> found;
                             for (size_t i = 0; i < subcommands().size(); ++i)
                                 if (std::string(subcommands()[i].name).rfind("parity_c", 0) == 0 && found.empty())
                                     found.push_back(i);
                             return found;
                         }()),
                         name_of);

using FullDisk = CommandFaults;

// What is printed, and every file that can be written, by itself.
TEST_P(FullDisk, IsNamedAndLeavesWhatWasThere)
{
    if (!printed_.empty()) {
        const Outcome outcome = claque(placed(words()), "/dev/full");
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(last_line(outcome.err), "claque: standard output could not be written.\n");
    }
    for (size_t i = 0; i < words().size(); ++i) {
        if (words()[i][0] != '>' || words()[i].back() == '/') continue;
        put_older();
        Words all = placed(words());
        all[i] = "/dev/full";
        const Outcome outcome = claque(all);
        EXPECT_EQ(outcome.code, 1) << words()[i];
        EXPECT_EQ(last_line(outcome.err), "claque: /dev/full could not be written: No space left on device.\n");
        for (const auto &[name, text] : files_below(the_folder / "out")) {
            EXPECT_TRUE(older_.count(name) || (subcommand().goes_on && whole_.count(name))) << name << " is left";
        }
        if (subcommand().is_slow && !is_thorough()) continue;
        all[i] = "-";
        const Outcome streamed = claque(all, "/dev/full");
        EXPECT_NE(streamed.code, 0) << words()[i] << " to a standard output that is full";
        EXPECT_NE(streamed.err.find("standard output"), std::string::npos) << streamed.err;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FullDisk, testing::Range(size_t(0), subcommands().size()), name_of);

}  // namespace
