#include "tests/cli/started.h"

#include <csignal>
#include <fstream>
#include <spawn.h>

#include <gtest/gtest.h>

extern char **environ;

namespace cli_test
{

pid_t start_claque(const std::vector<std::string> &arguments)
{
    std::vector<char *> argv = {const_cast<char *>(CLAQUE_COMMAND)};
    for (const std::string &word : arguments) argv.push_back(const_cast<char *>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int number : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&usual, number);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    pid_t process = 0;
    EXPECT_EQ(posix_spawn(&process, CLAQUE_COMMAND, nullptr, &attributes, argv.data(), environ), 0);
    posix_spawnattr_destroy(&attributes);
    return process;
}

std::vector<pid_t> children_of(pid_t process)
{
    const std::string id = std::to_string(process);
    std::ifstream file("/proc/" + id + "/task/" + id + "/children");
    std::vector<pid_t> found;
    for (pid_t one = 0; file >> one;) found.push_back(one);
    return found;
}

}  // namespace cli_test
