#include "samples/labels/skeleton.h"

#include <algorithm>
#include <cctype>

#include "samples/labels/face.h"
#include "samples/labels/rest_pose.h"

namespace labels
{

using scenes::check;

namespace
{

// Candidates for the name of a joint, without prefixes, separators and case; "*" stands for the side's letter, "@" for
// its word.
const std::map<std::string, std::vector<std::string>> &joints()
{
    static const std::map<std::string, std::vector<std::string>> all = {
        {"pelvis", {"hips", "pelvis", "hip"}},
        {"spine1", {"spine", "spine1", "abdomen", "torsojoint1"}},
        {"spine2", {"spineupper", "spine1", "spine2", "torso", "chest"}},
        {"spine3", {"chest", "upperchest", "spine2", "spine3", "torso"}},
        {"neck", {"neck", "neck1", "neckjoint1"}},
        {"head", {"head", "neckjoint2", "skeletonneckjoint2"}},
        {"collar", {"clavicle*", "@shoulder", "*shoulder", "shoulder*", "collar*"}},
        {"shoulder", {"upperarm*", "@arm", "@upperarm", "*upperarm", "armjoint*1"}},
        {"elbow", {"forearm*", "lowerarm*", "@forearm", "@lowerarm", "*lowerarm", "armjoint*2"}},
        {"wrist", {"hand*", "wrist*", "@hand", "*hand", "fist*", "palm*", "armjoint*3"}},
        {"hand", {"fingers*", "hand*", "@handmiddle1", "*middle1", "middle1*", "middle2*", "fist*"}},
        {"hip", {"thigh*", "upperleg*", "@upleg", "@upperleg", "*upperleg", "legjoint*1"}},
        {"knee", {"shin*", "lowerleg*", "@leg", "@lowerleg", "*lowerleg", "calf*", "legjoint*2"}},
        {"ankle", {"foot*", "@foot", "*foot", "legjoint*3"}},
        {"foot", {"toes*", "toe*", "@toebase", "*toebase", "legjoint*5"}}};
    return all;
}

std::string plain(std::string name)
{
    std::string out;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char *prefix : {"mixamorig", "jbipc", "jbip", "bip01", "def"})
        if (out.rfind(prefix, 0) == 0 && out.size() > std::string(prefix).size())
            return out.substr(std::string(prefix).size());
    return out;
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

uint32_t find_joint(const std::map<std::string, uint32_t> &nodes, const std::string &joint, bool left)
{
    for (const std::string &pattern : joints().at(joint)) {
        const auto found = nodes.find(with_side(pattern, left));
        if (found != nodes.end()) return found->second;
    }
    return CLQ_NONE;
}

uint32_t find_keypoint(const std::map<std::string, uint32_t> &nodes, const std::string &name)
{
    for (const bool left : {true, false}) {
        const std::string side = left ? "left_" : "right_";
        if (name.rfind(side, 0) == 0) {
            const std::string joint = name.substr(side.size());
            return joints().count(joint) != 0 ? find_joint(nodes, joint, left) : CLQ_NONE;
        }
    }
    return joints().count(name) != 0 ? find_joint(nodes, name, true) : CLQ_NONE;
}

// A vector of the model in the frame of a node whose axes are of one length and perpendicular.
std::array<double, 3> in_frame(const std::array<double, 16> &m, const std::array<double, 3> &v)
{
    std::array<double, 3> out;
    for (size_t k = 0; k < 3; ++k) {
        const double *axis = &m[4 * k];
        const double square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
        out[k] = (axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2]) / square;
    }
    return out;
}

}  // namespace

const KeypointSet &coco_keypoints()
{
    static const KeypointSet set = {"coco",
                                    {"nose", "left_eye", "right_eye", "left_ear", "right_ear", "left_shoulder",
                                     "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
                                     "left_hip", "right_hip", "left_knee", "right_knee", "left_ankle", "right_ankle"},
                                    {{15, 13},
                                     {13, 11},
                                     {16, 14},
                                     {14, 12},
                                     {11, 12},
                                     {5, 11},
                                     {6, 12},
                                     {5, 6},
                                     {5, 7},
                                     {6, 8},
                                     {7, 9},
                                     {8, 10},
                                     {1, 2},
                                     {0, 1},
                                     {0, 2},
                                     {1, 3},
                                     {2, 4},
                                     {3, 5},
                                     {4, 6}}};
    return set;
}

const KeypointSet &smpl_keypoints()
{
    static const KeypointSet set = {
        "smpl",
        {"pelvis",     "left_hip",    "right_hip",    "spine1",      "left_knee",     "right_knee",
         "spine2",     "left_ankle",  "right_ankle",  "spine3",      "left_foot",     "right_foot",
         "neck",       "left_collar", "right_collar", "head",        "left_shoulder", "right_shoulder",
         "left_elbow", "right_elbow", "left_wrist",   "right_wrist", "left_hand",     "right_hand"},
        {{0, 1},   {0, 2},   {0, 3},   {1, 4},   {2, 5},   {3, 6},   {4, 7},   {5, 8},
         {6, 9},   {7, 10},  {8, 11},  {9, 12},  {9, 13},  {9, 14},  {12, 15}, {13, 16},
         {14, 17}, {16, 18}, {17, 19}, {18, 20}, {19, 21}, {20, 22}, {21, 23}}};
    return set;
}

const KeypointSet &keypoint_set(const std::string &name)
{
    if (name == "coco") return coco_keypoints();
    if (name == "smpl") return smpl_keypoints();
    throw scenes::Failure("there are no keypoints '" + name + "'; there are coco and smpl");
}

const Skeletons::Skeleton &Skeletons::of(const clq_template *tmpl)
{
    const auto known = known_.find(tmpl);
    if (known != known_.end()) return known->second;
    Skeleton made;
    std::map<std::string, uint32_t> nodes;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.node_count; ++i) nodes.emplace(plain(clq_template_get_node_name(tmpl, i)), i);
    const uint32_t head = find_joint(nodes, "head", true);
    Face face;
    std::array<double, 16> at_head = {};
    if (head != CLQ_NONE) {
        const RestPose rest(library_, tmpl);
        at_head = rest.node(head);
        const std::vector<float> xyz = rest.vertices();
        face = face_of({at_head[12], at_head[13], at_head[14]}, xyz);
        double lowest = at_head[13];
        for (size_t v = 1; v < xyz.size(); v += 3) lowest = std::min(lowest, static_cast<double>(xyz[v]));
        made.head_up_m = at_head[13] + face.middle[1] - lowest;
        made.head = {head, in_frame(at_head, face.middle), 1.5 * face.radius_m};
    }
    const bool has_face = head != CLQ_NONE;
    for (const std::string &name : set_.names) {
        const auto of_face = has_face ? face.points.find(name) : face.points.end();
        Place place;
        if (of_face == face.points.end()) place = {find_keypoint(nodes, name), {0, 0, 0}, 1.2 * face.radius_m};
        else place = {head, in_frame(at_head, of_face->second), 0.4 * face.radius_m};
        made.places.push_back(place);
    }
    return known_.emplace(tmpl, std::move(made)).first->second;
}

}  // namespace labels
