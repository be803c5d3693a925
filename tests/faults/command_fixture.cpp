#include "tests/faults/command_fixture.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace command_faults
{
namespace
{

namespace fs = std::filesystem;
using cli_test::claque;
using cli_test::Outcome;
using Words = std::vector<std::string>;

fs::path the_folder;

std::string place_of(const std::string &word)
{
    if (word[0] == '<') return the_folder / "in" / word.substr(1);
    if (word[0] == '>') return the_folder / "out" / word.substr(1);
    return word;
}

Words with_places(const Words &words)
{
    Words all;
    for (const std::string &word : words) all.push_back(place_of(word));
    return all;
}

void expect_success(const Words &words, std::string *printed = nullptr)
{
    const Outcome done = claque(with_places(words));
    if (printed) *printed = done.out;
    ASSERT_EQ(done.code, 0) << words[0] << ": " << done.err;
}

}  // namespace

bool is_thorough()
{
    const char *effort = std::getenv("CLAQUE_FAULTS");
    return effort && std::string(effort) == "thorough";
}

const fs::path &CommandFixture::folder() { return the_folder; }

Words CommandFixture::placed() const { return with_places(words()); }

void CommandFixture::expect_done() const { expect_success(words()); }

void CommandFixture::SetUpTestSuite()
{
    std::string name = testing::TempDir() + "claque-commands-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    the_folder = fs::path(name) / "files";
    for (const char *below : {"in", "out", "tmp"}) fs::create_directories(the_folder / below);
    // Failures of the cache are no failures of the command: it lies outside what is watched.
    setenv("XDG_CACHE_HOME", (name + "/cache").c_str(), 1);
    make_inputs(the_folder / "in");
}
void CommandFixture::TearDownTestSuite() { fs::remove_all(the_folder.parent_path()); }

void CommandFixture::SetUp()
{
    if (subcommand().draws && !cli_test::why_no_context("any").empty()) GTEST_SKIP() << cli_test::why_no_context("any");
    make_needed();
    if (HasFatalFailure()) return;
    fs::remove_all(the_folder / "out");
    fs::create_directory(the_folder / "out");
    expect_success(words(), &printed_);
    whole_ = files_below(the_folder / "out");
    put_older();
    older_ = files_below(the_folder / "out");
}

// Inputs that the command itself writes.
void CommandFixture::make_needed() const
{
    const auto needs = [&](const char *name) {
        return std::find(words().begin(), words().end(), name) != words().end() && !fs::exists(place_of(name));
    };
    if (needs("<p.clq")) expect_success({"prepare", "<p.glb", "--out", "<p.clq"});
    if (needs("<p.toml")) expect_success({"colours", "save", "<p.glb", "--out", "<p.toml"});
    if (needs("<z.png"))
        expect_success({"prepare", "citizen", "--propose", "2", "--zones-out", "<z.png", "--out", "<z.clq"});
    if (needs("<counts.json"))
        expect_success({"bench", "hundred_actors", "--frames", "1", "--size", "32x24", "--operations", "<counts.json"});
    for (const char *folder : {"<a/", "<b/"})
        if (needs(folder))
            expect_success({"parity", "capture", "<p.glb", "--count", "2", "--size", "32x24", "--out", folder});
}

void CommandFixture::put_older() const
{
    fs::remove_all(the_folder / "out");
    fs::create_directory(the_folder / "out");
    for (const std::string &word : words()) {
        if (word[0] != '>' || subcommand().is_for_signals) continue;
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
void CommandFixture::put_first_picture() const
{
    for (const auto &[name, text] : whole_) {
        if (text == "/" || name.find('/') == std::string::npos || name.find("000001") != std::string::npos) continue;
        const fs::path path = the_folder / "out" / name;
        fs::create_directories(path.parent_path());
        const bool is_of_all = path.parent_path().parent_path() == the_folder / "out";
        std::ofstream(path) << (is_of_all && path.filename() != "settings.json" ? "older" : text);
    }
}

bool CommandFixture::run(const failing_files::Fault &fault, Outcome &outcome) const
{
    const std::string reached = the_folder.parent_path() / "reached";
    fs::remove(reached);
    const std::string text = the_folder.string() + "/\n" + std::to_string(static_cast<int>(fault.operation)) + " " +
                             std::to_string(fault.n) + " " + std::to_string(static_cast<int>(fault.how)) + " " +
                             std::to_string(fault.error) + " " + std::to_string(fault.without_exchange);
    setenv("CLAQUE_FAULT", text.c_str(), 1);
    setenv("CLAQUE_FAULT_REACHED", reached.c_str(), 1);
    setenv("LD_PRELOAD", CLAQUE_FAILING_FILES, 1);
    setenv("TMPDIR", (the_folder / "tmp").c_str(), 1);
    setenv("ASAN_OPTIONS", "intercept_tls_get_addr=0:verify_asan_link_order=0", 1);
    outcome = claque(placed());
    unsetenv("LD_PRELOAD"), unsetenv("CLAQUE_FAULT"), unsetenv("TMPDIR");
    return fs::exists(reached);
}

void CommandFixture::expect_whole_or_older(bool all_new) const
{
    EXPECT_TRUE(fs::is_empty(the_folder / "tmp")) << fs::directory_iterator(the_folder / "tmp")->path();
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
void CommandFixture::expect_one_capture(const Files &now, const std::string &folder) const
{
    const auto below = [&](const Files &all) {
        Files some;
        for (const auto &[name, text] : all)
            if (name.compare(0, folder.size(), folder) == 0) some.emplace(name, text);
        return some;
    };
    EXPECT_TRUE(below(now) == below(older_) || below(now) == below(whole_)) << folder;
}

std::string name_of(const testing::TestParamInfo<size_t> &info) { return subcommands()[info.param].name; }

std::vector<size_t> those_with_faults()
{
    std::vector<size_t> found;
    for (size_t i = 0; i < subcommands().size(); ++i)
        if (!subcommands()[i].is_for_signals) found.push_back(i);
    return found;
}

std::vector<size_t> a_capture()
{
    for (size_t i = 0; i < subcommands().size(); ++i)
        if (std::string(subcommands()[i].name) == "parity_capture") return {i};
    return {};
}

}  // namespace command_faults
