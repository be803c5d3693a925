#include "samples/scenes/everything/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/everything/paint.h"
#include "samples/scenes/everything/shapes.h"
#include "samples/scenes/everything/sway.h"

namespace scenes::everything
{
namespace
{

enum Material : uint32_t { of_gown, of_sleeve, of_skin, of_hat, of_lantern, of_cape, material_count };

constexpr double neck_m = 1.42;

struct Place {
    double y, radius;
};

// Smooth between the places, which go upwards.
Profile through(std::vector<Place> places)
{
    return [places = std::move(places)](double y) {
        for (size_t i = 1; i < places.size(); ++i) {
            const Place &a = places[i - 1], &b = places[i];
            if (y > b.y && i + 1 < places.size()) continue;
            const double t = std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
            return a.radius + (b.radius - a.radius) * (1 - std::cos(t * two_pi / 2)) / 2;
        }
        return 0.0;
    };
}

Shape gown_of(double hem_m, double belly_m)
{
    Shape out = turned(through({{0, hem_m}, {0.25, 0.22}, {0.62, belly_m}, {0.98, 0.15}, {1.24, 0.18}, {neck_m, 0.06}}),
                       0, neck_m, 24, 20);
    follow_spine(out);
    tint(out, 0, 1.1);
    return out;
}

Profile ball(double radius)
{
    return [radius](double y) { return std::sqrt(std::max(1e-6, radius * radius - y * y)); };
}

// Node by node; translations are relative to the parent.
std::array<clq_node_def, node_count> nodes()
{
    static constexpr const char *names[node_count] = {"root",    "spine 1", "spine 2", "spine 3", "spine 4",
                                                      "spine 5", "spine 6", "spine 7", "spine 8", "head",
                                                      "arm",     "lantern", "mirror",  "left arm"};
    std::array<clq_node_def, node_count> out;
    for (uint32_t node = 0; node < node_count; ++node) {
        out[node] = clq_node_def_init();
        out[node].name = names[node];
        if (node > root) out[node].parent = node - 1;
        if (node >= spine && node < head) out[node].translation[1] = static_cast<float>(spine_step_m);
    }
    out[spine].translation[1] = static_cast<float>(spine_foot_m);
    out[head].translation[1] = 0.22f;
    const auto hang = [&](uint32_t node, uint32_t parent, float x, float y) {
        out[node].parent = parent, out[node].translation[0] = x, out[node].translation[1] = y;
    };
    constexpr uint32_t shoulders = spine + 6;
    hang(right_arm, shoulders, -0.21f, 0.12f);
    hang(lantern_node, right_arm, 0, -0.52f);
    hang(mirror, shoulders, 0, 0);
    hang(left_arm, mirror, -0.21f, 0.12f);
    out[mirror].scale[0] = -1;
    return out;
}

class Figure
{
public:
    Figure() : nodes_(nodes())
    {
        for (uint32_t joint = 0; joint < spine_joints; ++joint) {
            binds_[joint] = {
                1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, static_cast<float>(-spine_foot_m - spine_step_m * joint), 0, 1};
            joints_[joint] = {spine + joint, binds_[joint].data()};
        }
        add_zones();
        add_materials();
        add_parts();
    }

    Own<clq_template> build(clq_context *context) const
    {
        clq_template_def def = clq_template_def_init();
        def.name = "everything";
        def.node_count = node_count, def.nodes = nodes_.data();
        def.joint_count = spine_joints, def.joints = joints_.data();
        def.image_count = static_cast<uint32_t>(images_.size()), def.images = images_.data();
        def.zone_count = zone_count, def.zones = zones_.data();
        def.material_count = material_count, def.materials = materials_.data();
        def.part_count = static_cast<uint32_t>(parts_.size()), def.parts = parts_.data();
        def.clip_count = 1, def.clips = &sway_.clip();
        def.texture_set_count = 1, def.texture_sets = &chequers_;
        clq_template *made = nullptr;
        check(clq_template_build(context, &def, &made));
        return Own<clq_template>(made);
    }

private:
    void add_zones()
    {
        const auto zone = [&](Zone which, const char *name, const clq_hsb_range &range) {
            zones_[which] = clq_zone_def_init();
            zones_[which].name = name, zones_[which].key = key_of(which), zones_[which].range = range;
        };
        zone(gown, "gown", {0, 360, 0.35f, 0.75f, 0.55f, 0.95f});
        zone(trim, "trim", {35, 55, 0.3f, 0.8f, 0.8f, 1});
        zone(sash, "sash", {0, 360, 0.6f, 0.9f, 0.3f, 0.6f});
        zone(skin, "skin", {18, 30, 0.3f, 0.55f, 0.55f, 0.95f});
        zone(hat, "hat", {0, 360, 0.5f, 0.9f, 0.3f, 0.7f});
        zone(lantern, "lantern", {40, 55, 0.2f, 0.5f, 0.95f, 1});
        zone(cape_cloth, "cape", {0, 360, 0.5f, 0.9f, 0.4f, 0.8f});
    }

