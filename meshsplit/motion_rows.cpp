// The rows of one clip at one rate: sampled from its channels, brought to one hemisphere and rounded to 16 bits.
// Constant rows are stored once.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "lib/pose/exact.h"
#include "meshsplit/motion_plan.h"

namespace claque::meshsplit
{

using model::block_numbers;
using model::ChannelTarget;
using model::motion_lanes;
using model::none;

namespace
{

using Block = std::array<int16_t, block_numbers>;

std::array<int16_t, 4> rounded(const glm::quat &q, const glm::quat &near)
{
    const bool far = q.x * near.x + q.y * near.y + q.z * near.z + q.w * near.w < 0;
    const float unit = far ? -model::rotation_unit : model::rotation_unit;
    const auto round = [&](float v) { return static_cast<int16_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * unit)); };
    return {round(q.x), round(q.y), round(q.z), round(q.w)};
}

class ClipRows
{
public:
    ClipRows(const model::Rig &rig, uint32_t clip, uint32_t intervals, const std::vector<uint8_t> &kept,
             model::Motion &out)
        : rig_(rig), clip_(rig.clips[clip]), index_(clip), intervals_(intervals), kept_(kept), out_(out)
    {
    }

    void run()
    {
        sample();
        add_blocks();
        for (uint32_t g = 0; g < out_.groups.size(); ++g) ranges_.push_back(range_of(g));
        add_tracks();
        model::MotionClip clip;
        clip.intervals = intervals_;
        clip.rate_hz = intervals_ ? static_cast<float>(intervals_ / double(clip_.duration_s)) : 0;
        clip.first_exact = static_cast<uint32_t>(out_.exact.size());
        for (uint32_t i = 0; i < clip_.channel_count; ++i)
            if (kept_[i]) keep(clip_.first_channel + i);
        clip.exact_count = static_cast<uint32_t>(out_.exact.size()) - clip.first_exact;
        out_.clips.push_back(clip);
    }

private:
    uint32_t row_count() const { return intervals_ + 1; }

    void sample()
    {
        const size_t nodes = rig_.node_count(), weights = rig_.rest_weights.size();
        locals_.resize(nodes * row_count()), weights_.resize(weights * row_count());
        for (uint32_t r = 0; r < row_count(); ++r) {
            const double time = double(clip_.start_s) + (intervals_ ? double(clip_.duration_s) * r / intervals_ : 0.0);
            const pose::LocalPose row = {locals_.data() + nodes * r, weights_.data() + weights * r};
            pose::sample_exact(rig_, index_, time, nullptr, row);
            for (uint32_t i = 0; i < clip_.channel_count; ++i)
                if (kept_[i]) put_to_rest(rig_.channels[clip_.first_channel + i], row);
        }
    }

    // Kept channels overwrite these values anyway.
    void put_to_rest(const model::Channel &channel, const pose::LocalPose &row) const
    {
        if (channel.target == ChannelTarget::morph_weights) {
            const model::MorphSet &set = rig_.morph_sets[channel.node];
            for (uint32_t i = set.first_weight; i < set.first_weight + set.target_count; ++i)
                row.weights[i] = rig_.rest_weights[i];
            return;
        }
        const math::Trs &rest = rig_.rest[channel.node];
        math::Trs &trs = row.nodes[channel.node];
        if (channel.target == ChannelTarget::translation) trs.translation = rest.translation;
        else if (channel.target == ChannelTarget::scale) trs.scale = rest.scale;
        else trs.rotation = rest.rotation;
    }

    Block block(uint32_t b, uint32_t row, std::array<glm::quat, motion_lanes> &near) const
    {
        Block out{};
        for (uint32_t i = 0; i < motion_lanes; ++i) {
            const uint32_t node = out_.nodes[b * motion_lanes + i];
            const glm::quat q =
                node == none ? glm::quat(1, 0, 0, 0) : locals_[size_t(rig_.node_count()) * row + node].rotation;
            const std::array<int16_t, 4> v = rounded(q, near[i]);
            for (uint32_t k = 0; k < 4; ++k) out[k * motion_lanes + i] = v[k];
            near[i] = glm::quat(float(v[3]), float(v[0]), float(v[1]), float(v[2]));
        }
        return out;
    }

