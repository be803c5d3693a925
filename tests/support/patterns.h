// Regular expressions of C++ (ECMAScript) for tests. <regex> takes a second and more to compile, so one source has it.
#pragma once

#include <string>
#include <vector>

namespace patterns
{

// All of a match, then its groups.
using Match = std::vector<std::string>;

// Whether `pattern` describes all of `text`.
bool describes(const std::string &pattern, const std::string &text);

// The first match in `text`; empty if there is none.
Match first_match(const std::string &pattern, const std::string &text);

std::vector<Match> matches(const std::string &pattern, const std::string &text);

}  // namespace patterns
