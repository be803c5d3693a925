#include "samples/view/ground/workbench.h"

#include <algorithm>
#include <cmath>

namespace view
{

using namespace scenes::roles;

namespace
{

constexpr double min_step_m = 0.5;  // between corners of a path that is drawn with one stroke

}  // namespace

Workbench::Workbench(scenes::Library &library, clq_crowd *crowd, const std::vector<clq_template *> &templates)
    : library_(library), crowd_(crowd), templates_(templates)
{
}

void add_fade(Motion &motion, const Fade &fade)
{
    motion.fades.push_back(fade);
    if (motion.fades.size() <= most_fades) return;
    motion.base = motion.fades.front().to;
    motion.fades.erase(motion.fades.begin());
}

Kit *Workbench::kit_of(const clq_template *tmpl)
{
    auto &kit = kits_[tmpl];
    if (kit) return kit.get();
    for (clq_template *one : templates_)
        if (one == tmpl) kit = std::make_unique<Kit>(library_, crowd_, one);
    return kit.get();
}

Performer *Workbench::performer_of(clq_actor actor)
{
    One &one = performers_[actor.index1];
    if (one.performer && one.actor.generation == actor.generation) return one.performer.get();
    one.performer.reset();
    one.actor = actor;
    clq_actor_info info = clq_actor_info_init();
    if (clq_actor_get_info(crowd_, actor, &info) != CLQ_OK) return nullptr;
    Kit *kit = kit_of(info.tmpl);
    if (kit) one.performer = std::make_unique<Performer>(crowd_, actor, *kit, present_role(crowd_, actor));
    return one.performer.get();
}

Role &Workbench::role_of(Model &model, clq_actor actor) const
{
    const auto found = model.ground.roles.find(actor.index1);
    if (found != model.ground.roles.end()) return found->second;
    return model.ground.roles[actor.index1] = present_role(crowd_, actor);
}

void Workbench::act(Model &model)
{
    const clq_actor picked = model.picked.actor;
    if (picked.index1 != 0) performer_of(picked);
    for (auto &[index1, role] : model.ground.roles) {
        const auto known = performers_.find(index1);
        Performer *performer = known == performers_.end() ? nullptr : performer_of(known->second.actor);
        if (!performer) continue;
        try {
            performer->perform(role, model.clock.time_s);
        } catch (const scenes::Failure &failure) {
            model.message = failure.what();
            role = performer->given();
        }
    }
    tell(model);
}

// What the panels say of the picked individual.
void Workbench::tell(Model &model)
{
    Ground &ground = model.ground;
    ground.can = {};
    ground.treadmill.reset();
    ground.mechanism_name.clear();
    clq_actor_info info = clq_actor_info_init();
    const clq_actor picked = model.picked.actor;
    if (picked.index1 == 0 || clq_actor_get_info(crowd_, picked, &info) != CLQ_OK) return;
    Kit *kit = kit_of(info.tmpl);
    if (!kit) return;
    const Faces &faces = kit->faces();
    ground.can.looks = faces.looks, ground.can.blinks = !faces.shut.empty(), ground.can.speaks = faces.speaks();
    for (const Expression &one : faces.expressions) ground.can.expressions.push_back(one.name);
    clq_template_info tmpl = clq_template_info_init();
    scenes::check(clq_template_get_info(info.tmpl, &tmpl));
    for (uint32_t i = 0; i < tmpl.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_template_get_clip(info.tmpl, i, &clip));
        ground.can.clips.emplace_back(clip.name);
    }
    const auto found = performers_.find(picked.index1);
    if (found == performers_.end() || !found->second.performer) return;
    Performer &performer = *found->second.performer;
    if (!performer.given().mechanism.empty()) ground.mechanism_name = kit->own_name(performer.given().mechanism);
    Treadmill *treadmill = performer.treadmill();
    if (!treadmill) return;
    const FootDrift &drift = treadmill->drift();
    ground.treadmill = OnTreadmill{treadmill->state(model.clock.time_s), drift.mean_mm, drift.most_mm, drift.steps};
}

