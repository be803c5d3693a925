#include "test_actors.h"

#include <algorithm>
#include <cmath>

#include "lib/crowd/edits.h"

namespace claque::behave::testing_support
{

namespace
{

std::pmr::memory_resource *memory() { return std::pmr::get_default_resource(); }

std::unique_ptr<model::Template> make_template()
{
    auto tmpl = std::make_unique<model::Template>(memory());
    tmpl->name = "someone";
    model::Rig &rig = tmpl->rig;
    const uint32_t parents[] = {model::none, 0, 1, 2, 2, 2, 2};  // root, spine, neck, two eyes, two lids
    for (const uint32_t parent : parents) {
        rig.parents.push_back(parent);
        rig.rest.emplace_back();
        rig.node_names.emplace_back("");
    }
    rig.morph_sets.push_back({2, 0, 3});
    rig.rest_weights.assign(3, 0.0f);
    const auto turn = [&](uint32_t node, float range, glm::vec3 axis) {
        rig.dofs.push_back({node, model::DofKind::rotation, 0, axis, -range, range, 0});
    };
    const glm::vec3 up(0, 1, 0), right(-1, 0, 0);
    turn(1, 0.5f, up), turn(1, 0.3f, right), turn(2, 1.2f, up), turn(2, 0.6f, right);
    for (uint32_t eye = 3; eye <= 4; ++eye) turn(eye, 0.7f, up), turn(eye, 0.5f, right);
    for (uint32_t lid = 5; lid <= 6; ++lid)
        rig.dofs.push_back({lid, model::DofKind::rotation, 0, right, 0, 1.1f, 0.1f});
    for (uint32_t target = 0; target < 3; ++target)
        rig.dofs.push_back({0, model::DofKind::morph, target, glm::vec3(0, 1, 0), 0, 1, 0});
    rig.dof_names.resize(rig.dofs.size());
    for (const float length : {1.0f, 2.0f, 4.0f}) {
        rig.clips.push_back({0, 0, 0, length});
        rig.clip_names.emplace_back("");
    }
    model::check(rig);
    const uint32_t left[] = {7, 3, 2, 1};  // nodes, in ascending order of index
    for (const uint32_t count : left) {
        tmpl->levels.emplace_back(memory());
        if (count == 7) continue;
        tmpl->levels.back().active.assign(7, 0);
        std::fill_n(tmpl->levels.back().active.begin(), count, uint8_t(1));
    }
    return tmpl;
}

void add_written(const crowd::MechanismKind &kind, std::vector<uint32_t> &out)
{
    const auto each = [&](const model::Array<crowd::DofValue> &values) {
        for (const crowd::DofValue &value : values) out.push_back(value.dof);
    };
    if (const auto *g = std::get_if<crowd::Gaze>(&kind))
        for (const uint32_t dof : {g->spine_yaw, g->spine_pitch, g->neck_yaw, g->neck_pitch, g->eye_yaw[0],
                                   g->eye_yaw[1], g->eye_pitch[0], g->eye_pitch[1]})
            if (dof != model::none) out.push_back(dof);
    if (const auto *e = std::get_if<crowd::Expression>(&kind)) each(e->values);
    if (const auto *b = std::get_if<crowd::Blink>(&kind)) each(b->closed);
    if (const auto *p = std::get_if<crowd::Phrase>(&kind)) each(p->values);
}

}  // namespace

TestActors::TestActors(uint32_t actors, uint64_t crowd_seed) : tmpl(make_template()), crowd(memory(), crowd_seed)
{
    for (uint32_t i = 0; i < actors; ++i)
        ids.push_back(crowd::create(crowd, *tmpl, crowd::Transform(), crowd::Play(), 100 + i));
    dofs_.resize(dof_count);
}

uint32_t TestActors::add(crowd::MechanismKind kind, float priority)
{
    crowd::Mechanism mechanism;
    mechanism.kind = std::move(kind);
    return add(std::move(mechanism), priority);
}

uint32_t TestActors::add(crowd::Mechanism mechanism, float priority)
{
    mechanism.tmpl = tmpl.get();
    std::vector<uint32_t> written;
    add_written(mechanism.kind, written);
    const uint32_t index = crowd.behaviours().add(std::move(mechanism),
                                                  base::Span<const uint32_t>(written.data(), uint32_t(written.size())));
    for (uint32_t i = 0; i < ids.size(); ++i) use(i, index, priority);
    return index;
}

void TestActors::use(uint32_t actor, uint32_t mechanism, float priority, float phase_s, double start_s)
{
    crowd::MechanismAttachment use;
    use.mechanism = mechanism, use.priority = priority, use.phase_s = phase_s, use.start_s = start_s;
    crowd::attach_mechanism(crowd, ids[actor], use);
}

const std::vector<float> &TestActors::at(double time_s, uint32_t actor, float distance_m, Skeleton skeleton)
{
    EvaluationContext context;
    context.time_s = time_s;
    context.level = &tmpl->levels[skeleton];
    context.levels = mechanism_levels(crowd, crowd.row_of(ids[actor]), distance_m, *context.level);
    context.distance_m = distance_m;
    run(crowd, crowd.row_of(ids[actor]), context, base::Span<float>(dofs_), counts);
    return dofs_;
}

crowd::Gaze gaze()
{
    crowd::Gaze out;
    out.spine_yaw = spine_yaw, out.spine_pitch = spine_pitch, out.neck_yaw = neck_yaw, out.neck_pitch = neck_pitch;
    out.eye_yaw[0] = left_yaw, out.eye_pitch[0] = left_pitch, out.eye_yaw[1] = right_yaw;
    out.eye_pitch[1] = right_pitch;
    out.eyes = glm::vec3(0, 1.6f, 0.1f);
    return out;
}

crowd::Expression expression()
{
    crowd::Expression out(memory());
    out.values = {{smile, 0.8f}, {left_lid, 0.3f}, {right_lid, 0.3f}, {frown, 1.0f}, {left_lid, 0.0f}};
    out.poses = {{0, 3}, {3, 2}, {5, 0}};
    return out;
}

crowd::Blink blink()
{
    crowd::Blink out(memory());
    out.closed = {{left_lid, 1.1f}, {right_lid, 1.1f}};
    return out;
}

crowd::Phrase phrase(float pause_s)
{
    crowd::Phrase out(memory());
    out.values = {{open_mouth, 1.0f}, {open_mouth, 0.4f}, {smile, 0.2f}};
    out.poses = {{0, 1}, {1, 2}};
    out.keys = {{0.0f, 0}, {0.3f, model::none}, {0.5f, 1}, {0.53f, 0}, {1.0f, 1}};
    out.length_s = 1.2f;
    out.pause_s = pause_s;
    return out;
}

float steepest(TestActors &test_actors, double from_s, double to_s)
{
    std::vector<float> before = test_actors.at(from_s);
    float most = 0;
    for (int i = 1; from_s + i * 0.001 <= to_s; ++i) {
        const std::vector<float> &now = test_actors.at(from_s + i * 0.001);
        for (uint32_t k = 0; k < dof_count; ++k) most = std::max(most, std::fabs(now[k] - before[k]) * 1000);
        before = now;
    }
    return most;
}

}  // namespace claque::behave::testing_support
