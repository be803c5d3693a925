#include "lib/stage/machine/document.h"

#include <algorithm>
#include <cmath>

#include "lib/base/near_names.h"
#include "lib/stage/error.h"
#include "lib/stage/machine/toml_keys.h"
#include "lib/stage/machine/toml_number.h"

namespace claque::stage
{

namespace
{

toml::parse_result parse(std::string_view text, const std::string &name)
{
    if (const uint32_t line = line_of_deep_key(text))
        fail(CLQ_LIMIT, "%s, line %u: a key has more than %u parts", name.c_str(), line, max_key_parts);
    if (const uint32_t line = line_of_stray_letter(text))
        fail(CLQ_FORMAT, "%s, line %u: not TOML: a letter outside of strings and comments is not ASCII", name.c_str(),
             line);
    return toml::parse(text);
}

}  // namespace

Document::Document(std::string_view text, const std::string &name) : name_(name), parsed_(parse(text, name))
{
    if (!parsed_) refuse(parsed_.error().source(), "not TOML: " + std::string(parsed_.error().description()));
}

void Document::refuse(const toml::source_region &at, const std::string &sentence) const
{
    fail(CLQ_FORMAT, "%s, line %u, column %u: %s", name_.c_str(), unsigned(at.begin.line), unsigned(at.begin.column),
         sentence.c_str());
}

void Document::refuse(const toml::node &at, size_t offset, const std::string &sentence) const
{
    toml::source_region place = at.source();
    place.begin.column += static_cast<toml::source_index>(1 + offset);  // after the quote
    refuse(place, sentence);
}

const toml::table &Document::table(const toml::node &node, const std::string &what) const
{
    if (!node.is_table()) refuse(node, what + " is not a table");
    return *node.as_table();
}

const toml::array &Document::list(const toml::node &node, const std::string &what) const
{
    if (!node.is_array()) refuse(node, "'" + what + "' is not a list");
    return *node.as_array();
}

std::string Document::string(const toml::node &node, const std::string &what) const
{
    if (!node.is_string()) refuse(node, "'" + what + "' is not a string");
    std::string found = node.as_string()->get();
    if (found.find('\0') != std::string::npos) refuse(node, "'" + what + "' holds a zero byte");
    return found;
}

bool Document::truth(const toml::node &node, const std::string &what) const
{
    if (!node.is_boolean()) refuse(node, "'" + what + "' is neither true nor false");
    return node.as_boolean()->get();
}

double Document::number(const toml::node &node, const std::string &what) const
{
    std::string wrong;
    const double found = number_in(node, wrong);
    if (!wrong.empty()) refuse(node, "'" + what + "' " + wrong);
    return found;
}

double Document::number(const toml::node &node, const std::string &what, double least, double most) const
{
    const double found = number(node, what);
    if (!(found >= least && found <= most))
        refuse(node, text_of("'%s' is %g: %g to %g is wanted", what.c_str(), found, least, most));
    return found;
}

uint32_t Document::whole(const toml::node &node, const std::string &what, uint32_t least, uint32_t most) const
{
    const double found = number(node, what, least, most);
    if (found != std::floor(found)) refuse(node, text_of("'%s' is %g: a whole number is wanted", what.c_str(), found));
    return static_cast<uint32_t>(found);
}

void Document::point(const toml::node &node, const std::string &what, double out[3]) const
{
    const toml::array &all = list(node, what);
    if (all.size() != 3)
        refuse(node, "'" + what + "' has " + std::to_string(all.size()) + " numbers: x, y, z is wanted");
    for (size_t k = 0; k < 3; ++k) out[k] = number(all[k], what);
}

std::vector<std::pair<std::string, const toml::node *>> Document::strings(const toml::node &node,
                                                                          const std::string &what) const
{
    std::vector<std::pair<std::string, const toml::node *>> out;
    if (node.is_string()) {
        out.emplace_back(string(node, what), &node);
        return out;
    }
    if (!node.is_array() || node.as_array()->empty())
        refuse(node, "'" + what + "' is neither a string nor a list of some");
    for (const toml::node &one : *node.as_array()) out.emplace_back(string(one, what), &one);
    return out;
}

void Document::known(const toml::table &in, std::initializer_list<std::string_view> keys) const
{
    for (const auto &[key, node] : in_order(in))
        if (std::find(keys.begin(), keys.end(), key->str()) == keys.end())
            refuse(key->source(),
                   "'" + std::string(key->str()) + "' is not known here" + base::names_near(key->str(), keys));
}

std::vector<std::pair<const toml::key *, const toml::node *>> Document::in_order(const toml::table &from) const
{
    std::vector<std::pair<const toml::key *, const toml::node *>> all;
    for (const auto &[key, node] : from) all.emplace_back(&key, &node);
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
        const toml::source_position &x = a.first->source().begin, &y = b.first->source().begin;
        return x.line != y.line ? x.line < y.line : x.column < y.column;
    });
    return all;
}

}  // namespace claque::stage
