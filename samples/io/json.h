// JSON that another program wrote. The parser itself has no limit of depth, and values are walked and freed by
// recursion.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace io
{

constexpr int max_json_depth = 64;

// Whether lists and members nest too deep. Wrong syntax may hide that only where the parser would stop before it. The
// parser could ask for itself at each value, but then walks through a list at the end of each of its members.
inline bool is_deep_json(const std::string &json)
{
    int depth = 0;
    bool quoted = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (quoted && c == '\\') ++i;
        else if (c == '"') quoted = !quoted;
        else if (!quoted && (c == ']' || c == '}')) --depth;
        else if (!quoted && (c == '[' || c == '{') && ++depth > max_json_depth) return true;
    }
    return false;
}

// Returns a discarded value and says in `problem` what is wrong with it, as in "is not JSON".
template <class Json>
Json parse_json(const std::string &json, std::string &problem)
{
    problem.clear();
    Json parsed(Json::value_t::discarded);
    if (is_deep_json(json)) problem = "is nested more than " + std::to_string(max_json_depth) + " deep";
    else parsed = Json::parse(json, nullptr, false);
    if (problem.empty() && parsed.is_discarded()) problem = "is not JSON";
    return parsed;
}

// A whole number from `least` to `most`, which a double holds; none: the value is something else. The conversions of
// the parser wrap.
template <class Json>
std::optional<int64_t> whole_in(const Json &value, int64_t least, int64_t most)
{
    if (!value.is_number()) return {};
    const double number = value.template get<double>();
    if (!(number >= static_cast<double>(least) && number <= static_cast<double>(most))) return {};
    const int64_t whole = static_cast<int64_t>(number);
    if (static_cast<double>(whole) != number) return {};
    return whole;
}

}  // namespace io
