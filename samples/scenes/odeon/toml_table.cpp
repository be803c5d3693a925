#include "samples/scenes/odeon/toml_table.h"

#include <cmath>
#include <cstdio>

#include "lib/base/near_names.h"
#include "samples/io/toml_keys.h"
#include "samples/io/toml_number.h"
#include "samples/scenes/check.h"

namespace scenes
{
namespace
{

std::string place_of(const std::string &where, const toml::source_region &source)
{
    if (source.begin.line == 0) return where;
    return where + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
}

std::string kind_of(const toml::node &node)
{
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

}  // namespace

std::string show(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

toml::table parse_toml(const std::string &toml, const std::string &where)
{
    if (const uint32_t line = io::line_of_deep_key(toml))
        throw Failure(where + ":" + std::to_string(line) + ":1: a key has more than " +
                      std::to_string(io::max_key_parts) + " parts");
    if (const uint32_t line = io::line_of_stray_letter(toml))
        throw Failure(where + ":" + std::to_string(line) +
                      ":1: not TOML: a letter outside of strings and comments is not ASCII");
    if (const uint32_t line = io::line_of_table_too_many(toml))
        throw Failure(where + ":" + std::to_string(line) + ":1: the file has more than " +
                      std::to_string(io::max_tables) + " tables");
    toml::parse_result result = toml::parse(toml);
    if (!result)
        throw Failure(place_of(where, result.error().source()) +
                      ": not TOML: " + std::string(result.error().description()));
    return std::move(result).table();
}

TomlTable::TomlTable(const toml::table &table, std::string where, std::string what)
    : table_(&table), where_(std::move(where)), what_(std::move(what))
{
}

std::string TomlTable::place(std::string_view key) const
{
    const toml::node *node = key.empty() ? nullptr : table_->get(key);
    return place_of(where_, node ? node->source() : table_->source());
}

void TomlTable::refuse(const std::string &sentence, std::string_view key) const
{
    throw Failure(place(key) + ": " + (what_.empty() ? sentence : what_ + " " + sentence));
}

void TomlTable::expect_no(std::string_view key, const std::string &sentence) const
{
    if (table_->contains(key)) refuse("has '" + std::string(key) + "', " + sentence, key);
}

void TomlTable::renamed(std::string_view old_key, const std::string &now) const
{
    expect_no(old_key, "which is now '" + now + "'");
}

bool TomlTable::has(std::string_view key)
{
    known_.emplace(key);
    return table_->contains(key);
}

const toml::node &TomlTable::need(std::string_view key)
{
    if (!has(key)) refuse("lacks '" + std::string(key) + "'");
    return *table_->get(key);
}

double TomlTable::number_of(const toml::node &node, std::string_view key, Limits limits) const
{
    const std::string name = "has '" + std::string(key) + "' = ";
    if (!node.is_number()) refuse(name + kind_of(node) + " instead of a number", key);
    std::string wrong;
    const double value = io::number_in(node, wrong);
    if (!wrong.empty())
        refuse(node.is_integer() ? "has '" + std::string(key) + "' that " + wrong
                                 : name + show(value) + ", which " + wrong,
               key);
    if (value < limits.first || value > limits.last)
        refuse(name + show(value) + ", which is not within " + show(limits.first) + " to " + show(limits.last), key);
    return value;
}

double TomlTable::number(std::string_view key, Limits limits) { return number_of(need(key), key, limits); }

uint32_t TomlTable::whole(std::string_view key, Limits limits)
{
    const toml::node &node = need(key);
    if (!node.is_integer())
        refuse("has '" + std::string(key) + "' = " + kind_of(node) + " instead of a whole number", key);
    return static_cast<uint32_t>(number_of(node, key, limits));
}

std::string TomlTable::text(std::string_view key)
{
    const toml::node &node = need(key);
    if (!node.is_string()) refuse("has '" + std::string(key) + "' = " + kind_of(node) + " instead of a string", key);
    return node.as_string()->get();
}

bool TomlTable::flag(std::string_view key)
{
    const toml::node &node = need(key);
    if (!node.is_boolean())
        refuse("has '" + std::string(key) + "' = " + kind_of(node) + " instead of true or false", key);
    return node.as_boolean()->get();
}

std::array<double, 2> TomlTable::pair(std::string_view key, Limits limits)
{
    const toml::array *list = need(key).as_array();
    if (!list || list->size() != 2) refuse("has '" + std::string(key) + "' that is not a list [first, last]", key);
    return {number_of((*list)[0], key, limits), number_of((*list)[1], key, limits)};
}

std::array<double, 3> TomlTable::triple(std::string_view key, Limits limits, const char *names)
{
    const std::vector<double> values = numbers(key, limits);
    if (values.size() != 3)
        refuse("has '" + std::string(key) + "' of " + std::to_string(values.size()) + " numbers instead of 3, " + names,
               key);
    return {values[0], values[1], values[2]};
}

std::vector<double> TomlTable::numbers(std::string_view key, Limits limits)
{
    const toml::node &node = need(key);
    if (!node.is_array()) return {number_of(node, key, limits)};
    std::vector<double> values;
    for (const toml::node &item : *node.as_array()) values.push_back(number_of(item, key, limits));
    return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key)
{
    const toml::array *list = need(key).as_array();
    if (!list) refuse("has '" + std::string(key) + "' that is not a list of strings", key);
    std::vector<std::string> all;
    for (const toml::node &item : *list) {
        if (!item.is_string()) refuse("has '" + std::string(key) + "' that is not a list of strings", key);
        all.push_back(item.as_string()->get());
    }
    return all;
}

std::vector<std::string> TomlTable::names() const
{
    std::vector<std::string> all;
    for (const auto &[key, node] : *table_) all.emplace_back(key.str());
    return all;
}

std::vector<std::pair<std::string, std::string>> TomlTable::named_texts()
{
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto &[key, node] : *table_) all.emplace_back(key.str(), text(key.str()));
    return all;
}

TomlTable TomlTable::table(std::string_view key, const std::string &what)
{
    const toml::table *inner = need(key).as_table();
    if (!inner) refuse("has '" + std::string(key) + "' that is not a table", key);
    return TomlTable(*inner, where_, what);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, const std::string &what)
{
    if (!has(key)) return {};
    const toml::array *list = table_->get(key)->as_array();
    if (!list) refuse("has '" + std::string(key) + "' that is not a list of tables", key);
    std::vector<TomlTable> all;
    for (const toml::node &item : *list) {
        if (!item.is_table()) refuse("has '" + std::string(key) + "' that is not a list of tables", key);
        all.emplace_back(*item.as_table(), where_, what + " " + std::to_string(all.size() + 1));
    }
    return all;
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::named_tables(const std::string &what)
{
    std::vector<std::pair<std::string, TomlTable>> all;
    for (const auto &[key, node] : *table_) {
        const std::string name(key.str());
        if (!node.is_table()) refuse("has '" + name + "' that is not a table", key.str());
        all.emplace_back(name, TomlTable(*node.as_table(), where_, what + " '" + name + "'"));
        known_.insert(name);
    }
    return all;
}

void TomlTable::done() const
{
    for (const auto &[key, node] : *table_)
        if (!known_.count(key.str()))
            throw Failure(place_of(where_, key.source()) + ": " + (what_.empty() ? "" : what_ + " ") +
                          "has an unknown key '" + std::string(key.str()) + "'" +
                          claque::base::names_near(key.str(), known_));
}

}  // namespace scenes
