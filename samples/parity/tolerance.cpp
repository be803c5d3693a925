#include "samples/parity/tolerance.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "samples/io/files.h"
#include "samples/io/toml.h"
#include "samples/io/toml_keys.h"
#include "samples/io/toml_number.h"
#include "samples/parity/measures.h"

namespace parity
{
namespace
{

std::string at(const toml::node &node, const std::string &path)
{
    return path + ", line " + std::to_string(node.source().begin.line) + ": ";
}

// "" where it is no string.
std::string text_in(const toml::node &node) { return node.is_string() ? node.as_string()->get() : ""; }

void set(Tolerance &t, const std::string &measure, double bound)
{
    for (Limit &limit : t.limits)
        if (limit.measure == measure) {
            limit.bound = bound;
            return;
        }
    t.limits.push_back({measure, bound});
}

// `positions.max_m = 1` is a table in a table to TOML, and one name here.
void read_limits(const toml::table &table, const std::string &before, bool at_most, const std::string &path,
                 Tolerance &t)
{
    for (const auto &[key, node] : table) {
        const std::string name = before + std::string(key.str());
        if (const toml::table *inner = node.as_table()) {
            read_limits(*inner, name + ".", at_most, path, t);
            continue;
        }
        const MeasureKind *kind = find_kind(name);
        if (!kind) throw Unreadable(at(node, path) + "there is no measure '" + name + "'");
        if (kind->larger_is_worse != at_most)
            throw Unreadable(at(node, path) + name + " belongs into [" + (at_most ? "at_least" : "at_most") + "]");
        std::string wrong;
        const double bound = io::number_in(node, wrong);  // infinite: no bound
        if (node.is_integer() && !wrong.empty()) throw Unreadable(at(node, path) + name + " " + wrong);
        if (std::isnan(bound)) throw Unreadable(at(node, path) + name + " has to be a number");
        set(t, name, bound);
    }
}

void read_required(const toml::node &node, const std::string &path, Tolerance &t)
{
    const toml::array *list = node.as_array();
    if (!list) throw Unreadable(at(node, path) + "'require' has to be a list of strings");
    for (const toml::node &entry : *list) {
        const std::string group = text_in(entry);
        const auto &groups = measure_groups();
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) {
            std::string known;
            for (const std::string &g : groups) known += (known.empty() ? "" : ", ") + g;
            throw Unreadable(at(entry, path) + "'require' may name " + known);
        }
        if (std::find(t.required.begin(), t.required.end(), group) == t.required.end()) t.required.push_back(group);
    }
}

const Tolerance *find_named(const std::string &name)
{
    for (const Tolerance &t : named_tolerances())
        if (t.name == name) return &t;
    return nullptr;
}

}  // namespace

Tolerance tolerance_from(const std::string &tolerance, const std::string &path)
{
    if (const uint32_t line = io::line_of_deep_key(tolerance))
        throw Unreadable(path + ", line " + std::to_string(line) + ": a key has more than " +
                         std::to_string(io::max_key_parts) + " parts");
    if (const uint32_t line = io::line_of_stray_letter(tolerance))
        throw Unreadable(path + ", line " + std::to_string(line) +
                         ": a letter outside of strings and comments is not ASCII");
    const toml::parse_result parsed = toml::parse(tolerance, path);
    if (!parsed)
        throw Unreadable(path + ", line " + std::to_string(parsed.error().source().begin.line) + ": " +
                         std::string(parsed.error().description()));
    const toml::table &file = parsed.table();
    Tolerance t;
    if (const toml::node *base = file.get("base")) {
        const Tolerance *named = find_named(text_in(*base));
        if (!named) throw Unreadable(at(*base, path) + "'base' may be exact, gpu, coarse or loose");
        t = *named;
    }
    t.name = path;
    for (const auto &[key, node] : file) {
        const toml::table *limits = node.as_table();
        if (key.str() == "base") continue;
        if (key.str() == "require") read_required(node, path, t);
        else if (limits && key.str() == "at_most") read_limits(*limits, "", true, path, t);
        else if (limits && key.str() == "at_least") read_limits(*limits, "", false, path, t);
        else
            throw Unreadable(at(node, path) + "'" + std::string(key.str()) +
                             "' is not one of base, require, [at_most] and [at_least]");
    }
    if (t.limits.empty() && t.required.empty()) throw Unreadable(path + " sets no limit");
    return t;
}

Tolerance tolerance_of(const std::string &name_or_file)
{
    if (const Tolerance *named = find_named(name_or_file)) return *named;
    std::error_code error;
    if (!std::filesystem::exists(name_or_file, error))
        throw Unreadable("there is no tolerance and no file '" + name_or_file +
                         "'; tolerances are exact, gpu, coarse, loose");
    std::string text;
    const std::string wrong = io::read_whole(name_or_file, text);
    if (!wrong.empty()) throw Unreadable(wrong);
    return tolerance_from(text, name_or_file);
}

}  // namespace parity
