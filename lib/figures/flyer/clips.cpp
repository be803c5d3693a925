// The clips of flyers: `fly` lying forward with beating wings, `glide`, and `hover` upright. They are functions of the
// phase with whole periods only, so that they close.
#include "lib/figures/clips/clips.h"

#include "lib/figures/flyer/axes.h"
#include "lib/figures/flyer/flyer.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer
{

namespace
{

// Angles with the ranges and signs of the degrees of freedom of the same names.
struct Attitude {
    float lean = 0, bank = 0, rise_m = 0;  // of the body
    float spine_pitch = 0, neck_pitch = 0;
    float flap = 0, sweep = 0, twist = 0;  // of both wings; twist: leading edge towards the chest
    float arm_left = 0, arm_right = 0, legs = 0;
};

// Wings move down fast and up slowly, so the wave is skewed.
float beat(float phase, int beats) { return wave(phase + 0.02f * wave(phase, beats, 0.25f), beats); }

Attitude fly_at(float phase, const FlightStyle &flight_style)
{
    Attitude a;
    const float stroke = beat(phase, flight_style.beats), rate = wave(phase, flight_style.beats, 0.25f);
    a.lean = flight_style.lean_rad + 0.035f * wave(phase, flight_style.beats, 0.1f);
    a.bank = 0.03f * wave(phase, 1);
    a.rise_m = 0.035f * wave(phase, flight_style.beats, -0.45f);
    a.spine_pitch = 0.35f * flight_style.look_up_rad;
    a.neck_pitch = 0.65f * flight_style.look_up_rad - 0.02f * wave(phase, flight_style.beats, 0.1f);
    a.flap = flight_style.raised_rad + flight_style.beat_rad * stroke;
    a.sweep = 0.06f - 0.10f * stroke;
    a.twist = -0.20f * rate;
    a.arm_left = -0.10f + 0.05f * wave(phase, 1, 0.2f);
    a.arm_right = 0.12f + 0.05f * wave(phase, 1, 0.6f);
    a.legs = flight_style.trail_rad + 0.06f * wave(phase, flight_style.beats, 0.35f);
    return a;
}

Attitude glide_at(float phase, const FlightStyle &flight_style)
{
    Attitude a;
    a.lean = flight_style.lean_rad + 0.10f + 0.02f * wave(phase, 1, 0.4f);
    a.bank = 0.07f * wave(phase, 1);
    a.rise_m = 0.03f * wave(phase, 1, 0.3f);
    a.spine_pitch = 0.35f * (flight_style.look_up_rad + 0.10f);
    a.neck_pitch = 0.65f * (flight_style.look_up_rad + 0.10f);
    a.flap = 0.16f + 0.03f * wave(phase, 2, 0.15f);
    a.sweep = 0.02f + 0.02f * wave(phase, 1, 0.6f);
    a.twist = 0.03f * wave(phase, 3);
    a.arm_left = -0.15f, a.arm_right = 0.2f;
    a.legs = flight_style.trail_rad + 0.04f * wave(phase, 1, 0.7f);
    return a;
}

Attitude hover_at(float phase, const FlightStyle &flight_style)
{
    Attitude a;
    const float stroke = beat(phase, flight_style.hover_beats), rate = wave(phase, flight_style.hover_beats, 0.25f);
    a.lean = 0.14f + 0.03f * wave(phase, 1, 0.5f);
    a.rise_m = 0.025f * wave(phase, flight_style.hover_beats, -0.45f) + 0.03f * wave(phase, 1);
    a.spine_pitch = 0.03f, a.neck_pitch = 0.08f;
    a.flap = 0.30f + 0.85f * flight_style.beat_rad * stroke;
    a.sweep = -0.12f - 0.08f * stroke;
    a.twist = 0.30f - 0.30f * rate;  // rotated so that the stroke presses air down
    a.arm_left = 0.10f + 0.06f * wave(phase, 1, 0.3f);
    a.arm_right = 0.06f * wave(phase, 1, 0.8f);
    a.legs = 0.06f + 0.08f * wave(phase, 1, 0.6f);
    return a;
}

struct Clip {
    const char *name;
    int frames;
    Attitude (*at)(float, const FlightStyle &);
};
const std::array<Clip, 3> clips = {{{"fly", 60, fly_at}, {"glide", 120, glide_at}, {"hover", 60, hover_at}}};

glm::quat turn(glm::vec3 axis, float angle) { return glm::quat(math::cos(angle / 2), axis * math::sin(angle / 2)); }

glm::quat wing(const Attitude &a, float side)
{
    return turn(y, side * a.flap) * turn(z, -side * a.sweep) * turn(x, a.twist);
}

glm::quat rotation_of(const Attitude &a, Node node)
{
    switch (node) {
        case Node::body:
            return turn(x, a.lean) * turn(y, a.bank);
        case Node::spine:
            return turn(x, -a.spine_pitch);
        case Node::neck:
            return turn(x, -a.neck_pitch);
        case Node::wing_left:
            return wing(a, 1);
        case Node::wing_right:
            return wing(a, -1);
        case Node::arm_left:
            return turn(x, -a.arm_left);
        case Node::arm_right:
            return turn(x, -a.arm_right);
        default:
            return turn(x, a.legs);
    }
}

void add_clip(model::Rig &rig, const Joints &joints, const FlightStyle &flight_style, const Clip &maker)
{
    std::vector<Attitude> attitudes;
    for (int k = 0; k < maker.frames; ++k)
        attitudes.push_back(maker.at(static_cast<float>(k) / static_cast<float>(maker.frames), flight_style));
    attitudes.push_back(attitudes.front());  // the last key of a loop equals the first to the bit
    model::Clip clip;
    clip.first_channel = static_cast<uint32_t>(rig.channels.size());
    clip.duration_s = static_cast<float>(maker.frames) / keys_per_second;
    model::Channel channel;
    channel.first_time = static_cast<uint32_t>(rig.times.size());
    channel.key_count = static_cast<uint32_t>(attitudes.size());
    for (int k = 0; k <= maker.frames; ++k) rig.times.push_back(static_cast<float>(k) / keys_per_second);
    const auto add = [&](Node node, model::ChannelTarget path, uint16_t components) {
        channel.node = static_cast<uint32_t>(node);
        channel.target = path;
        channel.component_count = components;
        channel.first_value = static_cast<uint32_t>(rig.values.size());
        rig.channels.push_back(channel);
    };
    add(Node::body, model::ChannelTarget::translation, 3);
    for (const Attitude &a : attitudes) {
        const glm::vec3 p = joints[0].at + glm::vec3(0, a.rise_m, 0);
        rig.values.insert(rig.values.end(), {p.x, p.y, p.z});
    }
    for (const Node node : {Node::body, Node::spine, Node::neck, Node::wing_left, Node::wing_right, Node::arm_left,
                            Node::arm_right, Node::legs}) {
        add(node, model::ChannelTarget::rotation, 4);
        for (const Attitude &a : attitudes) {
            const glm::quat q = rotation_of(a, node);
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
    }
    clip.channel_count = static_cast<uint32_t>(rig.channels.size()) - clip.first_channel;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back(maker.name);
}

}  // namespace

void add_clips(model::Rig &rig, const Joints &joints, const FlightStyle &flight_style)
{
    for (const Clip &maker : clips) add_clip(rig, joints, flight_style, maker);
}

}  // namespace claque::figures::flyer