    void add_blocks()
    {
        std::vector<std::vector<Block>> moving;
        const size_t first_place = out_.blocks.size();
        for (uint32_t b = 0; b < out_.block_count(); ++b) {
            std::array<glm::quat, motion_lanes> near, rest;
            for (uint32_t i = 0; i < motion_lanes; ++i) {
                const uint32_t node = out_.nodes[b * motion_lanes + i];
                near[i] = rest[i] = node == none ? glm::quat(1, 0, 0, 0) : rig_.rest[node].rotation;
            }
            const Block at_rest = resting(rest);
            std::vector<Block> rows;
            for (uint32_t r = 0; r < row_count(); ++r) rows.push_back(block(b, r, near));
            model::MotionBlock place;
            for (const Block &row : rows)
                for (uint32_t k = 0; k < block_numbers; ++k)
                    if (row[k] != at_rest[k]) place.moved |= 1u << (k % motion_lanes);
            const bool still = std::all_of(rows.begin(), rows.end(), [&](const Block &row) { return row == rows[0]; });
            if (!still) {
                place.first = static_cast<uint32_t>(moving.size());
                place.stride = 1;
                moving.push_back(std::move(rows));
            } else if (place.moved) {
                place.first = still_row(rows[0]);
            }
            out_.blocks.push_back(place);
        }
        interleave(moving, first_place);
        for (uint32_t i = 0; i < clip_.channel_count; ++i) mark_kept(i, first_place);
    }

    static Block resting(const std::array<glm::quat, motion_lanes> &rest)
    {
        Block out{};
        for (uint32_t i = 0; i < motion_lanes; ++i) {
            const std::array<int16_t, 4> v = rounded(rest[i], rest[i]);
            for (uint32_t k = 0; k < 4; ++k) out[k * motion_lanes + i] = v[k];
        }
        return out;
    }

    // Clips often have equal constant rows.
    uint32_t still_row(const Block &row)
    {
        for (size_t i = 0; i + block_numbers <= out_.rotations.size() && i < 64 * size_t(block_numbers);
             i += block_numbers)
            if (std::equal(row.begin(), row.end(), out_.rotations.begin() + std::ptrdiff_t(i)))
                return static_cast<uint32_t>(i);
        out_.rotations.insert(out_.rotations.end(), row.begin(), row.end());
        return static_cast<uint32_t>(out_.rotations.size() - block_numbers);
    }

    void interleave(const std::vector<std::vector<Block>> &moving, size_t first_place)
    {
        const uint32_t base = static_cast<uint32_t>(out_.rotations.size());
        const uint32_t stride = block_numbers * static_cast<uint32_t>(moving.size());
        for (uint32_t r = 0; r < row_count() && stride; ++r)
            for (const std::vector<Block> &rows : moving)
                out_.rotations.insert(out_.rotations.end(), rows[r].begin(), rows[r].end());
        for (size_t i = first_place; i < out_.blocks.size(); ++i)
            if (out_.blocks[i].stride)
                out_.blocks[i].first = base + block_numbers * out_.blocks[i].first, out_.blocks[i].stride = stride;
    }

    void mark_kept(uint32_t i, size_t first_place)
    {
        const model::Channel &channel = rig_.channels[clip_.first_channel + i];
        if (!kept_[i] || channel.target != ChannelTarget::rotation) return;
        const uint32_t joint = joint_of(channel.node);
        if (joint != none) out_.blocks[first_place + joint / motion_lanes].moved |= 1u << (joint % motion_lanes);
    }

    uint32_t joint_of(uint32_t node) const { return out_.joint_of[node]; }

    // Returns the numbers of a group in a row.
    const float *numbers(uint32_t g, uint32_t row) const
    {
        const model::MotionGroup &group = out_.groups[g];
        if (group.target == ChannelTarget::morph_weights)
            return weights_.data() + rig_.rest_weights.size() * row + group.index;
        const math::Trs &trs = locals_[size_t(rig_.node_count()) * row + out_.nodes[group.index]];
        return group.target == ChannelTarget::scale ? &trs.scale.x : &trs.translation.x;
    }

