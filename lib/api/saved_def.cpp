#include "lib/api/saved_def.h"

#include "lib/base/error.h"

namespace claque::api
{

using base::fail;

MechanismDef::MechanismDef(const crowd::Mechanism &mechanism, std::pmr::memory_resource *memory)
    : def(clq_mechanism_def_init()), values_(memory), poses_(memory), keys_(memory)
{
    // A public description says 0 for "never".
    const auto distance = [](float m) {
        if (m == 0) fail(CLQ_FORMAT, "a level of a mechanism begins at 0 m");
        return m == crowd::never ? 0.0f : m;
    };
    for (uint32_t k = 0; k < crowd::max_behaviour_levels - 1; ++k) def.level_m[k] = distance(mechanism.level_m[k]);
    def.off_m = distance(mechanism.off_m);
    static_assert(
        std::is_same_v<std::variant_alternative_t<CLQ_MECHANISM_GAZE, crowd::MechanismKind>, crowd::Gaze> &&
            std::is_same_v<std::variant_alternative_t<CLQ_MECHANISM_HOST, crowd::MechanismKind>, crowd::HostMechanism>,
        "kinds stand in the order of clq_mechanism_kind");
    def.kind = static_cast<clq_mechanism_kind>(mechanism.kind.index());
    std::visit([this](const auto &kind) { describe(kind); }, mechanism.kind);
}

void MechanismDef::copy_values(const model::Array<crowd::DofValue> &values)
{
    values_.reserve(values.size());
    for (const crowd::DofValue &value : values) values_.push_back({value.dof, value.value});
}

void MechanismDef::copy_poses(const model::Array<crowd::DofPose> &shapes, const model::Array<crowd::DofValue> &values)
{
    copy_values(values);
    poses_.reserve(shapes.size());
    for (const crowd::DofPose &shape : shapes) {
        if (shape.first > values_.size() || shape.count > values_.size() - shape.first)
            fail(CLQ_FORMAT, "a shape has values %u to %u, and there are %zu", shape.first, shape.first + shape.count,
                 values_.size());
        poses_.push_back({shape.count, values_.data() + shape.first});
    }
}

void MechanismDef::describe(const crowd::Gaze &gaze)
{
    for (int k = 0; k < 2; ++k) def.gaze.eye_yaw[k] = gaze.eye_yaw[k], def.gaze.eye_pitch[k] = gaze.eye_pitch[k];
    def.gaze.neck_yaw = gaze.neck_yaw, def.gaze.neck_pitch = gaze.neck_pitch;
    def.gaze.spine_yaw = gaze.spine_yaw, def.gaze.spine_pitch = gaze.spine_pitch;
    def.gaze.neck_share = gaze.neck_share, def.gaze.spine_share = gaze.spine_share;
    for (int k = 0; k < 3; ++k) def.gaze.eyes[k] = gaze.eyes[k];
    def.gaze.turn_s = gaze.turn_s, def.gaze.wander_s = gaze.wander_s;
    def.gaze.wander_yaw_rad = gaze.wander_yaw, def.gaze.wander_pitch_rad = gaze.wander_pitch;
}

void MechanismDef::describe(const crowd::Expression &expression)
{
    copy_poses(expression.poses, expression.values);
    def.expression.pose_count = static_cast<uint32_t>(poses_.size());
    def.expression.poses = poses_.data();
    def.expression.hold_s = expression.hold_s, def.expression.blend_s = expression.blend_s;
}

void MechanismDef::describe(const crowd::Blink &blink)
{
    copy_values(blink.closed);
    def.blink.closed = {static_cast<uint32_t>(values_.size()), values_.data()};
    def.blink.period_s = blink.period_s, def.blink.close_s = blink.close_s;
}

void MechanismDef::describe(const crowd::Phrase &phrase)
{
    copy_poses(phrase.poses, phrase.values);
    keys_.reserve(phrase.keys.size());
    for (const crowd::PhraseKey &key : phrase.keys) keys_.push_back({key.time_s, key.pose});
    def.phrase.pose_count = static_cast<uint32_t>(poses_.size());
    def.phrase.poses = poses_.data();
    def.phrase.key_count = static_cast<uint32_t>(keys_.size());
    def.phrase.keys = keys_.data();
    def.phrase.length_s = phrase.length_s, def.phrase.pause_s = phrase.pause_s, def.phrase.blend_s = phrase.blend_s;
}

void MechanismDef::describe(const crowd::Idle &idle)
{
    def.idle.clip_count = static_cast<uint32_t>(idle.clips.size());
    def.idle.clips = idle.clips.data();
    def.idle.slot_s = idle.slot_s;
    if (!idle.weights.empty()) {
        if (idle.weights.size() != idle.clips.size())
            fail(CLQ_FORMAT, "%zu random clips have %zu weights", idle.clips.size(), idle.weights.size());
        def.idle.weights = idle.weights.data();
    }
    def.idle.fade_s = idle.fade_s;
    def.idle.speed_spread = idle.speed_spread, def.idle.phase_spread = idle.phase_spread;
}

void MechanismDef::describe(const crowd::HostMechanism &host)
{
    def.host.run = host.run;
    def.host.user = host.user;
    def.host.has_memory = host.memory;
}

RootPathDef::RootPathDef(const crowd::RootPath &path, std::pmr::memory_resource *memory)
    : def(clq_root_path_def_init()), positions_(memory), rotations_(memory)
{
    const size_t turned = path.flight ? 0 : path.positions.size();
    if (path.times_s.size() != turned || path.rotations.size() != turned)
        fail(CLQ_FORMAT, "a path of %zu positions has %zu times and %zu rotations", path.positions.size(),
             path.times_s.size(), path.rotations.size());
    positions_.reserve(3 * path.positions.size());
    rotations_.reserve(4 * turned);
    for (const glm::vec3 &p : path.positions)
        for (int k = 0; k < 3; ++k) positions_.push_back(p[k]);
    for (const glm::quat &q : path.rotations)
        for (const float x : {q.x, q.y, q.z, q.w}) rotations_.push_back(x);
    def.count = static_cast<uint32_t>(path.positions.size());
    def.positions = positions_.data();
    if (!path.flight) def.rotations_xyzw = rotations_.data(), def.times_s = path.times_s.data();
    def.duration_s = path.duration_s;
    def.bank = path.bank, def.max_bank_rad = path.max_bank;
}

}  // namespace claque::api
