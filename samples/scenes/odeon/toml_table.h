// Tables of a TOML description, read with every value checked. Each refusal is one sentence: file, line, what, numbers.
#pragma once

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scenes
{

// Parses a description. Throws Failure where it is no TOML. `where` names it in sentences.
toml::table parse_toml(const std::string &text, const std::string &where);

struct Limits {
    double first, last;
};

// One table. Keys that nobody asked for are refused by done().
class TomlTable
{
public:
    // `what` names it in sentences, "[stage]".
    TomlTable(const toml::table &table, std::string where, std::string what);

    bool has(std::string_view key);
    double number(std::string_view key, Limits limits);
    uint32_t whole(std::string_view key, Limits limits);
    std::string text(std::string_view key);
    std::array<double, 2> pair(std::string_view key, Limits limits);
    std::vector<double> numbers(std::string_view key, Limits limits);  // one number, or a list of them
    std::vector<std::string> texts(std::string_view key);
    // Every text by its own name, for keys that are names.
    std::vector<std::pair<std::string, std::string>> named_texts();
    TomlTable table(std::string_view key, const std::string &what);
    // The tables of [[key]]; `what` is numbered from 1. None where the key is missing.
    std::vector<TomlTable> tables(std::string_view key, const std::string &what);
    // Every table by its own name, for keys that are names.
    std::vector<std::pair<std::string, TomlTable>> named_tables(const std::string &what);
    void done() const;

    // Throws Failure: where, the line of the table (or of one key), what it is, and the sentence.
    [[noreturn]] void refuse(const std::string &sentence, std::string_view key = {}) const;

private:
    const toml::node &need(std::string_view key);
    double number_of(const toml::node &node, std::string_view key, Limits limits) const;

    const toml::table *table_;
    std::string where_, what_;
    std::set<std::string, std::less<>> known_;
};

// A number as people write it.
std::string show(double value);

}  // namespace scenes