    void add_materials()
    {
        images_[0] = {"zigzag", image_px, image_px, zigzag_rgba_.data(), CLQ_ALPHA_ZONE_KEYS};
        images_[1] = {"chequers", image_px, image_px, chequers_rgba_.data(), CLQ_ALPHA_ZONE_KEYS};
        images_[2] = {"cape", image_px, image_px, cape_rgba_.data(), CLQ_ALPHA_OPACITY};
        for (clq_material_def &material : materials_) material = clq_material_def_init();
        materials_[of_gown].image = 0;
        materials_[of_gown].wrap_t = CLQ_WRAP_CLAMP;
        materials_[of_sleeve].zone = gown;
        materials_[of_skin].zone = skin;
        materials_[of_hat].zone = hat, materials_[of_hat].double_sided = true;
        materials_[of_lantern].zone = lantern;
        materials_[of_cape].zone = cape_cloth, materials_[of_cape].image = 2;
        materials_[of_cape].wrap_s = materials_[of_cape].wrap_t = CLQ_WRAP_CLAMP;
        materials_[of_cape].alpha_mode = CLQ_ALPHA_MASK, materials_[of_cape].double_sided = true;
        chequered_.fill(CLQ_NONE);
        chequered_[of_gown] = 1;
    }

    void add_parts()
    {
        for (uint32_t target = 0; target < morph_targets; ++target) {
            for (size_t i = 0; i < gown_.positions.size(); ++i) {
                moved_[target].push_back(stretched_[target].positions[i] - gown_.positions[i]);
                turned_[target].push_back(stretched_[target].normals[i] - gown_.normals[i]);
            }
            morphs_[target] = {moved_[target].data(), turned_[target].data(), 0};
        }
        add("gown", root, of_gown, gown_);
        parts_.back().morph_count = morph_targets, parts_.back().morphs = morphs_.data();
        add("cape", root, of_cape, cape_);
        add("head", head, of_skin, head_);
        add("hat", head, of_hat, hat_);
        add("right arm", right_arm, of_sleeve, arm_);
        add("left arm", left_arm, of_sleeve, arm_);
        add("lantern", lantern_node, of_lantern, lantern_);
        add("rod", lantern_node, of_hat, rod_);
    }

    void add(const char *name, uint32_t node, uint32_t material, const Shape &shape)
    {
        clq_part_def part = clq_part_def_init();
        part.name = name, part.node = node, part.material = material;
        part.vertex_count = shape.vertices();
        part.positions = shape.positions.data(), part.normals = shape.normals.data(), part.uvs = shape.uvs.data();
        if (!shape.colours.empty()) part.colours = shape.colours.data();
        if (!shape.weights.empty()) {
            part.influence_count = spine_joints;
            part.joints = shape.joints.data(), part.weights = shape.weights.data();
        }
        part.index_count = static_cast<uint32_t>(shape.indices.size()), part.indices = shape.indices.data();
        parts_.push_back(part);
    }

    static Shape cape_of()
    {
        Shape out = cape(0.12, 1.34, 14, 18);
        follow_spine(out);
        return out;
    }

    Sway sway_;
    std::array<clq_node_def, node_count> nodes_;
    std::array<std::array<float, 16>, spine_joints> binds_{};
    std::array<clq_joint_def, spine_joints> joints_{};
    std::array<clq_zone_def, zone_count> zones_{};
    std::array<clq_material_def, material_count> materials_{};
    std::array<uint32_t, material_count> chequered_{};
    std::array<clq_image_def, 3> images_{};
    std::vector<uint8_t> zigzag_rgba_ = gown_image(Pattern::zigzag), chequers_rgba_ = gown_image(Pattern::chequers),
                         cape_rgba_ = cape_image();
    clq_texture_set_def chequers_ = {"chequers", chequered_.data()};
    Shape gown_ = gown_of(0.30, 0.17), stretched_[morph_targets] = {gown_of(0.30, 0.29), gown_of(0.42, 0.17)};
    Shape cape_ = cape_of();
    Shape head_ = turned(ball(0.13), -0.129, 0.129, 10, 14);
    Shape hat_ = turned(through({{0.05, 0.22}, {0.09, 0.12}, {0.40, 0.005}}), 0.05, 0.40, 8, 14);
    Shape arm_ = turned(through({{-0.54, 0.01}, {-0.50, 0.075}, {-0.02, 0.045}, {0.03, 0.005}}), -0.54, 0.03, 12, 10);
    Shape lantern_ = turned(through({{-0.30, 0.02}, {-0.22, 0.10}, {-0.12, 0.10}, {-0.04, 0.02}}), -0.30, -0.04, 8, 12);
    Shape rod_ = box({-0.01, -0.06, -0.01}, {0.01, 0.04, 0.01});
    std::vector<float> moved_[morph_targets], turned_[morph_targets];
    std::array<clq_morph_def, morph_targets> morphs_{};
    std::vector<clq_part_def> parts_;
};

}  // namespace

clq_template *figure_of(Library &library)
{
    return library.own("everything", [&] { return Figure().build(library.context()); });
}

}  // namespace scenes::everything
