// Each operation on a file that a subcommand of claque makes fails once: the command ends with one sentence that names
// the file, what was there before is still there, and nothing else is left. CLAQUE_FAULTS=thorough fails every
// operation; without it, fewer of those that are many.
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/cli/run.h"
#include "tests/faults/failing_files.h"
#include "tests/support/written_characters.h"

namespace
{

namespace fs = std::filesystem;
using cli_test::claque;
using cli_test::file_text;
using cli_test::Outcome;
using failing_files::Fault;
using failing_files::How;
using failing_files::Operation;
using Words = std::vector<std::string>;

struct Kind {
    const char *name;
    Operation operation;
    How how;
    int error;
    bool is_fault;  // false: the command has to go on as if nothing had been
};

constexpr Kind kinds[] = {{"open", Operation::open, How::error, EIO, true},
                          {"open, no descriptors", Operation::open, How::for_good, EMFILE, true},
                          {"read", Operation::read, How::error, EIO, true},
                          {"read, interrupted", Operation::read, How::error, EINTR, false},
                          {"read, short", Operation::read, How::shortened, 0, false},
                          {"write", Operation::write, How::error, EIO, true},
                          {"write, disk full", Operation::write, How::for_good, ENOSPC, true},
                          {"write, interrupted", Operation::write, How::error, EINTR, false},
                          {"write, short", Operation::write, How::shortened, 0, false},
                          {"fsync", Operation::sync, How::error, EIO, true},
                          {"rename", Operation::rename, How::error, EIO, true},
                          {"rename, disk full", Operation::rename, How::for_good, ENOSPC, true},
                          {"close", Operation::close, How::error, EIO, false},
                          {"mkdir", Operation::make_folder, How::error, EIO, true}};

// "<name" stands for a file that is read, ">name" for one that is written; a name that ends in '/' for a folder.
struct Subcommand {
    const char *name;
    Words words;
    bool draws = false;     // needs a GL
    bool recovers = false;  // a library below it does without some operations, with the same result
};

const std::vector<Subcommand> &subcommands()
{
    static const std::vector<Subcommand> all = {
        {"render",
         {"render", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">p.png", "--json", ">p.json"},
         true},
        {"render_prepared", {"render", "<p.clq", "--count", "2", "--size", "32x24", "--out", ">p.png"}, true},
        {"render_scene",
         {"render", "--scene", "odeon", "--theatre", "<odeon.toml", "--camera", "path", "--path", "<path.toml",
          "--colours", "<roman.toml", "--count", "3", "--size", "32x24", "--out", ">p.png"},
         true},
        {"sheet",
         {"sheet", "--path", "<path.toml", "--theatre", "<odeon.toml", "--count", "3", "--size", "32x24", "--out",
          ">s.png", "--json", ">s.json"},
         true},
        {"inspect", {"inspect", "<p.glb", "--json"}},
        {"dump", {"dump", "<p.glb", "--out", ">p.npy"}},
        {"split", {"split", "<p.glb", "--picture", ">p.png"}},
        {"variety", {"variety", "<p.glb", "--count", "2", "--colours", "<p.toml", "--out", ">p.png"}, true},
        {"colours_save", {"colours", "save", "<roman.toml", "--out", ">c.toml"}},
        {"lods", {"lods", "<p.glb", "--targets", "500", "--proxy-max-triangles", "0", "--out", ">l.png"}, true},
        {"blend",
         {"blend",   "<p.glb",    "--fade", "walk,wave",  "--phases", "2",      "--over",
          "walk",    "--layer",   "wave",   "--additive", "stand",    "--node", "body",
          "--gaits", "walk,wave", "--size", "300x300",    "--out",    ">b.png"},
         true},
        {"prepare", {"prepare", "<s.gltf", "--propose", "2", "--zones-out", ">z.png", "--out", ">p.clq"}},
        {"prepare_clips",
         {"prepare", "citizen", "--clips", "<w.bvh", "--map", "<map.toml", "--zones", "<z.png", "--out", ">p.clq"}},
        {"convert", {"convert", "<o.obj", "--out", ">o.glb"}, false, true},
        {"bench",
         {"bench", "<p.glb", "--count", "2", "--frames", "1", "--strategy", "fused", "--cache", "none", "--size",
          "32x24", "--save", ">b.json"},
         true},
        {"bench_operations",
         {"bench", "hundred_actors", "--frames", "1", "--strategy", "fused", "--cache", "none", "--size", "32x24",
          "--operations", ">o.json"},
         true},
        {"plot", {"plot", "<lines.json", "--out", ">l.svg"}},
        {"plot_png", {"plot", "<lines.json", "--out", ">l.png"}},
        {"cost", {"cost", "--measured", "<counts.json", "--json", ">c.json", "--plot", ">c.svg"}},
        {"parity_export", {"parity", "export", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">scene/"}, true},
        {"parity_capture",
         {"parity", "capture", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">result/"},
         true},
        {"parity_compare",
         {"parity", "compare", "<a/", "<b/", "--tolerance", "<mine.toml", "--json", ">r.json", "--html", ">r.html"},
         true}};
    return all;
}

bool is_thorough()
{
    const char *effort = std::getenv("CLAQUE_FAULTS");
    return effort && std::string(effort) == "thorough";
}

// What lies below a folder: each file with its contents.
using Files = std::map<std::string, std::string>;
Files files_below(const fs::path &folder)
{
    Files all;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
        all[fs::relative(entry.path(), folder).string()] = entry.is_regular_file() ? file_text(entry.path()) : "/";
    return all;
}

// Two files of times are alike if both are whole.
std::string without_times(const std::string &name, const std::string &text)
{
    return fs::path(name).extension() == ".json" && text.size() > 2 ? text.substr(text.size() - 2) : text;
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

void make_inputs()
{
    const fs::path in = the_folder / "in", source = CLAQUE_SOURCE_DIR;
    fs::copy_file(written::folder() + "WrittenPerson.glb", in / "p.glb");
    fs::copy_file(written::folder() + "WrittenWalk.bvh", in / "w.bvh");
    fs::copy_file(source / "samples/scenes/odeon/odeon.toml", in / "odeon.toml");
    fs::copy_file(source / "samples/scenes/odeon/path.toml", in / "path.toml");
    fs::copy_file(source / "samples/maps/roman-classes.toml", in / "roman.toml");
    fs::copy_file(source / "samples/maps/cmu-people.toml", in / "map.toml");
    fs::copy_file(written::folder() + "WrittenSparse.gltf", in / "s.gltf");
    for (const auto &file : fs::directory_iterator(written::folder()))
        if (file.path().extension() == ".bin" || file.path().extension() == ".png")
            fs::copy_file(file.path(), in / file.path().filename());
    std::ofstream(in / "mine.toml") << "require = ['colour']\n[at_most]\ncolour.over_8 = 1\n";
    std::ofstream(in / "o.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    std::ofstream(in / "lines.json") << R"({"kind": "lines", "title": "t", "x": {"title": "x"}, "y": {"title": "y"},
        "series": [{"name": "s", "points": [[1, 1], [2, 3]]}]})";
}

std::string last_line(const std::string &text)
{
    if (text.empty() || text.back() != '\n') return "";
    const size_t before = text.rfind('\n', text.size() - 2);
    return text.substr(before == std::string::npos ? 0 : before + 1);
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
        make_inputs();
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
            if (word.back() == '/') {
                fs::create_directory(place_of(word));
                std::ofstream(place_of(word) + "capture.json") << "older";
                std::ofstream(place_of(word) + "atlas.npy") << "older";
            } else {
                std::ofstream(place_of(word)) << "older";
            }
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
            const bool is_new = made != whole_.end() && without_times(name, text) == without_times(name, made->second);
            const bool is_older = before != older_.end() && text == before->second;
            EXPECT_TRUE(is_new || (is_older && !all_new)) << name << " of " << text.size() << " bytes";
        }
        if (all_new) {
            EXPECT_EQ(now.size(), whole_.size());
        } else {
            for (const auto &[name, text] : older_)
                if (fs::path(name).has_extension() && name.find('/') == std::string::npos) {
                    EXPECT_TRUE(now.count(name)) << name << " is gone";
                }
        }
        for (const std::string &word : words())
            if (word[0] == '>' && word.back() == '/') expect_one_capture(now, word.substr(1));
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
    }

    void fail_each(bool without_exchange)
    {
        uint64_t tried = 0;
        for (const Kind &kind : kinds)
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
                if (!is_thorough() && (!kind.is_fault || kind.how == How::for_good)) break;
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
            EXPECT_TRUE(older_.count(name)) << name << " is left";
        }
        all[i] = "-";
        const Outcome streamed = claque(all, "/dev/full");
        EXPECT_NE(streamed.code, 0) << words()[i] << " to a standard output that is full";
        EXPECT_NE(streamed.err.find("standard output"), std::string::npos) << streamed.err;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FullDisk, testing::Range(size_t(0), subcommands().size()), name_of);

}  // namespace
