// Tables of a TOML description; every value is checked as it is read. Each error is one sentence with file, line,
// column, key and numbers.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "samples/io/toml.h"

namespace scenes
{

// Parses a description. Throws Failure if it is not TOML. `where` names it in error messages.
toml::table parse_toml(const std::string &text, const std::string &where);

struct Limits {
    double first, last;
};

// One table. done() rejects keys that were never read.
class TomlTable
{
public:
    // `what` names it in error messages: "[stage]".
    TomlTable(const toml::table &table, std::string where, std::string what);

    bool has(std::string_view key);
    double number(std::string_view key, Limits limits);
    uint32_t whole(std::string_view key, Limits limits);
    std::string text(std::string_view key);
    bool flag(std::string_view key);
    std::array<double, 2> pair(std::string_view key, Limits limits);
    // Three numbers; `names` of them for messages: "[x, y, z]".
    std::array<double, 3> triple(std::string_view key, Limits limits, const char *names);
    std::vector<double> numbers(std::string_view key, Limits limits);  // one number, or a list of them
    std::vector<std::string> texts(std::string_view key);
    // All keys, for tables whose keys are names.
    std::vector<std::string> names() const;
    // All texts with their keys, for tables whose keys are names.
    std::vector<std::pair<std::string, std::string>> named_texts();
    TomlTable table(std::string_view key, const std::string &what);
    // The tables of [[key]]; `what` is numbered from 1. None if the key is missing.
    std::vector<TomlTable> tables(std::string_view key, const std::string &what);
    // All tables with their keys, for tables whose keys are names.
    std::vector<std::pair<std::string, TomlTable>> named_tables(const std::string &what);
    void done() const;

    // Refuses a key that has no place here.
    void expect_no(std::string_view key, const std::string &sentence) const;
    // Refuses a key that has another name now.
    void renamed(std::string_view old_key, const std::string &now) const;
    // Throws Failure: file, line and column of the table (or of the value of one key), what it is, and the sentence.
    [[noreturn]] void refuse(const std::string &sentence, std::string_view key = {}) const;
    // "FILE:LINE:COLUMN" of the same, for what is checked later.
    std::string place(std::string_view key = {}) const;

private:
    const toml::node &need(std::string_view key);
    double number_of(const toml::node &node, std::string_view key, Limits limits) const;

    const toml::table *table_;
    std::string where_, what_;
    std::set<std::string, std::less<>> known_;
};

// A number in its usual notation.
std::string show(double value);

}  // namespace scenes
