// A folder of a test's own, and command lines that are run in it.
#pragma once

#include <string>
#include <utility>

class Scratch
{
public:
    explicit Scratch(const std::string &name = "");  // empty, named after the running test as well
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    const std::string &path() const { return path_; }
    void write(const std::string &name, const std::string &text) const;

    // `script` as sh -e takes it, in the folder: its exit code, and what it said on both outputs.
    std::pair<int, std::string> run(const std::string &script) const;

private:
    std::string path_;
};

std::string text_of_file(const std::string &path);  // "" where there is none
bool has_command(const std::string &name);
