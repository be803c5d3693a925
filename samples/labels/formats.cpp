#include "samples/labels/formats.h"

#include <algorithm>

#include "samples/io/joined.h"
#include "samples/scenes/check.h"

namespace labels
{

const std::vector<std::string> &format_names()
{
    static const std::vector<std::string> all = {"coco",    "panoptic", "mot",   "kitti-flow", "flo",  "depth",
                                                 "normals", "boxes3d",  "heads", "npz",        "sheet"};
    return all;
}

std::set<std::string> read_formats(const std::string &text)
{
    std::set<std::string> out;
    for (size_t from = 0; from <= text.size();) {
        const size_t comma = std::min(text.find(',', from), text.size());
        const std::string name = text.substr(from, comma - from);
        from = comma + 1;
        if (std::find(format_names().begin(), format_names().end(), name) == format_names().end())
            throw scenes::Failure("there is no format '" + name + "' of labels; there are " +
                                  io::joined(format_names()));
        out.insert(name);
    }
    return out;
}

}  // namespace labels
