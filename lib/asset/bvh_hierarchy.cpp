#include "lib/asset/bvh_hierarchy.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

namespace
{

constexpr const char *channel_names[] = {"Xposition", "Yposition", "Zposition", "Xrotation", "Yrotation", "Zrotation"};
constexpr uint32_t no_joint = 0xffffffffu;

void read_offset(BvhText &text, BvhJoint &joint)
{
    for (double &value : joint.offset) {
        value = text.number("an offset");
        // Larger offsets could overflow a float when they are summed along a skeleton.
        if (std::fabs(value) > 1e15) text.refuse(base::text_of("an offset of %g is too far away", value));
    }
}

void read_channels(BvhText &text, BvhJoint &joint)
{
    if (!joint.channels.empty()) text.refuse("'" + joint.name + "' has CHANNELS twice");
    const uint32_t count = text.count("a number of channels", 6);
    for (uint32_t i = 0; i < count; ++i) {
        uint8_t kind = 0;
        while (kind < 6 && !text.take(channel_names[kind])) ++kind;
        if (kind == 6)
            text.refuse("channel " + std::to_string(i + 1) + " of '" + joint.name +
                        "' is none of Xposition, Yposition, Zposition, Xrotation, Yrotation, Zrotation");
        const BvhChannel channel = static_cast<BvhChannel>(kind);
        if (std::find(joint.channels.begin(), joint.channels.end(), channel) != joint.channels.end())
            text.refuse("'" + joint.name + "' has " + channel_names[kind] + " twice");
        joint.channels.push_back(channel);
    }
}

class HierarchyReader
{
public:
    HierarchyReader(BvhText &text, Budget &budget) : text_(text), budget_(budget) {}

    std::vector<BvhJoint> read()
    {
        text_.expect("HIERARCHY");
        while (!text_.take("MOTION")) {
            text_.expect("ROOT");
            open(text_.name());
            while (!open_.empty()) read_line();
        }
        if (joints_.empty()) text_.refuse("there is no ROOT before MOTION");
        return std::move(joints_);
    }

private:
    // No recursion, as a file can nest joints without limit.
    void read_line()
    {
        const bool is_end = open_.back().is_end;
        if (text_.take("}")) {
            if (!open_.back().has_offset) text_.refuse("'" + joints_[open_.back().joint].name + "' has no OFFSET");
            open_.pop_back();
        } else if (text_.take("OFFSET")) {
            if (open_.back().has_offset) text_.refuse("'" + joints_[open_.back().joint].name + "' has OFFSET twice");
            open_.back().has_offset = true;
            read_offset(text_, joints_[open_.back().joint]);
        } else if (!is_end && text_.take("CHANNELS")) read_channels(text_, joints_[open_.back().joint]);
        else if (!is_end && text_.take("JOINT")) open(text_.name());
        else if (!is_end && text_.take("End")) {
            text_.expect("Site");
            open(joints_[open_.back().joint].name + " end");
            open_.back().is_end = true;
        } else text_.expect(is_end ? "OFFSET or }" : "OFFSET, CHANNELS, JOINT, End Site or }");
    }

    void open(std::string name)
    {
        if (joints_.size() >= max_bvh_joints) base::fail(CLQ_LIMIT, "there are more than %u joints", max_bvh_joints);
        budget_.charge(sizeof(BvhJoint) + 200 + name.size(), "a joint");
        BvhJoint joint;
        joint.name = std::move(name);
        joint.parent = open_.empty() ? no_joint : open_.back().joint;
        open_.push_back({static_cast<uint32_t>(joints_.size()), false, false});
        joints_.push_back(std::move(joint));
        text_.expect("{");
    }

    struct Open {
        uint32_t joint;
        bool has_offset, is_end;
    };
    BvhText &text_;
    Budget &budget_;
    std::vector<BvhJoint> joints_;
    std::vector<Open> open_;
};

}  // namespace

bool BvhJoint::has_position() const
{
    return std::any_of(channels.begin(), channels.end(), [](BvhChannel c) { return c <= BvhChannel::z_position; });
}

bool BvhJoint::has_rotation() const
{
    return std::any_of(channels.begin(), channels.end(), [](BvhChannel c) { return c > BvhChannel::z_position; });
}

std::vector<BvhJoint> read_hierarchy(BvhText &text, Budget &budget) { return HierarchyReader(text, budget).read(); }

}  // namespace claque::asset