void Workbench::touch(Model &model, const clq_camera &camera)
{
    Ground &ground = model.ground;
    if (!ground.touch) return;
    const std::array<float, 2> at = *ground.touch;
    ground.touch.reset();
    clq_ray ray = {};
    const clq_actor picked = model.picked.actor;
    if (picked.index1 == 0 || clq_camera_get_ray(&camera, at[0], at[1], &ray) != CLQ_OK) return;
    Role &role = role_of(model, picked);
    if (ground.tool == Tool::gaze && role.face.looks) {
        // In the plane of the picture, as far away as the target is now; first, as the individual is.
        clq_actor_info info = clq_actor_info_init();
        scenes::check(clq_actor_get_info(crowd_, picked, &info));
        double from[3], square = 0, along = 0;
        for (int k = 0; k < 3; ++k) {
            from[k] = role.face.target ? (*role.face.target)[static_cast<size_t>(k)] : info.root.position[k];
            along += (from[k] - ray.origin[k]) * ray.direction[k];
            square += ray.direction[k] * ray.direction[k];
        }
        const double away = std::max(0.2, (role.face.target ? 1.0 : 0.6) * along / square);
        std::array<double, 3> point;
        for (size_t k = 0; k < 3; ++k) point[k] = ray.origin[k] + away * ray.direction[k];
        role.face.target = point;
        role.face.target_at_s = model.clock.time_s;
    }
    if (ground.tool == Tool::path) {
        const double height = static_cast<double>(ground.height_m);
        const double away = (height - ray.origin[1]) / ray.direction[1];
        std::vector<double> &corners = role.flight.corners;
        if (!(away > 0) || !(away * std::fabs(ray.direction[1]) < 1e6)) {
            model.message = "the path is not that high there: look down on it, or choose another height";
            return;
        }
        const double x = ray.origin[0] + away * ray.direction[0], z = ray.origin[2] + away * ray.direction[2];
        const size_t count = corners.size();
        const bool near = count >= 3 && std::hypot(x - corners[count - 3], z - corners[count - 1]) < min_step_m;
        if (!near) corners.insert(corners.end(), {x, height, z});
    }
}

clq_transform Workbench::place_of(clq_actor actor, const clq_actor_info &info) const
{
    const auto found = performers_.find(actor.index1);
    return found != performers_.end() && found->second.performer ? found->second.performer->place()
                                                                 : scenes::roles::place_of(info);
}

void Workbench::watch(Model &model, const scenes::Scene &scene)
{
    constexpr size_t most = 200;
    Ground &ground = model.ground;
    if (ground.entered_of != model.picked.actor.index1) ground.entered.clear();
    ground.entered_of = model.picked.actor.index1;
    ground.mind = ground.entered_of == 0 ? std::nullopt : scene.mind_of(model.picked.actor);
    if (!ground.mind || ground.mind->state.empty()) return;
    const scenes::Mind &mind = *ground.mind;
    const bool known = !ground.entered.empty() && ground.entered.back().at_s == mind.entered_s &&
                       ground.entered.back().state == mind.state;
    if (!known) ground.entered.push_back({mind.entered_s, mind.state});
    if (ground.entered.size() > most) ground.entered.pop_front();
}

void Workbench::draw_ground(const scenes::Gl &gl, const scenes::Eye &eye, double time_s) const
{
    for (const auto &[index1, one] : performers_)
        if (one.performer) one.performer->draw_ground(gl, eye, time_s);
}

void Workbench::draw_things(const scenes::Gl &gl, const scenes::Eye &eye, const Model &model) const
{
    for (const auto &[index1, one] : performers_)
        if (one.performer) one.performer->draw_load(gl, eye);
    const auto role = model.ground.roles.find(model.picked.actor.index1);
    if (role == model.ground.roles.end()) return;
    if (role->second.face.looks && role->second.face.target) draw_target(gl, eye, *role->second.face.target);
    draw_way(gl, eye, role->second.flight.corners);
}

}  // namespace view
