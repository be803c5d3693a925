#include "samples/cli/clip_choice.h"

#include <algorithm>

#include "lib/base/near_names.h"
#include "samples/io/whole_number.h"
#include "samples/scenes/check.h"

namespace cli
{

uint32_t clip_named(const std::string &name, const std::vector<std::string> &clips, const std::string &of)
{
    const auto found = std::find(clips.begin(), clips.end(), name);
    if (found != clips.end()) return static_cast<uint32_t>(found - clips.begin());
    uint64_t number = 0;
    if (io::read_whole_number(name, number) && number < clips.size()) return static_cast<uint32_t>(number);
    throw scenes::Failure(of + " has no clip '" + name + "' among its " + std::to_string(clips.size()) +
                          claque::base::names_near(name, clips));
}

}  // namespace cli
