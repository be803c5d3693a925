// Words of a list in one text, as in "coco, flo, depth".
#pragma once

#include <string>

namespace io
{

// `words`: any range of texts.
template <class Words>
std::string joined(const Words &words)
{
    std::string all;
    bool first = true;
    for (const auto &word : words) {
        if (!first) all += ", ";
        all += word, first = false;
    }
    return all;
}

}  // namespace io
