#include "tests/support/patterns.h"

#include <map>
#include <regex>

namespace patterns
{

namespace
{

// Compiled once for each thread, as some are asked for each line of a file.
const std::regex &compiled(const std::string &pattern)
{
    thread_local std::map<std::string, std::regex> known;
    const auto at = known.find(pattern);
    return at != known.end() ? at->second : known.emplace(pattern, std::regex(pattern)).first->second;
}

Match strings_of(const std::smatch &found) { return {found.begin(), found.end()}; }

}  // namespace

bool describes(const std::string &pattern, const std::string &text)
{
    return std::regex_match(text, compiled(pattern));
}

Match first_match(const std::string &pattern, const std::string &text)
{
    std::smatch found;
    return std::regex_search(text, found, compiled(pattern)) ? strings_of(found) : Match();
}

std::vector<Match> matches(const std::string &pattern, const std::string &text)
{
    std::vector<Match> out;
    for (std::sregex_iterator at(text.begin(), text.end(), compiled(pattern)), end; at != end; ++at)
        out.push_back(strings_of(*at));
    return out;
}

}  // namespace patterns
