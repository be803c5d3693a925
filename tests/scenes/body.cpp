#include "tests/scenes/body.h"

#include <glm/geometric.hpp>

namespace bodies
{
namespace
{

claque::model::Model model_of(const std::string &figure)
{
    for (const claque::figures::Builtin &builtin : claque::figures::builtins())
        if (builtin.name == figure) return builtin.make();
    throw scenes::Failure("no figure '" + figure + "'");
}

}  // namespace

double depth(const Capsule &c, const glm::dvec3 &p)
{
    const glm::dvec3 along = c.to - c.from;
    const double t = glm::clamp(glm::dot(p - c.from, along) / glm::dot(along, along), 0.0, 1.0);
    return c.radius - glm::length(p - c.from - t * along);
}

Body::Body(const std::string &figure) : model_(model_of(figure)), workspace_(model_.rig)
{
    clq_context *context = nullptr;
    scenes::check(clq_context_create(nullptr, &context));
    context_.reset(context);
    clq_asset *asset = nullptr;
    scenes::check(clq_asset_builtin(context, figure.c_str(), &asset));
    asset_.reset(asset);
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset, &info));
    xyz_.resize(3 * static_cast<size_t>(info.vertex_count));
    vertices_.resize(info.vertex_count);
}

uint32_t Body::clip(const std::string &name) const
{
    const uint32_t found = model_.rig.find_clip(name);
    if (found == claque::model::none) throw scenes::Failure("no clip '" + name + "'");
    return found;
}

double Body::duration_s(uint32_t clip) const { return static_cast<double>(model_.rig.clips[clip].duration_s); }

void Body::pose(uint32_t clip, double time_s)
{
    workspace_.pose(clip, time_s);
    scenes::check(clq_asset_get_positions(asset_.get(), clip, static_cast<float>(time_s), xyz_.data(), xyz_.size()));
    for (size_t v = 0; v < vertices_.size(); ++v)
        vertices_[v] = {double(xyz_[3 * v]), double(xyz_[3 * v + 1]), double(xyz_[3 * v + 2])};
}

glm::dvec3 Body::joint(const char *name) const
{
    return claque::math::transform_point(workspace_.global(model_.rig.find_node(name)), glm::vec3(0));
}

glm::dvec3 Body::hips() const { return 0.5 * (joint("thigh_l") + joint("thigh_r")); }

std::vector<Capsule> Body::capsules() const
{
    const glm::dvec3 head = joint("head");
    std::vector<Capsule> all = {{joint("pelvis"), joint("chest"), 0.105, "trunk"},
                                {joint("chest"), joint("neck"), 0.09, "chest"},
                                {head, head + glm::normalize(head - joint("neck")) * 0.12, 0.075, "head"}};
    for (const std::string side : {"_l", "_r"}) {
        const auto at = [&](const std::string &name) { return joint((name + side).c_str()); };
        all.push_back({at("upper_arm"), at("forearm"), 0.040, "upper arm"});
        all.push_back({at("forearm"), at("hand"), 0.030, "forearm"});
        all.push_back({at("thigh"), at("shin"), 0.065, "thigh"});
        all.push_back({at("shin"), at("foot"), 0.040, "shin"});
        all.push_back({at("foot"), at("toes"), 0.025, "foot"});
    }
    return all;
}

glm::dvec3 placed(const clq_transform &place, const glm::dvec3 &p)
{
    const double s = place.orientation_xyzw[1], c = place.orientation_xyzw[3];
    const double turn_s = 2 * s * c, turn_c = c * c - s * s, scale = place.scale;
    return {place.position[0] + scale * (p.x * turn_c + p.z * turn_s), place.position[1] + scale * p.y,
            place.position[2] + scale * (p.z * turn_c - p.x * turn_s)};
}

}  // namespace bodies
