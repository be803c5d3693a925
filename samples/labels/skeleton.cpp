#include "samples/labels/skeleton.h"

#include <algorithm>
#include <cmath>

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

// Points of the face in the space of the model, in heights of the head above its joint; people face +z and their left
// is +x.
const std::map<std::string, std::array<double, 3>> &face()
{
    static const std::map<std::string, std::array<double, 3>> all = {{"nose", {0, 0.42, 0.52}},
                                                                     {"left_eye", {0.15, 0.55, 0.42}},
                                                                     {"right_eye", {-0.15, 0.55, 0.42}},
                                                                     {"left_ear", {0.36, 0.48, 0.05}},
                                                                     {"right_ear", {-0.36, 0.48, 0.05}}};
    return all;
}

// The template in its rest pose, in a crowd of its own.
class Rest
{
public:
    Rest(scenes::Library &library, const clq_template *tmpl)
    {
        clq_crowd_def crowd_def = clq_crowd_def_init();
        crowd_def.period_near_s = crowd_def.period_far_s = crowd_def.lod_scale = 0;
        clq_crowd *crowd = nullptr;
        check(clq_crowd_create(library.context(), &crowd_def, &crowd));
        crowd_.reset(crowd);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = const_cast<clq_template *>(tmpl);
        def.play.clip = CLQ_NONE;
        check(clq_actor_create(crowd, &def, &actor_));
    }
    std::array<double, 16> node(uint32_t node) const
    {
        std::array<double, 16> m;
        check(clq_actor_get_node(crowd_.get(), actor_, node, 0, m.data()));
        return m;
    }

    // How far the body reaches above a height.
    double top_above(double height) const
    {
        clq_actor_info info = clq_actor_info_init();
        check(clq_actor_get_info(crowd_.get(), actor_, &info));
        const double away = 4 * static_cast<double>(info.refpoint_radius);  // a sphere round the origin
        clq_look_at_def look = clq_look_at_def_init();
        look.target[2] = 0, look.eye[2] = away;
        look.z_near = static_cast<float>(away / 100), look.z_far = static_cast<float>(4 * away);
        clq_camera camera = {};
        check(clq_camera_look_at(&look, &camera));
        clq_view *view = nullptr;
        check(clq_view_create(crowd_.get(), &view));
        check(clq_view_set_camera(view, &camera));
        check(clq_crowd_update(crowd_.get(), 0, &view, 1));
        clq_drawn_actor drawn = clq_drawn_actor_init();
        check(clq_view_get_drawn_actor(view, 0, &drawn));
        std::vector<float> xyz(3 * static_cast<size_t>(drawn.vertex_count));
        check(clq_view_get_vertices(view, 0, xyz.data(), nullptr, drawn.vertex_count));
        double top = height;
        for (size_t v = 1; v < xyz.size(); v += 3) top = std::max(top, static_cast<double>(xyz[v]));
        return top - height;
    }

private:
    scenes::Own<clq_crowd> crowd_;
    clq_actor actor_ = {};
};

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
    const Rest rest(library_, tmpl);
    const uint32_t head = find_joint(nodes, "head", true);
    std::array<double, 16> at_head = {};
    if (head != CLQ_NONE) {
        at_head = rest.node(head);
        const double tall = rest.top_above(at_head[13]);
        made.head_m = tall / 2;
        made.head = {head, in_frame(at_head, {0, tall / 2, 0.1 * tall})};
    }
    for (const std::string &name : set_.names) {
        Place place;
        const auto of_face = face().find(name);
        if (of_face == face().end()) place.node = find_keypoint(nodes, name);
        else if (head != CLQ_NONE) {
            const double tall = 2 * made.head_m;
            place.node = head;
            place.at =
                in_frame(at_head, {of_face->second[0] * tall, of_face->second[1] * tall, of_face->second[2] * tall});
        }
        made.places.push_back(place);
    }
    return known_.emplace(tmpl, std::move(made)).first->second;
}

}  // namespace labels
