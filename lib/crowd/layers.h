// What an actor plays beside one clip: cross-fades and inertial fades, gaits, and layers on top (S2 3.3). Only the last
// few commands are kept; lib/behave evaluates them at a time. One row per actor, as in Crowd, which owns this table and
// keeps its rows in step.
#pragma once

#include <memory>

#include "lib/base/slot_map.h"
#include "lib/base/span.h"
#include "lib/crowd/play.h"
#include "lib/model/template.h"

namespace claque::crowd
{

using model::Array;

// In place of a gait of the crowd: that of the track which the actor follows (follows.h).
constexpr uint32_t track_gait = model::none - 1;

// The curve of a fade from 0 to 1.
enum class Curve : uint8_t {
    linear = 0,
    smooth = 1,   // with zero speed at both ends
    inertial = 2  // base fades only: switches to the new clip and adds the decaying difference of the old one
};

// Two clips of one cycle each that are played at one common phase, whatever share of either is shown.
struct Gait {
    explicit Gait(std::pmr::memory_resource *memory) : sync_a(memory), sync_b(memory) {}
    const model::Template *tmpl = nullptr;
    uint32_t clip_a = 0, clip_b = 0;
    // Corresponding events of the two clips (such as a foot contact), as fractions of the cycle, ascending in [0, 1);
    // equally many. Empty: equal fractions correspond.
    Array<double> sync_a, sync_b;
};

// A joint mask: one weight per node. Shared by the layers that use it.
using Mask = std::shared_ptr<const Array<float>>;
struct MaskOf {
    const model::Template *tmpl = nullptr;
    Mask weights;
};

// Throws base::Error (CLQ_ARGUMENT) unless there is one weight in [0, 1] per node.
MaskOf checked_mask(const model::Template &tmpl, Array<float> &&weights);

// The source or target of a fade: one clip, or a gait.
struct Source {
    Play play;  // of gaits: start, speed and phase of clip a
    uint32_t gait = model::none;
    // Gaits: from change_s on, the share of clip b goes from the first value to the second within change_length_s. The
    // common phase at change_s, in cycles, is stored so that the later phase is a function of time.
    float share_from = 0, share = 0, change_length_s = 0;
    double change_s = 0, change_rounds = 0;
};

// `from` was played until at_s. Its target is the source of the next fade, or what the actor plays now.
struct Fade {
    Source from;
    double at_s = 0;
    float length_s = 0;
    Curve curve = Curve::smooth;
};

// A clip on top of those below. Layers are in the order of their calls.
struct Layer {
    uint32_t layer_id = 0;  // its name
    Play play;
    bool additive = false;  // adds the difference from the reference; else it replaces
    uint32_t reference_clip = model::none;
    double reference_time_s = 0;
    uint32_t mask = model::none;
    float weight = 1;
    double start_s = 0, end_s = never_s;  // shown in [start_s, end_s), which includes both fades
    float fade_in_s = 0, fade_out_s = 0;
    Curve curve = Curve::smooth;
};

constexpr uint32_t max_fades = 3;         // kept for one actor
constexpr uint32_t max_layers = 4;        // kept for one actor
constexpr float max_layer_weight = 4;     // of an additive layer
constexpr uint32_t max_active_clips = 8;  // clips that one actor's fades and layers may show together

// Of one actor. All kept fades and layers may run at once, so limits count them all.
struct LayerState {
    Source now;  // its play is Crowd::play_of()
    Fade fades[max_fades];
    Layer layers[max_layers];
    uint32_t fade_count = 0, layer_count = 0;

    // Also for the gait of a track, which its row of Follows remembers.
    bool is_plain() const { return now.gait >= track_gait && fade_count == 0 && layer_count == 0; }
    uint32_t max_clip_count() const;    // upper bound, at any time
    float max_additive_weight() const;  // sum of the weights of additive layers, upper bound
};

// Additive layers of inertial fades: one for the offset, one for its velocity (lib/behave/active_clips.cpp).
constexpr float inertial_weight = 3.5f;

class Layers
{
public:
    explicit Layers(std::pmr::memory_resource *memory) : gaits_(memory), masks_(memory), slots_(memory), of_(memory) {}

    uint32_t add(Gait &&gait);
    uint32_t add(MaskOf &&mask);
    uint32_t gait_count() const { return static_cast<uint32_t>(gaits_.size()); }
    uint32_t mask_count() const { return static_cast<uint32_t>(masks_.size()); }
    const Gait &gait(uint32_t i) const { return gaits_[i]; }
    const MaskOf &mask(uint32_t i) const { return masks_[i]; }

    // Rows.
    void reserve_row();
    void push_row() noexcept { of_.push_back(model::none); }
    void clear_row(uint32_t row) noexcept;
    void reserve_copy(uint32_t from);                    // before copy_row
    void copy_row(uint32_t from, uint32_t to) noexcept;  // `to` is clear
    LayerState &make(uint32_t row);                      // the present state, or a new plain one; may throw
    void release_if_plain(uint32_t row) noexcept;        // frees the state if it is plain
    const LayerState *of(uint32_t row) const { return of_[row] == model::none ? nullptr : &slots_[of_[row]]; }

    uint32_t next_layer_id()  // of the next new layer; never 0
    {
        if (++last_layer_id == 0) ++last_layer_id;
        return last_layer_id;
    }
    uint32_t last_layer_id = 0;

    uint32_t slot_count() const { return slots_.size(); }  // upper bound of the rows with a state
    uint64_t bytes() const;
    std::pmr::memory_resource *memory() const { return gaits_.get_allocator().resource(); }

private:
    Array<Gait> gaits_;
    Array<MaskOf> masks_;
    base::SlotMap<LayerState> slots_;
    Array<uint32_t> of_;  // by row, of slots_
};

}  // namespace claque::crowd
