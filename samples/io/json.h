// JSON that another program wrote. The parser itself has no limit of depth, and values are walked and freed by
// recursion.
#pragma once

#include <string>

namespace io
{

constexpr int max_json_depth = 64;

// Returns a discarded value and says in `problem` what is wrong with it, as in "is not JSON".
template <class Json>
Json parse_json(const std::string &json, std::string &problem)
{
    problem.clear();
    const auto shallow = [&problem](int depth, typename Json::parse_event_t, Json &) {
        if (depth > max_json_depth) problem = "is nested more than " + std::to_string(max_json_depth) + " deep";
        return depth <= max_json_depth;
    };
    Json parsed = Json::parse(json, shallow, false);
    if (problem.empty() && parsed.is_discarded()) problem = "is not JSON";
    return problem.empty() ? parsed : Json(Json::value_t::discarded);
}

}  // namespace io
