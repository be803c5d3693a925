// Sentences about a name that is not there: the names that are near it, by edit distance, or all that there are.
// It needs the standard library alone, so libclaque-stage and the samples include it too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace claque::base
{

// What follows a sentence like "there is no clip 'Wlak'": ": 'Walk' and 'Walk_Back' are near", or "; there are: fly,
// glide", or "; there are none". The first are told where there are more than a few.
std::string names_near(std::string_view wanted, const std::vector<std::string_view> &names);
// "'Walk' and 'Walk_Back' are near" alone, or "".
std::string near_names(std::string_view wanted, const std::vector<std::string_view> &names);

// Both for any range of texts.
template <class Names>
std::vector<std::string_view> views_of(const Names &names)
{
    std::vector<std::string_view> all;
    for (const auto &name : names) all.emplace_back(name);
    return all;
}
template <class Names>
std::string names_near(std::string_view wanted, const Names &names)
{
    return names_near(wanted, views_of(names));
}
template <class Names>
std::string near_names(std::string_view wanted, const Names &names)
{
    return near_names(wanted, views_of(names));
}

}  // namespace claque::base
