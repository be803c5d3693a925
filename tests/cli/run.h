// Runs the claque command as a person or a script would, and holds what came of it. No shell in between.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cli_test
{

struct Outcome {
    int code = -1;  // -1: ended by a signal
    std::string out, err;
};

Outcome claque(const std::vector<std::string> &arguments);

std::string file_text(const std::string &path);

// A folder of its own for each test, gone afterwards.
class Command : public testing::Test
{
protected:
    Command();
    ~Command() override;

    std::string path(const std::string &name) const { return (folder_ / name).string(); }
    std::vector<std::string> left() const;  // names of what is in the folder, sorted

private:
    std::filesystem::path folder_;
};

// Of the tests that draw: skipped with a reason where this machine has no software GL.
class Drawing : public Command
{
protected:
    void SetUp() override;

    // A small picture; more arguments follow. Fails the test where the command fails.
    void render(std::vector<std::string> arguments) const;
    // The picture's hash with these arguments.
    std::string picture_hash(std::vector<std::string> arguments) const;
};

// Empty where contexts of this kind ("osmesa", "egl", "any") can be had, else why not.
std::string why_no_context(const std::string &kind);

}  // namespace cli_test
