#include "samples/labels/variation/standpoint.h"

#include <algorithm>
#include <cmath>

#include "samples/labels/projection.h"
#include "samples/labels/variation/chance.h"
#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/toml_table.h"

namespace labels
{

using scenes::check;

namespace
{

constexpr double near_m = 0.1, far_m = 2500, hand_m = 0.2, steepest_rise = 11;  // 85 degrees

double distance(const std::array<double, 3> &a, const double (&b)[3])
{
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

}  // namespace

std::vector<Head> heads_of(Skeletons &skeletons, const scenes::Scene &scene, double time_s)
{
    std::vector<Head> out;
    for (const clq_actor actor : scene.actors()) {
        clq_actor_info info = clq_actor_info_init();
        check(clq_actor_get_info(scene.crowd(), actor, &info));
        const Skeletons::Skeleton &skeleton = skeletons.of(info.tmpl);
        if (skeleton.head.node == CLQ_NONE) continue;
        double m[16], root[16];
        check(clq_actor_get_node(scene.crowd(), actor, skeleton.head.node, time_s, m));
        check(clq_actor_get_node(scene.crowd(), actor, 0, time_s, root));
        Head head;
        head.actor = actor.index1;
        const std::array<double, 3> &at = skeleton.head.at;
        for (size_t k = 0; k < 3; ++k) head.at[k] = m[12 + k] + m[k] * at[0] + m[4 + k] * at[1] + m[8 + k] * at[2];
        // The first node is on the ground in most skeletons, and at the hips in some.
        const double up_m = skeleton.head_up_m * std::abs(static_cast<double>(info.transform.scale));
        const double standing_m = head.at[1] - up_m;
        head.ground_m = std::abs(root[13] - standing_m) < 0.35 * up_m ? root[13] : standing_m;
        out.push_back(head);
    }
    return out;
}

std::optional<Standpoint> stand(const CameraRules &rules, const std::vector<Head> &heads, const Choice &choice,
                                uint32_t attempt, double aspect, std::string &why_not)
{
    const auto number = [&](const Span &span, std::string_view purpose) {
        return span.first + (span.last - span.first) * chance(choice.seed, choice.sample, purpose, attempt);
    };
    Standpoint out;
    out.attempt = attempt;
    out.person = heads[static_cast<size_t>(static_cast<double>(heads.size()) *
                                           chance(choice.seed, choice.sample, "camera.person", attempt))];
    out.height_m = number(rules.height_m, "camera.height_m");
    out.distance_m = number(rules.distance_m, "camera.distance_m");
    out.heading_deg = number(rules.heading_deg, "camera.heading_deg");
    out.fov_deg = number(rules.fov_deg, "camera.fov_deg");
    const std::array<double, 3> &head = out.person.at;
    const double s = std::sin(out.heading_deg * scenes::radians), c = std::cos(out.heading_deg * scenes::radians);
    const double eye[3] = {head[0] + s * out.distance_m, out.person.ground_m + out.height_m,
                           head[2] + c * out.distance_m};
    double rise = (head[1] - eye[1]) / out.distance_m;
    if (rules.pitch_deg) {
        out.pitch_deg = number(*rules.pitch_deg, "camera.pitch_deg");
        rise = std::sin(*out.pitch_deg * scenes::radians) / std::cos(*out.pitch_deg * scenes::radians);
    }
    if (std::abs(rise) > steepest_rise) {
        why_not = "the camera is nearly above the person";
        return {};
    }
    const double target[3] = {eye[0] - s, eye[1] + rise, eye[2] - c};
    out.camera = scenes::look(eye, target, out.fov_deg, aspect, near_m, far_m);
    Sample picture;
    picture.width = 1, picture.height = 1, picture.camera = out.camera;
    std::array<double, 2> px;
    double depth_m = 0;
    if (!project(picture, head, px, depth_m) || px[0] < 0 || px[1] < 0 || px[0] >= 1 || px[1] >= 1) {
        why_not = "the head is not in the picture";
        return {};
    }
    for (const Head &one : heads)
        if (distance(one.at, eye) < rules.faces_m) {
            why_not = "a face is nearer than " + scenes::show(rules.faces_m) + " m";
            return {};
        }
    return out;
}

bool has_free_sight(scenes::SceneRenderer &scene, const Standpoint &from, double time_s)
{
    const double head[3] = {from.person.at[0], from.person.at[1], from.person.at[2]};
    const double to_eye_m = distance(from.person.at, from.camera.eye);
    const double aspect = static_cast<double>(scene.offscreen().width()) / scene.offscreen().height();
    scene.look_from(scenes::look(head, from.camera.eye, 5, aspect, near_m, far_m));
    scene.update(time_s);
    scene.begin_picture();
    scene.draw_environment();
    std::vector<float> depth;
    scene.offscreen().read_depth(depth);
    const size_t width = static_cast<size_t>(scene.offscreen().width()),
                 middle = static_cast<size_t>(scene.offscreen().height()) / 2 * width + width / 2;
    const double d = static_cast<double>(depth[middle]);
    // GL's depth back to metres.
    const double free_m = 1 / ((1 - d) / near_m + d / far_m);
    return free_m > to_eye_m + hand_m;
}

Json standpoint_json(const Standpoint &standpoint)
{
    Json out = {{"person", standpoint.person.actor},     {"attempt", standpoint.attempt},
                {"height_m", standpoint.height_m},       {"distance_m", standpoint.distance_m},
                {"heading_deg", standpoint.heading_deg}, {"fov_deg", standpoint.fov_deg}};
    if (standpoint.pitch_deg) out["pitch_deg"] = *standpoint.pitch_deg;
    return out;
}

}  // namespace labels
