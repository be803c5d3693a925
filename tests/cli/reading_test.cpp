// Every file that a command reads because an option, an argument or a key of a file names it: where the name leads to a
// pipe without a writer, a device without an end, a folder or a file without measure, the command ends with one
// sentence, at once and in little memory.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/cli/help.h"
#include "tests/cli/named_files.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words split(const std::string &text)
{
    std::istringstream all(text);
    return {std::istream_iterator<std::string>(all), {}};
}

std::string option_of(const Named &one)
{
    if (*one.argument) return one.argument;
    const std::string words = one.words;
    const size_t end = words.rfind(' ', words.find('@'));
    return words.substr(words.rfind(' ', end - 1) + 1, end - words.rfind(' ', end - 1) - 1);
}

class Reading : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        if (IsSkipped()) return;
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
        std::ofstream(path("steps.toml")) << "steps = ['wait 1']\n";
        std::ofstream(path("o.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
        std::ofstream(path("few.csv")) << "id,frame,x,y\n1,0,0,0\n1,1,1,0\n1,2,2,0\n";
        const Outcome made =
            claque({"play", path("few.csv"), "--columns", "id,frame,x,y", "--rate", "1", "--unit", "m", "--size",
                    "32x24", "--time", "0", "--record", path("x.clt"), "--out", path("made.png")});
        EXPECT_EQ(made.code, 0) << made.err;
        for (const char *kind : kinds) {
            fs::create_directories(path(std::string("folders/") + kind));
            make(kind, path(std::string("folders/") + kind + "/capture.json"));
        }
    }

    static constexpr const char *kinds[] = {"pipe", "device", "folder", "large"};

    static void make(const std::string &kind, const std::string &at)
    {
        if (kind == "pipe") EXPECT_EQ(mkfifo(at.c_str(), 0600), 0);
        if (kind == "device") fs::create_symlink("/dev/zero", at);
        if (kind == "folder") fs::create_directory(at);
        if (kind == "large") std::ofstream(at).close(), fs::resize_file(at, uintmax_t{2} << 40);
    }

    Words words_of(const Named &one, const std::string &kind) const
    {
        Words words = split(one.command);
        for (std::string word : split(one.words)) {
            const size_t at = word.find('@');
            if (word.rfind("$samples", 0) == 0) word = CLAQUE_SOURCE_DIR "/" + word.substr(1);
            if (word.rfind("$folders/", 0) == 0) word = path("folders/" + kind);
            else if (at == 0) word = path("named") + word.substr(1);
            else if (word[0] == '$') word = path(word.substr(1));
            words.push_back(word);
        }
        return words;
    }

    // Under a limit of memory that reading to the end of memory would meet, and one of time.
    void expect_refusal(Words words, const std::string &kind) const
    {
        std::string line;
        for (const std::string &word : words) line += word + " ";
        SCOPED_TRACE(kind + ": " + line);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // which reserve terabytes of address space
        const std::string limit = "unlimited";
#else
        const std::string limit = "4000000";
#endif
        words.insert(words.begin(), {"timeout", "-s", "KILL", "30", "sh", "-c", "ulimit -v " + limit + "; exec \"$@\"",
                                     "sh", CLAQUE_COMMAND});
        const double before_s = processor_s();
        const Outcome outcome = run_program(words);
        EXPECT_LT(processor_s() - before_s, 2) << "of processor time";
        EXPECT_EQ(outcome.code, line.rfind("parity compare", 0) == 0 ? 2 : 1) << outcome.err;  // 1: results differ
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        const bool is_named =
            outcome.err.find(kind == "large" ? "bytes" : "is not a regular file") != std::string::npos;
        EXPECT_TRUE(is_named || (kind == "folder" && outcome.err.find("Is a directory") != std::string::npos))
            << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }

    static double processor_s()
    {
        rusage used = {};
        getrusage(RUSAGE_CHILDREN, &used);
        const auto seconds = [](const timeval &t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
        return seconds(used.ru_utime) + seconds(used.ru_stime);
    }
};

class ReadingKind : public Reading, public testing::WithParamInterface<const char *>
{
};

TEST_P(ReadingKind, EndsWithOneSentence)
{
    std::set<std::string> known;
    for (const Words &command : all_commands()) {
        std::string name;
        for (const std::string &word : command) name += (name.empty() ? "" : " ") + word;
        known.insert(name);
    }
    const bool converts = claque({"convert", path("o.obj"), "--out", path("o.glb")}).code == 0;
    const std::string kind = GetParam();
    for (const Named &one : all_named) {
        if (known.count(one.command) == 0 || (one.command == std::string("convert") && !converts)) continue;
        if (one.argument == std::string("what") && kind == "folder") continue;  // a wrong scene's name
        const std::string words = one.words;
        const size_t at = words.find('@');
        const std::string file = path("named") + words.substr(at + 1, words.find(' ', at) - at - 1);
        if (words.find("$folders") == std::string::npos) make(kind, file);
        expect_refusal(words_of(one, kind), kind);
        fs::remove_all(file);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, ReadingKind, testing::Values("pipe", "device", "folder", "large"),
                         [](const auto &kind) { return std::string(kind.param); });

TEST_F(Reading, IsTriedForEveryOptionOfEveryCommand)
{
    const Words others = split(name_nothing_read);
    std::set<std::string> tried(others.begin(), others.end());
    for (const Named &one : all_named) tried.insert(one.command + (" " + option_of(one)));
    for (const Words &command : all_commands()) {
        std::string name;
        for (const std::string &word : command) name += word + " ";
        for (const std::string &option : help_of(command).options)
            EXPECT_TRUE(tried.count(name + option) + tried.count(option) > 0)
                << name << option << " needs a line above: is it the name of a file that is read?";
    }
}

// Keys of scenarios that docs/scenarios.md says to be files, and one that rules of labels have.
TEST_F(Reading, EndsWithOneSentenceWhereAKeyNamesNoFile)
{
    const std::string people = "[[characters]]\nname = 'a'\ncharacter = 'citizen'\n", stage = "[stage]\nseconds = 9\n",
                      agents = "[[agents]]\n";
    const std::map<std::string, std::string> scenarios = {
        {"colours", "colours = '@'\n"},
        {"character", "[[characters]]\nname = 'a'\ncharacter = '@.glb'\n"},
        {"file", people + "[tracks]\nfile = '@.csv'\n"},
        {"stage.timetable", stage + "timetable = '@'\n" + agents},
        {"machine",
         people + stage + "[navigation]\nrectangle = [0, 0, 9, 9]\n" + agents + "class = 'a'\nmachine = '@'\n"},
        {"path", "[camera]\npath = '@'\n"},
        {"area", people + "[tracks]\nfile = 's.toml'\n[ground]\narea = '@'\n"},
        {"navigation.area", stage + "[navigation]\narea = '@'\n" + agents}};
    std::ifstream page(CLAQUE_SOURCE_DIR "/docs/scenarios.md");
    const std::regex row("^\\| `([a-z_.]+)`[^|]*\\| (text or )?file(, \"wild\" or \"own\")? \\|.*");
    size_t rows = 0;
    for (std::string line; std::getline(page, line);)
        if (std::smatch found; std::regex_match(line, found, row) && found[1] != "mechanism") {
            EXPECT_EQ(scenarios.count(found[1]), 1u) << line;
            ++rows;
        }
    EXPECT_GE(rows, scenarios.size());
    const auto expect_all = [&](const std::string &text, const Words &words, const std::string &input) {
        for (const char *kind : kinds) {
            const std::string name =
                "named" + text.substr(text.find('@') + 1, text.find('\'', text.find('@')) - text.find('@') - 1);
            std::ofstream(path(input)) << std::regex_replace(text, std::regex("@"), "named");
            make(kind, path(name));
            expect_refusal(words, kind);
            fs::remove_all(path(name));
        }
    };
    for (const auto &[key, text] : scenarios)
        expect_all("name = 'scenario'\n" + text, {"render", "--scenario", path("s.toml"), "--out", path("x.png")},
                   "s.toml");
    expect_all("[people]\ncolours = ['@']\n",
               {"labels", "--scene", "plaza", "--vary", path("r.toml"), "--out", path("x")}, "r.toml");
}

}  // namespace
}  // namespace cli_test
