// Runs the claque command as a user or a script would, without a shell, and keeps its output.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cli_test
{

struct Outcome {
    int code = -1;   // -1: ended by a signal
    int signal = 0;  // that ended it
    std::string out, err;
};

// `device`: takes its standard output, which Outcome then has nothing of.
Outcome claque(const std::vector<std::string> &arguments, const char *device = nullptr);
// Another program, found by PATH, with its arguments.
Outcome run_program(std::vector<std::string> words, const char *device = nullptr);

std::string file_text(const std::string &path);

// A folder for one test, deleted afterwards.
class Command : public testing::Test
{
protected:
    Command();
    ~Command() override;

    std::string path(const std::string &name) const { return (folder_ / name).string(); }
    std::vector<std::string> left() const;  // names of the files in the folder, sorted
    // The files below a folder of it, by their paths there.
    std::map<std::string, std::string> contents(const std::string &folder) const;

private:
    std::filesystem::path folder_;
};

// For tests that draw: skipped with a reason where this machine has no software GL.
class Drawing : public Command
{
protected:
    void SetUp() override;

    // Renders a small picture; more arguments follow. Fails the test if the command fails.
    void render(std::vector<std::string> arguments) const;
    // The hash of the picture with these arguments.
    std::string picture_hash(std::vector<std::string> arguments) const;
};

// Empty if contexts of this kind ("osmesa", "egl", "any") are available, else the reason.
std::string why_no_context(const std::string &kind);

}  // namespace cli_test
