#include "samples/labels/skeleton.h"

#include <algorithm>

#include "samples/labels/face.h"
#include "samples/labels/joint_names.h"
#include "samples/scenes/posed_template.h"

namespace labels
{

using scenes::check;

namespace
{

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

const Skeletons::Skeleton &Skeletons::of(const clq_template *tmpl)
{
    const auto known = known_.find(tmpl);
    if (known != known_.end()) return known->second;
    Skeleton made;
    std::map<std::string, uint32_t> plain, exact;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.node_count; ++i) {
        const char *name = clq_template_get_node_name(tmpl, i);
        plain.emplace(plain_name(name), i), exact.emplace(name, i);
    }
    scenes::PosedTemplate rest(library_, tmpl);
    const uint32_t head = find_joint(plain, "head");
    Face face;
    std::array<double, 16> at_head = {};
    if (head != CLQ_NONE) {
        at_head = rest.node(head);
        const std::vector<float> xyz = rest.vertices();
        face = face_of({at_head[12], at_head[13], at_head[14]}, xyz);
        double lowest = at_head[13];
        for (size_t v = 1; v < xyz.size(); v += 3) lowest = std::min(lowest, static_cast<double>(xyz[v]));
        made.head_up_m = at_head[13] + face.middle[1] - lowest;
        made.head = {head, in_frame(at_head, face.middle), 1.5 * face.radius_m};
    }
    const auto place_of = [&](const std::string &joint, const std::array<double, 3> &offset_m) -> Place {
        const auto of_face = face.points.find(joint);
        if (of_face == face.points.end()) {
            const uint32_t node = find_joint(plain, joint);
            if (node == CLQ_NONE) return {};
            return {node, in_frame(rest.node(node), offset_m), 1.2 * face.radius_m};
        }
        const std::array<double, 3> &at = of_face->second;
        return {head, in_frame(at_head, {at[0] + offset_m[0], at[1] + offset_m[1], at[2] + offset_m[2]}),
                0.4 * face.radius_m};
    };
    for (const std::string &name : set_.names) {
        const auto own = set_.own.find(name);
        if (own == set_.own.end()) made.places.push_back(place_of(name, {0, 0, 0}));
        else if (!own->second.joint.empty()) made.places.push_back(place_of(own->second.joint, own->second.offset_m));
        else {
            Place place;
            for (const std::string &node : own->second.nodes)
                if (place.node == CLQ_NONE && exact.count(node) != 0)
                    place = {exact[node], in_frame(rest.node(exact[node]), own->second.offset_m), 1.2 * face.radius_m};
            made.places.push_back(place);
        }
    }
    return known_.emplace(tmpl, std::move(made)).first->second;
}

}  // namespace labels
