#include "samples/labels/joint_names.h"

#include <claque/template.h>

#include <cctype>

namespace labels
{
namespace
{

// Names that joints may have, in lower case and without prefixes and separators. "*" is the letter of the side, "@" its
// word.
const std::map<std::string, std::vector<std::string>> &joints()
{
    static const std::map<std::string, std::vector<std::string>> all = {
        {"pelvis", {"hips", "pelvis", "hip"}},
        {"spine1", {"spine", "spine1", "abdomen", "abdomenlower", "torsojoint1"}},
        {"spine2", {"spineupper", "spine1", "spine2", "abdomen2", "abdomenupper", "torso", "chest"}},
        {"spine3", {"upperchest", "chestupper", "chest", "spine2", "spine3", "torso"}},
        {"neck", {"neck", "neck1", "necklower", "neckjoint1"}},
        {"head", {"head", "neckjoint2", "skeletonneckjoint2"}},
        {"collar", {"clavicle*", "*clavicle", "@shoulder", "*shoulder", "shoulder*", "collar*", "*collar"}},
        {"shoulder", {"upperarm*", "@arm", "@upperarm", "*upperarm", "*shldr", "*shldrbend", "armjoint*1"}},
        {"elbow",
         {"forearm*", "lowerarm*", "@forearm", "@lowerarm", "*lowerarm", "*forearm", "*forearmbend", "armjoint*2"}},
        {"wrist", {"hand*", "wrist*", "@hand", "*hand", "fist*", "palm*", "armjoint*3"}},
        {"hand",
         {"fingers*", "hand*", "@handmiddle1", "@middleproximal", "*middle1", "middle1*", "middle2*", "*mid1",
          "*finger2", "fist*"}},
        {"hip", {"thigh*", "upperleg*", "@upleg", "@upperleg", "*upperleg", "*thigh", "*thighbend", "legjoint*1"}},
        {"knee", {"shin*", "lowerleg*", "@leg", "@lowerleg", "*lowerleg", "calf*", "*shin", "*calf", "legjoint*2"}},
        {"ankle", {"foot*", "@foot", "*foot", "legjoint*3"}},
        {"foot", {"toes*", "toe*", "@toes", "@toebase", "*toebase", "*toes", "*toe", "*toe0", "legjoint*5"}}};
    return all;
}

std::string with_side(const std::string &pattern, bool left)
{
    std::string out;
    for (const char c : pattern)
        if (c == '*') out += left ? "l" : "r";
        else if (c == '@') out += left ? "left" : "right";
        else out += c;
    return out;
}

uint32_t find_on_side(const std::map<std::string, uint32_t> &nodes, const std::string &joint, bool left)
{
    for (const std::string &pattern : joints().at(joint)) {
        const auto found = nodes.find(with_side(pattern, left));
        if (found != nodes.end()) return found->second;
    }
    return CLQ_NONE;
}

}  // namespace

std::string plain_name(const std::string &name)
{
    std::string out;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char *prefix : {"mixamorig", "jbipc", "jbip", "bip01", "bip001", "def"})
        if (out.rfind(prefix, 0) == 0 && out.size() > std::string(prefix).size())
            return out.substr(std::string(prefix).size());
    return out;
}

uint32_t find_joint(const std::map<std::string, uint32_t> &nodes, const std::string &joint)
{
    for (const bool left : {true, false}) {
        const std::string side = left ? "left_" : "right_";
        if (joint.rfind(side, 0) == 0) {
            const std::string one = joint.substr(side.size());
            return joints().count(one) != 0 ? find_on_side(nodes, one, left) : CLQ_NONE;
        }
    }
    return joints().count(joint) != 0 ? find_on_side(nodes, joint, true) : CLQ_NONE;
}

const std::vector<std::string> &joint_names()
{
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names;
        for (const auto &[joint, patterns] : joints()) {
            const bool has_sides = patterns.front().find_first_of("*@") != std::string::npos;
            for (const char *side : {"left_", "right_"})
                if (has_sides) names.push_back(side + joint);
            if (!has_sides) names.push_back(joint);
        }
        return names;
    }();
    return all;
}

}  // namespace labels
