#include "samples/scenes/hundred/dragon_mechanisms.h"

#include <vector>

#include "samples/scenes/hundred/dragon_plan.h"
#include "samples/scenes/random.h"

namespace scenes::hundred
{
namespace
{

clq_mechanism_def parse_toml(clq_mechanism_kind kind, const clq_template *dragon)
{
    clq_mechanism_def def = clq_mechanism_def_init();
    def.kind = kind;
    def.tmpl = dragon;
    return def;
}

using Values = std::vector<clq_dof_value>;

clq_dof_pose shape_of(const Values &values) { return {static_cast<uint32_t>(values.size()), values.data()}; }

// The value at a fraction of the way from rest to the end of the range.
clq_dof_value leaning(uint32_t dof, const clq_dof_def &def, double share)
{
    const float end = share < 0 ? def.min : def.max;
    const double value =
        static_cast<double>(def.rest) + (static_cast<double>(end - def.rest)) * (share < 0 ? -share : share);
    return {dof, static_cast<float>(value)};
}

enum class What { yaw, pitch, roll };

What what_of(const clq_dof_def &dof)
{
    return dof.axis[0] != 0 ? What::pitch : dof.axis[1] != 0 ? What::yaw : What::roll;
}

// `yaw` and `pitch` of the trunk, from the neck to the fin; `row` of the legs; `surge` ahead.
struct Bearing {
    double yaw, pitch, row, surge;
};

Values bearing(const Bearing &b)
{
    Values values;
    const auto all = dofs();
    for (uint32_t i = 0; i < dof_count; ++i) {
        const clq_dof_def &dof = all[i];
        const uint32_t node = dof.node;
        const bool trunk = node == chest || (node >= neck1 && node <= neck3) || (node >= loin && node <= fin);
        const What what = what_of(dof);
        if (node == heart) values.push_back(leaning(i, dof, b.surge));
        else if (trunk) {
            const bool ahead = node <= neck3;  // the neck bends against the tail: an S
            values.push_back(
                leaning(i, dof, what == What::yaw ? (ahead ? -b.yaw : b.yaw) : (ahead ? b.pitch : -b.pitch)));
        } else if (node >= legs) {
            const double side = skeleton()[node].x > 0 ? 1 : -1;
            values.push_back(leaning(i, dof, what == What::pitch ? b.row : side * 0.4 * b.row));
        }
    }
    return values;
}

// Ears, whiskers and crest up or down, and the head to one side.
Values look_of(double up, double aside)
{
    Values values;
    const auto all = dofs();
    for (uint32_t i = 0; i < dof_count; ++i) {
        const uint32_t node = all[i].node;
        const What what = what_of(all[i]);
        const double side = skeleton()[node].x > 0 ? 1 : -1;
        if (node == head && what == What::roll) values.push_back(leaning(i, all[i], aside));
        if (node >= whisker_l && node <= ear_r)
            values.push_back(leaning(i, all[i], what == What::pitch ? up : node == crest ? aside : side * up));
    }
    return values;
}

}  // namespace

DragonMechanisms::DragonMechanisms(clq_crowd *crowd, const clq_template *dragon) : crowd_(crowd)
{
    add_gaze(dragon);
    add_bearing(dragon);
    add_face(dragon);
    add_roar(dragon);
}

clq_mechanism DragonMechanisms::add(const clq_mechanism_def &def) const
{
    clq_mechanism made = {};
    check(clq_crowd_add_mechanism(crowd_, &def, &made));
    return made;
}

void DragonMechanisms::add_gaze(const clq_template *dragon)
{
    clq_mechanism_def def = parse_toml(CLQ_MECHANISM_GAZE, dragon);
    const auto dof = [&](const char *name) { return clq_template_find_dof(dragon, name); };
    clq_gaze_def &gaze = def.gaze;
    gaze.eye_yaw[0] = dof("eye_l.yaw"), gaze.eye_pitch[0] = dof("eye_l.pitch");
    gaze.eye_yaw[1] = dof("eye_r.yaw"), gaze.eye_pitch[1] = dof("eye_r.pitch");
    gaze.neck_yaw = dof("head.yaw"), gaze.neck_pitch = dof("head.pitch");
    gaze.spine_yaw = dof("shoulder.yaw"), gaze.spine_pitch = dof("shoulder.pitch");
    gaze.eyes[1] = 2.2f, gaze.eyes[2] = 6.0f;
    gaze.turn_s = 0.9f;
    gaze.wander_s = 3.0f;
    gaze.wander_yaw_rad = 0.6f, gaze.wander_pitch_rad = 0.3f;
    def.level_m[0] = mid_m, def.level_m[1] = far_m;
    gaze_ = add(def);
}

void DragonMechanisms::add_bearing(const clq_template *dragon)
{
    const Values poses[] = {bearing({0.9, 0.1, 0.3, 0.4}), bearing({-0.9, 0.1, -0.3, -0.4}),
                            bearing({0.0, 0.9, 0.6, 0}), bearing({0.3, -0.7, -0.6, 0.2}),
                            bearing({-0.4, 0.4, 0.1, -0.7})};
    std::vector<clq_dof_pose> shapes;
    for (const Values &pose : poses) shapes.push_back(shape_of(pose));
    clq_mechanism_def def = parse_toml(CLQ_MECHANISM_EXPRESSION, dragon);
    def.expression = {static_cast<uint32_t>(shapes.size()), shapes.data(), 4.5f, 2.2f};
    bearing_ = add(def);
}

void DragonMechanisms::add_face(const clq_template *dragon)
{
    const Values looks[] = {look_of(0.9, 0.0), look_of(-0.9, 0.4), look_of(0.3, -0.8)};
    std::vector<clq_dof_pose> shapes;
    for (const Values &look : looks) shapes.push_back(shape_of(look));
    clq_mechanism_def def = parse_toml(CLQ_MECHANISM_EXPRESSION, dragon);
    def.expression = {static_cast<uint32_t>(shapes.size()), shapes.data(), 2.5f, 0.6f};
    def.off_m = mid_m;
    face_ = add(def);
}

void DragonMechanisms::add_roar(const clq_template *dragon)
{
    const uint32_t pitch = clq_template_find_dof(dragon, "jaw.pitch"),
                   thrust = clq_template_find_dof(dragon, "jaw.thrust");
    const clq_dof_value wide[] = {{pitch, -0.52f}, {thrust, 0.05f}}, half[] = {{pitch, -0.26f}, {thrust, 0.08f}};
    const clq_dof_pose shapes[] = {{2, wide}, {2, half}};
    const clq_phrase_key keys[] = {{0.0f, CLQ_NONE}, {0.3f, 1}, {0.6f, 0}, {1.5f, 1}, {1.8f, 0}, {2.6f, CLQ_NONE}};
    clq_mechanism_def def = parse_toml(CLQ_MECHANISM_PHRASE, dragon);
    def.phrase = {2, shapes, 6, keys, 3.0f, 2.0f, 0.22f};
    roar_ = add(def);
}

void DragonMechanisms::attach(clq_actor actor, uint64_t number) const
{
    const clq_mechanism all[] = {bearing_, face_, roar_, gaze_};
    for (uint32_t k = 0; k < 4; ++k) {
        clq_mechanism_attachment use = {};
        use.mechanism = all[k];
        use.priority = static_cast<float>(k);
        use.phase_s = static_cast<float>(random_between(k + 1, number, Purpose::phase, 0, 60));
        check(clq_actor_attach_mechanism(crowd_, actor, &use));
    }
}

}  // namespace scenes::hundred
