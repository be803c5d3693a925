#include "tests/cli/run.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/gl/support/absent.h"

extern char **environ;

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

fs::path new_folder()
{
    std::string name = (fs::temp_directory_path() / "claque-cli-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder could be made");
    return name;
}

}  // namespace

std::string file_text(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

Outcome claque(const std::vector<std::string> &arguments, const char *device)
{
    std::vector<std::string> words = {CLAQUE_COMMAND};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(words, device);
}

Outcome run_program(std::vector<std::string> words, const char *device)
{
    const fs::path folder = new_folder();
    const std::string out = folder / "out", err = folder / "err";
    std::vector<char *> argv;
    for (std::string &word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, device ? device : out.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);
    // Leak checkers report their suppressions, which are not output of the command.
    setenv("LSAN_OPTIONS", "print_suppressions=0", 0);
    // GCC 12's leak checker takes a driver's thread-local memory for a table of it and crashes there.
    setenv("ASAN_OPTIONS", "intercept_tls_get_addr=0", 0);
    // As in the foreground of a shell: one that runs in the background ignores them, and the command would.
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM}) sigaddset(&signals, number);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    posix_spawnattr_setsigdefault(&how, &signals);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    Outcome outcome;
    int state = 0;
    if (posix_spawnp(&child, argv[0], &actions, &how, argv.data(), environ) == 0 &&
        waitpid(child, &state, 0) == child) {
        if (WIFEXITED(state)) outcome.code = WEXITSTATUS(state);
        if (WIFSIGNALED(state)) outcome.signal = WTERMSIG(state);
    }
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&how);
    outcome.out = file_text(out);
    outcome.err = file_text(err);
    fs::remove_all(folder);
    return outcome;
}

Command::Command() : folder_(new_folder()) {}

Command::~Command()
{
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::vector<std::string> Command::left() const
{
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::map<std::string, std::string> Command::contents(const std::string &folder) const
{
    std::map<std::string, std::string> found;
    for (const auto &entry : fs::recursive_directory_iterator(path(folder)))
        if (entry.is_regular_file()) found[fs::relative(entry.path(), path(folder)).string()] = file_text(entry.path());
    return found;
}

std::string why_no_context(const std::string &kind)
{
    if (kind == "osmesa") return gltest::absent_gl(contexts::Kind::osmesa);
    return gltest::absent_gl(kind == "egl" ? contexts::Kind::egl : contexts::Kind::any);
}

void Drawing::SetUp()
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
}

void Drawing::render(std::vector<std::string> arguments) const
{
    arguments.insert(arguments.begin(), {"render", "--count", "30", "--size", "96x72"});
    const Outcome done = claque(arguments);
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "") << "without a terminal a successful command prints nothing to stderr";
}

std::string Drawing::picture_hash(std::vector<std::string> arguments) const
{
    const std::string json = path("hash.json");
    arguments.insert(arguments.end(), {"--out", path("hash.png"), "--json", json});
    render(arguments);
    const nlohmann::json report = nlohmann::json::parse(file_text(json), nullptr, false);
    EXPECT_FALSE(report.is_discarded());
    return report.is_discarded() ? "" : report["frames"][0]["picture_hash"].get<std::string>();
}

}  // namespace cli_test
