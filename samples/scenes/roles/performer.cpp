#include "samples/scenes/roles/performer.h"

#include <cmath>
#include <limits>

#include "lib/base/near_names.h"
#include "samples/scenes/template_names.h"

namespace scenes::roles
{
namespace
{

constexpr float expression_first = 1, phrase_next = 2, blink_next = 3, gaze_next = 4, own_next = 10, hand_last = 1e6f;

}  // namespace

Home home_of(const clq_transform &place)
{
    const double x = static_cast<double>(place.orientation_xyzw[0]), y = static_cast<double>(place.orientation_xyzw[1]);
    const double z = static_cast<double>(place.orientation_xyzw[2]), w = static_cast<double>(place.orientation_xyzw[3]);
    Home home;
    home.position = {place.position[0], place.position[1], place.position[2]};
    home.heading_rad = std::atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
    home.scale = place.scale;
    return home;
}

clq_transform place_of(const clq_actor_info &info)
{
    double away = 0;
    for (int k = 0; k < 3; ++k) away = std::fmax(away, std::fabs(info.root.position[k] - info.transform.position[k]));
    clq_transform place = info.visible && away > 1e-6 ? info.root : info.transform;
    place.scale = info.transform.scale;
    return place;
}

Role present_role(clq_crowd *crowd, clq_actor actor)
{
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(crowd, actor, &info));
    Role role;
    Clip &base = role.motion.base;
    clq_clip_info clip = clq_clip_info_init();
    if (info.play.clip != CLQ_NONE && clq_template_get_clip(info.tmpl, info.play.clip, &clip) == CLQ_OK)
        base.name = clip.name;
    base.start_s = info.play.start_s, base.speed = info.play.speed, base.phase_s = info.play.phase_s;
    return role;
}

Performer::Performer(clq_crowd *crowd, clq_actor actor, Kit &kit, const Role &present)
    : crowd_(crowd), actor_(actor), kit_(kit), given_(present)
{
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(crowd, actor, &info));
    place_ = roles::place_of(info);
    home_ = home_of(place_);
    clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX];
    uint32_t count = 0;
    check(clq_actor_get_active_clips(crowd, actor, 0, clips, &count));
    for (uint32_t i = 0; i < count; ++i)
        follows_own_ = follows_own_ || (info.play.clip == CLQ_NONE && clips[i].clip != CLQ_NONE);
}

void Performer::perform(const Role &role, double time_s)
{
    const bool next_lap = treadmill_ && treadmill_->lap_at(time_s) != lap_;
    if (!(role.motion == given_.motion) || next_lap) {
        move(role.motion, time_s);
        given_.motion = role.motion;
    }
    if (!(role.flight == given_.flight)) {
        fly(role.flight);
        given_.flight = role.flight;
    }
    if (!(role.face == given_.face)) {
        face(role.face);
        given_.face = role.face;
    } else if (role.face.looks && role.face.target) look(role.face);  // the individual may have moved
    if (!(role.load == given_.load)) {
        carry(role.load);
        given_.load = role.load;
    }
    if (role.mechanism != given_.mechanism) {
        use_own(role.mechanism);
        given_.mechanism = role.mechanism;
    }
    if (role.dofs != given_.dofs) {
        hold(role.dofs);
        given_.dofs = role.dofs;
    }
}

void Performer::attach(clq_mechanism mechanism, float priority) const
{
    clq_mechanism_attachment use = clq_mechanism_attachment_init();
    use.mechanism = mechanism, use.priority = priority;
    check(clq_actor_attach_mechanism(crowd_, actor_, &use));
}

void Performer::detach(clq_mechanism mechanism) const { check(clq_actor_detach_mechanism(crowd_, actor_, mechanism)); }

void Performer::face(const Face &face)
{
    const Face &was = given_.face;
    if (face.expresses) attach(kit_.expression(), expression_first);
    else if (was.expresses) detach(kit_.expression());
    if (face.expresses)
        check(clq_actor_express(crowd_, actor_, kit_.expression(), kit_.expression_named(face.expression),
                                face.expression_at_s));
    if (face.blinks) attach(kit_.blink(), blink_next);
    else if (was.blinks) detach(kit_.blink());
    if (!was.phrase.empty() && was.phrase != face.phrase) detach(kit_.phrase(was.phrase));
    if (!face.phrase.empty() && (face.phrase != was.phrase || face.phrase_at_s != was.phrase_at_s)) {
        attach(kit_.phrase(face.phrase), phrase_next);
        check(clq_actor_say(crowd_, actor_, kit_.phrase(face.phrase), face.phrase_at_s));
    }
    if (face.looks) {
        attach(kit_.gaze(), gaze_next);
        look(face);
    } else if (was.looks) detach(kit_.gaze());
}

void Performer::look(const Face &face)
{
    check(clq_actor_gaze(crowd_, actor_, kit_.gaze(), face.target ? face.target->data() : nullptr, face.target_at_s));
}

void Performer::use_own(const MechanismFile &file)
{
    if (!file.empty()) attach(kit_.own(file), own_next);
    if (!given_.mechanism.empty()) detach(kit_.own(given_.mechanism));
}

void Performer::hold(const std::map<std::string, float> &dofs)
{
    if (dofs.empty()) {
        detach(kit_.hand());
        kit_.by_hand.erase(actor_.index1);
        return;
    }
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(kit_.tmpl(), &info));
    std::vector<float> values(info.dof_count, std::numeric_limits<float>::quiet_NaN());
    for (const auto &[name, value] : dofs) {
        const uint32_t dof = clq_template_find_dof(kit_.tmpl(), name.c_str());
        if (dof == CLQ_NONE)
            throw Failure(std::string(info.name) + " has no degree of freedom '" + name + "'" +
                          claque::base::names_near(name, names_of_dofs(kit_.tmpl())));
        values[dof] = value;
    }
    attach(kit_.hand(), hand_last);
    kit_.by_hand[actor_.index1] = values;
}

void Performer::draw_ground(const Gl &g, const Eye &eye, double time_s) const
{
    if (treadmill_) draw_belt(g, eye, home_.position, home_.heading_rad, treadmill_->ground_m(time_s));
}

void Performer::draw_load(const Gl &g, const Eye &eye) const
{
    for (const Carried &one : given_.load) {
        double node[16];
        check(clq_actor_get_node(crowd_, actor_, kit_.node(one.joint), std::numeric_limits<double>::quiet_NaN(), node));
        draw_object(g, eye, one.object, node);
    }
}

}  // namespace scenes::roles
