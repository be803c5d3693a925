#include "tests/embed/scratch.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

Scratch::Scratch(const std::string &name)
{
    const testing::TestInfo *test = testing::UnitTest::GetInstance()->current_test_info();
    path_ =
        (fs::current_path() / "scratch" / (std::string(test->test_suite_name()) + "." + test->name() + name)).string();
    fs::remove_all(path_);
    fs::create_directories(path_);
}

void Scratch::write(const std::string &name, const std::string &text) const
{
    std::ofstream(fs::path(path_) / name) << text;
}

std::pair<int, std::string> Scratch::run(const std::string &script) const
{
    write(".script", script);
    FILE *pipe = popen(("cd '" + path_ + "' && sh -e .script 2>&1").c_str(), "r");
    if (!pipe) return {-1, "no pipe"};
    std::string said;
    char some[4096];
    while (const size_t n = std::fread(some, 1, sizeof some, pipe)) said.append(some, n);
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

std::string text_of_file(const std::string &path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

bool has_command(const std::string &name) { return std::system(("command -v " + name + " > /dev/null").c_str()) == 0; }
