// Joint maps: a TOML file, written by hand, that binds joints and says how the clips of a source are read.
#pragma once

#include <claque/assets.h>

#include <string>
#include <vector>

namespace cli
{

struct JointMap {
    struct Joint {
        std::string source, target;
        clq_rest_alignment rest = CLQ_REST_KEEP;
    };
    std::vector<Joint> joints;                                       // none: joints of equal names
    std::vector<std::pair<std::string, std::string>> followers;      // each a joint and its leader
    std::vector<std::pair<std::string, std::string>> followers_too;  // second leaders
    double follow_share = 0.8, follow_too_share = 0.4;
    std::vector<std::string> clips;  // none: all
    std::string prefix;
    double unit_m = 0;  // of BVH files; 0: 1
    clq_source_rest rest = CLQ_SOURCE_REST_AUTOMATIC;
    uint32_t rest_frame = 0;
    clq_root_travel travel = CLQ_ROOT_TRAVEL_IN_PLACE;
    double rate_hz = 0, start_s = 0, end_s = 0, close_s = 0;
};

// Throws Failure with the line and the error in it.
JointMap read_joint_map(const std::string &text, const std::string &where);

// Accepts "in-place" and "keep"; returns false for anything else.
bool travel_named(const std::string &name, clq_root_travel &out);

}  // namespace cli
