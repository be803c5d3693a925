#include "lib/retarget/source_pose.h"

#include "lib/pose/channel.h"

namespace claque::retarget
{

using model::none;

SourcePose::SourcePose(const model::Rig &rig, uint32_t clip)
    : rig_(rig), clip_(rig.clips[clip]), rotations_(rig.node_count()), globals_(rig.node_count())
{
}

void SourcePose::at(double time_s)
{
    locals_.assign(rig_.rest.begin(), rig_.rest.end());
    for (uint32_t c = 0; c < clip_.channel_count; ++c) {
        const model::Channel &channel = rig_.channels[clip_.first_channel + c];
        if (channel.target == model::ChannelTarget::morph_weights) continue;
        math::Trs &local = locals_[channel.node];
        const pose::KeyInterval place =
            pose::find_key(rig_.times.data() + channel.first_time, channel.key_count, time_s);
        if (channel.target == model::ChannelTarget::rotation)
            local.rotation = pose::sample_rotation(rig_, channel, place);
        else
            pose::sample_numbers(rig_, channel, place,
                                 channel.target == model::ChannelTarget::scale ? &local.scale.x : &local.translation.x);
    }
    for (uint32_t i = 0; i < rig_.node_count(); ++i) {
        const uint32_t parent = rig_.parents[i];
        const glm::dquat turn = glm::normalize(dquat_of(locals_[i].rotation));
        const math::Affine local = math::affine_of(locals_[i]);
        rotations_[i] = parent == none ? turn : rotations_[parent] * turn;
        globals_[i] = parent == none ? local : math::mul(globals_[parent], local);
    }
}

}  // namespace claque::retarget
