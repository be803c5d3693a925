#include "lib/base/near_names.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace claque::base
{

namespace
{

constexpr size_t most_compared = 4096, most_letters = 64, most_near = 3, most_told = 24;

std::string lower(std::string_view text)
{
    std::string out(text.substr(0, most_letters));
    for (char &c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

// Letters to add, to leave out, to replace or to swap with the next, so that `a` becomes `b`, or with `within` any part
// of it.
size_t distance(const std::string &a, const std::string &b, bool within)
{
    std::vector<size_t> before, above(b.size() + 1), row(b.size() + 1);
    if (!within) std::iota(above.begin(), above.end(), size_t(0));
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(above, row);
    }
    return within ? *std::min_element(above.begin(), above.end()) : above.back();
}

bool is_part(const std::string &part, const std::string &of)
{
    if (part.size() < 3) return false;
    const size_t letters = distance(part, of, true);
    return letters == 0 || (part[0] == of[0] && 4 * letters <= part.size());
}

std::string joined(const std::vector<std::string_view> &names, const char *quote, const char *last)
{
    std::string out;
    for (size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 < names.size() ? ", " : last) + (quote + std::string(names[i])) + quote;
    return out;
}

}  // namespace

// Near are names of which a third of the letters differ, if no other is two letters nearer, and those of which one is a
// part of the other; where both begin alike, but for a quarter of its letters.
std::string near_names(std::string_view wanted, const std::vector<std::string_view> &names)
{
    struct Found {
        size_t letters, at;
        bool part;
    };
    std::vector<Found> found;
    const std::string asked = lower(wanted);
    for (size_t i = 0; i < std::min(names.size(), most_compared); ++i) {
        const std::string name = lower(names[i]);
        if (name.empty()) continue;
        const Found one = {distance(asked, name, false), i, is_part(asked, name) || is_part(name, asked)};
        if (one.part || 3 * one.letters <= std::max(asked.size(), name.size())) found.push_back(one);
    }
    std::stable_sort(found.begin(), found.end(), [](const Found &a, const Found &b) { return a.letters < b.letters; });
    std::vector<std::string_view> told;
    for (const Found &one : found) {
        const bool is_new = std::find(told.begin(), told.end(), names[one.at]) == told.end();
        if (told.size() < most_near && is_new && (one.part || one.letters <= found[0].letters + 1))
            told.push_back(names[one.at]);
    }
    return told.empty() ? "" : joined(told, "'", " and ") + (told.size() == 1 ? " is near" : " are near");
}

std::string names_near(std::string_view wanted, const std::vector<std::string_view> &given)
{
    std::vector<std::string_view> names;
    std::copy_if(given.begin(), given.end(), std::back_inserter(names),
                 [](std::string_view one) { return !one.empty(); });
    const std::string near = near_names(wanted, names);
    if (!near.empty()) return ": " + near;
    if (names.empty()) return "; there are none";
    const size_t told = std::min(names.size(), most_told), more = names.size() - told;
    return "; there are: " + joined({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(told)}, "", ", ") +
           (more ? " and " + std::to_string(more) + " more" : "");
}

}  // namespace claque::base