    model::MotionCurve range_of(uint32_t g) const
    {
        model::MotionCurve curve;
        for (uint32_t k = 0; k < out_.groups[g].count; ++k) {
            float minimum = numbers(g, 0)[k], maximum = minimum;
            for (uint32_t r = 1; r < row_count(); ++r) {
                minimum = std::min(minimum, numbers(g, r)[k]);
                maximum = std::max(maximum, numbers(g, r)[k]);
            }
            curve.min[k] = minimum;
            curve.step[k] = (maximum - minimum) / 65535.0f;
            if (curve.step[k] > 0) curve.stride = 1;
        }
        return curve;
    }

    void add_tracks()
    {
        if (out_.numbers.empty()) out_.numbers.assign(4, 0);  // the value that constant curves read
        const uint32_t base = static_cast<uint32_t>(out_.numbers.size());
        uint32_t stride = 0;
        for (model::MotionCurve &curve : ranges_) {
            if (!curve.stride) continue;
            curve.first = base + stride;
            stride += 4;
        }
        for (model::MotionCurve &curve : ranges_)
            if (curve.stride) curve.stride = stride;
        for (uint32_t r = 0; r < row_count() && stride; ++r)
            for (uint32_t g = 0; g < ranges_.size(); ++g)
                for (uint32_t k = 0; k < 4 && ranges_[g].stride; ++k)
                    out_.numbers.push_back(k < out_.groups[g].count ? number(g, r, k) : uint16_t(0));
        out_.curves.insert(out_.curves.end(), ranges_.begin(), ranges_.end());
    }

    uint16_t number(uint32_t g, uint32_t row, uint32_t k) const
    {
        const model::MotionCurve &curve = ranges_[g];
        if (!(curve.step[k] > 0)) return 0;
        const double steps = (double(numbers(g, row)[k]) - double(curve.min[k])) / double(curve.step[k]);
        return static_cast<uint16_t>(std::lround(std::clamp(steps, 0.0, 65535.0)));
    }

    void keep(uint32_t channel_index)
    {
        const model::Channel &channel = rig_.channels[channel_index];
        const bool morphs = channel.target == ChannelTarget::morph_weights;
        const uint32_t owner = morphs ? rig_.morph_sets[channel.node].first_weight : joint_of(channel.node);
        if (owner == none) return;  // the node never leaves its rest
        if (channel.target == ChannelTarget::rotation) {
            out_.exact.push_back({channel_index, owner});
            return;
        }
        for (uint32_t g = 0; g < out_.groups.size(); ++g)
            if (out_.groups[g].target == channel.target && out_.groups[g].index == owner) {
                out_.exact.push_back({channel_index, g});
                return;
            }
    }

    const model::Rig &rig_;
    const model::Clip &clip_;
    const uint32_t index_, intervals_;
    const std::vector<uint8_t> &kept_;
    model::Motion &out_;
    std::vector<math::Trs> locals_;  // row by row
    std::vector<float> weights_;
    std::vector<model::MotionCurve> ranges_;
};

}  // namespace

uint64_t place_bytes(const model::Motion &out)
{
    return sizeof(model::MotionClip) + sizeof(model::MotionBlock) * out.block_count() +
           sizeof(model::MotionCurve) * out.groups.size();
}

// Each row has the poses it is made of, its blocks before and after they are interleaved, and room that arrays grow by.
uint64_t clip_bytes(const model::Rig &rig, uint32_t intervals, const model::Motion &out)
{
    const uint64_t row = sizeof(math::Trs) * rig.node_count() + sizeof(float) * rig.rest_weights.size() +
                         (3 + 4) * sizeof(Block) * out.block_count() + 4 * 8 * out.groups.size();
    return row * (uint64_t(intervals) + 1) + 2 * place_bytes(out);
}

void append_clip(const model::Rig &rig, uint32_t clip, uint32_t intervals, const std::vector<uint8_t> &kept,
                 model::Motion &out)
{
    ClipRows(rig, clip, intervals, kept, out).run();
}

}  // namespace claque::meshsplit
