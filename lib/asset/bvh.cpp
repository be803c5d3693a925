#include "lib/asset/bvh.h"

#include <cmath>
#include <set>

#include "lib/asset/bvh_hierarchy.h"
#include "lib/math/trig.h"

namespace claque::asset
{

using base::fail;
using model::none;

namespace
{

constexpr double degrees = 3.14159265358979323846 / 180;
constexpr uint32_t max_frames = 100u << 20;

struct Quat {
    double w = 1, x = 0, y = 0, z = 0;
};

// Rotates by an angle about axis 0, 1 or 2: x, y or z.
Quat times_turn(const Quat &q, int axis, double angle_deg)
{
    // Whole turns change nothing, and sines of large angles lose precision.
    const double half = std::fmod(angle_deg, 720.0) * degrees / 2, c = math::cos(half), s = math::sin(half);
    if (axis == 0) return {q.w * c - q.x * s, q.x * c + q.w * s, q.y * c + q.z * s, q.z * c - q.y * s};
    if (axis == 1) return {q.w * c - q.y * s, q.x * c - q.z * s, q.y * c + q.w * s, q.z * c + q.x * s};
    return {q.w * c - q.z * s, q.x * c + q.y * s, q.y * c - q.x * s, q.z * c + q.w * s};
}

// Reads the second half of the file: frames with one number for each channel.
class MotionReader
{
public:
    MotionReader(BvhText &text, Budget &budget, const std::vector<BvhJoint> &joints, double unit_m, model::Model &model)
        : text_(text), budget_(budget), joints_(joints), unit_m_(unit_m), model_(model), rig_(model.rig)
    {
    }

    void read()
    {
        text_.expect_label("Frames", "");
        const uint32_t frames = text_.count("a number of frames", max_frames);
        text_.expect_label("Frame", "Time");
        const double frame_s = text_.number("the time of a frame");
        if (frames == 0) {
            model_.warnings.emplace_back("the file has no frames: there is a skeleton and no clip");
            return;
        }
        if (frames > 1 && !(frame_s >= 1e-4 && frame_s <= 60))
            text_.refuse(base::text_of("a frame takes %g s: 0.0001 to 60 is wanted", frame_s));
        plan(frames);
        for (uint32_t f = 0; f < frames; ++f) {
            if (!rig_.channels.empty() && text_.at_end())
                text_.refuse(base::text_of("the file ends after %u of %u frames", f, frames));
            rig_.times.push_back(static_cast<float>(f * frame_s));
            for (const uint32_t j : moving_) read_joint(j, f);
        }
        if (!text_.at_end())
            model_.warnings.push_back(base::text_of("there is more after the %u frames: left out", frames));
        model::Clip clip;
        clip.channel_count = static_cast<uint32_t>(rig_.channels.size());
        clip.duration_s = rig_.times.back();
        rig_.clips.push_back(clip);
        rig_.clip_names.emplace_back("motion");
    }

private:
    struct Places {
        uint32_t translation = none, rotation = none;  // offsets of the first values in the rig
    };

    void plan(uint32_t frames)
    {
        uint64_t values = 0;
        for (const BvhJoint &joint : joints_) values += (joint.has_position() ? 3 : 0) + (joint.has_rotation() ? 4 : 0);
        budget_.charge(sizeof(float) * frames * (values + 1), "the motion");
        if (values * frames > 0xffffffffull) fail(CLQ_LIMIT, "%u frames are more than a clip holds", frames);
        rig_.times.reserve(frames);
        for (uint32_t j = 0; j < joints_.size(); ++j) {
            Places places;
            if (joints_[j].has_position())
                places.translation = add_channel(j, model::ChannelTarget::translation, 3, frames);
            if (joints_[j].has_rotation()) places.rotation = add_channel(j, model::ChannelTarget::rotation, 4, frames);
            places_.push_back(places);
            if (!joints_[j].channels.empty()) moving_.push_back(j);
        }
    }

    uint32_t add_channel(uint32_t node, model::ChannelTarget path, uint16_t components, uint32_t frames)
    {
        model::Channel channel;
        channel.node = node;
        channel.target = path;
        channel.component_count = components;
        channel.key_count = frames;
        channel.first_value = static_cast<uint32_t>(rig_.values.size());
        rig_.channels.push_back(channel);
        rig_.values.resize(rig_.values.size() + size_t(frames) * components);
        return channel.first_value;
    }

    void read_joint(uint32_t j, uint32_t frame)
    {
        const BvhJoint &joint = joints_[j];
        std::array<double, 3> place = joint.offset;
        Quat q;
        for (const BvhChannel channel : joint.channels) {
            const double value = text_.number("a value of the motion");
            if (std::fabs(value) > 1e15) text_.refuse(base::text_of("a value of the motion is %g", value));
            const int kind = static_cast<int>(channel);
            if (channel <= BvhChannel::z_position) place[static_cast<size_t>(kind)] = value;
            else q = times_turn(q, kind - 3, value);
        }
        if (places_[j].translation != none)
            for (size_t k = 0; k < 3; ++k)
                rig_.values[places_[j].translation + 3 * size_t(frame) + k] = static_cast<float>(place[k] * unit_m_);
        if (places_[j].rotation == none) return;
        const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
        const double values[4] = {q.x, q.y, q.z, q.w};
        for (size_t k = 0; k < 4; ++k)
            rig_.values[places_[j].rotation + 4 * size_t(frame) + k] = static_cast<float>(values[k] / length);
    }

    BvhText &text_;
    Budget &budget_;
    const std::vector<BvhJoint> &joints_;
    double unit_m_;
    model::Model &model_;
    model::Rig &rig_;
    std::vector<Places> places_;
    std::vector<uint32_t> moving_;  // joints with channels: the others take no time in any frame
};

void add_nodes(const std::vector<BvhJoint> &joints, double unit_m, model::Model &model)
{
    std::set<std::string> names;
    for (const BvhJoint &joint : joints) {
        math::Trs rest;
        for (int k = 0; k < 3; ++k)
            rest.translation[k] = static_cast<float>(joint.offset[static_cast<size_t>(k)] * unit_m);
        model.rig.parents.push_back(joint.parent);
        model.rig.rest.push_back(rest);
        model.rig.node_names.emplace_back(joint.name.c_str());
        if (!names.insert(joint.name).second && model.warnings.size() < 64)
            model.warnings.push_back("two joints are named '" + joint.name + "': names find the first");
    }
}

}  // namespace

bool is_bvh(const uint8_t *bytes, size_t size)
{
    BvhText text(bytes, size);
    return text.take("HIERARCHY");
}

model::Model load_bvh(const uint8_t *bytes, size_t size, const LoadOptions &options)
{
    if (!(options.motion_unit_m > 0 && options.motion_unit_m <= 1e6))
        fail(CLQ_ARGUMENT, "a unit of %g m: more than 0 and at most 1e6 is wanted", options.motion_unit_m);
    Budget budget(options.memory_limit_bytes);
    budget.add_input(size);
    if (is_utf16(bytes, size)) budget.charge(uint64_t(size) / 2 * 3, "the text");
    BvhText text(bytes, size);
    model::Model model;
    const std::vector<BvhJoint> joints = read_hierarchy(text, budget);
    add_nodes(joints, options.motion_unit_m, model);
    MotionReader(text, budget, joints, options.motion_unit_m, model).read();
    model.source_bytes = budget.source_bytes();
    try {
        model::check(model);
    } catch (const base::Error &error) {
        fail(CLQ_FORMAT, "%s", error.what());
    }
    return model;
}

}  // namespace claque::asset
