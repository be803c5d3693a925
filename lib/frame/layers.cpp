// What each request's pose is made of: one clip, or layers in memory that lives as long as the lists of this update.
#include "lib/behave/active_clips.h"

#include <algorithm>

#include "lib/frame/steps.h"
#include "lib/pose/clock.h"

namespace claque::frame
{

void Update::reserve_layers()
{
    const crowd::Layers &layers = crowd.layers();
    const size_t most = size_t(layers.slot_count()) * pose::max_layers +
                        (crowd.behaviours().any_blend() ? 2 * size_t(crowd.row_count()) : 0);
    std::pmr::vector<pose::Layer> grown(frame.layers_.get_allocator());
    if (frame.layers_.capacity() < most) grown.reserve(most + most / 2);
    // Masks stay while lists may show them, whatever becomes of the crowd.
    std::pmr::vector<crowd::Mask> masks(frame.masks_.get_allocator());
    bool same = frame.masks_.size() == layers.mask_count();
    for (uint32_t i = 0; same && i < layers.mask_count(); ++i) same = frame.masks_[i] == layers.mask(i).weights;
    if (!same) masks.reserve(layers.mask_count());
    for (uint32_t i = 0; !same && i < layers.mask_count(); ++i) masks.push_back(layers.mask(i).weights);

    if (grown.capacity() > 0) frame.layers_.swap(grown);
    if (!same) frame.masks_.swap(masks);
}

void Update::choose_clips(animcache::Request &request, uint64_t levels)
{
    const uint32_t row = request.row;
    if (!crowd.behaviours().has_mechanisms(row) && !crowd.layers().of(row)) {
        const crowd::Play &play = crowd.play_of(row);
        request.pose.clip = play.clip;
        if (play.clip != model::none)
            request.pose.clip_time_s = pose::clip_time({play.start_s, play.speed, play.phase_s},
                                                       request.tmpl->rig.clips[play.clip], request.shown_s);
        return;
    }
    behave::ActiveClips active_clips;
    behave::active_clips_at(crowd, row, request.shown_s, levels, active_clips);
    request.pose.clip = active_clips.clip;
    request.pose.clip_time_s = active_clips.clip_time_s;
    if (active_clips.count == 0) return;
    // What the layers are is a function of the tick.
    request.pose.tick_s = request.shown_s;
    request.pose.layers = active_clips.count;
    const crowd::LayerState *layer_state = crowd.layers().of(row);
    request.blend_radius = crowd::blended_reach_of(*request.tmpl, layer_state ? layer_state->max_additive_weight() : 0);
    const size_t first = frame.layers_.size();
    frame.layers_.insert(frame.layers_.end(), active_clips.layers, active_clips.layers + active_clips.count);
    request.layers = {frame.layers_.data() + first, active_clips.count};
}

}  // namespace claque::frame
