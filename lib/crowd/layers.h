// What an actor plays beside one clip: cross-fades and inertial ones, two gaits in step, gestures laid over the rest (S2 3.3).
// Only commands are kept, the last few; lib/behave says what they come to at a moment. One row an actor, as in Crowd,
// which owns this and keeps the rows in step.
#pragma once

#include "lib/base/span.h"
#include "lib/crowd/play.h"
#include "lib/model/template.h"

#include <memory>

namespace claque::crowd
{

using model::Array;

// How a fade goes from 0 to 1.
enum class Curve : uint8_t {
    linear = 0,
    smooth = 1,  // starts and ends without a jerk
    inertial =
        2  // base fades only: the new clip at once, and on top of it what is left of the difference, which decays
};

// Two clips of one cycle each that go in step: at one common phase, whatever share of either is shown.
struct Gait {
    explicit Gait(std::pmr::memory_resource *memory) : sync_a(memory), sync_b(memory) {}
    const model::Template *tmpl = nullptr;
    uint32_t clip_a = 0, clip_b = 0;
    // Moments that belong together (a foot touches the ground), as shares of the cycle, ascending in [0, 1); equally many.
    // Empty: equal shares belong together.
    Array<double> sync_a, sync_b;
};

// A joint mask: one weight a node. Shared with what still shows it.
using Mask = std::shared_ptr<const Array<float>>;
struct MaskOf {
    const model::Template *tmpl = nullptr;
    Mask weights;
};

// Throws base::Error (CLQ_ARGUMENT) unless there is one weight in [0, 1] a node.
MaskOf checked_mask(const model::Template &tmpl, Array<float> &&weights);

// What a fade goes from or to: one clip, or two gaits in step.
struct Source {
    Play play;  // of gaits: start, speed and phase of clip a
    uint32_t gait = model::none;
    // Gaits: from change_s on the share of clip b goes from one to the other within change_length_s. Where the common phase
    // was then, in rounds, so that what follows is a function of time.
    float share_from = 0, share = 0, change_length_s = 0;
    double change_s = 0, change_rounds = 0;
};

// `from` was played before at_s; what is played from then on is that of the next fade, or what the actor plays now.
struct Fade {
    Source from;
    double at_s = 0;
    float length_s = 0;
    Curve curve = Curve::smooth;
};

// Laid over what is below. Order is that of their coming.
struct Layer {
    uint32_t layer_id = 0;  // its name
    Play play;
    bool additive = false;  // the difference from the reference; else it replaces
    uint32_t reference_clip = model::none;
    double reference_time_s = 0;
    uint32_t mask = model::none;
    float weight = 1;
    double start_s = 0, end_s = never_s;  // shown in [start_s, end_s), which holds both fades
    float fade_in_s = 0, fade_out_s = 0;
    Curve curve = Curve::smooth;
};

constexpr uint32_t max_fades = 3;         // remembered of one actor
constexpr uint32_t max_layers = 4;        // likewise
constexpr float max_layer_weight = 4;     // of what a gesture adds
constexpr uint32_t max_active_clips = 8;  // clips that one actor's fades and gestures may show together

// Of one actor. What is remembered may all be running at once, so that is what limits count.
struct LayerState {
    Source now;  // its play is Crowd::play_of()
    Fade fades[max_fades];
    Layer layers[max_layers];
    uint32_t fade_count = 0, layer_count = 0;
    uint32_t next_free = model::none;

    bool is_plain() const { return now.gait == model::none && fade_count == 0 && layer_count == 0; }
    uint32_t max_clip_count() const;    // that it can come to
    float max_additive_weight() const;  // sum of the weights of differences that are added, at the most
};

// Differences that inertial fades add: the offset itself, and what its velocity carries on (behave/layers.cpp).
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
    void push_row() { of_.push_back(model::none); }
    void pop_row() { of_.pop_back(); }  // a clear one
    void clear_row(uint32_t row);
    void copy_row(uint32_t from, uint32_t to);  // `to` is clear; may throw and then it is still
    LayerState &make(uint32_t row);             // as it was, or plain; may throw
    void release_if_plain(uint32_t row);        // gives the memory back where it is plain
    const LayerState *of(uint32_t row) const { return of_[row] == model::none ? nullptr : &slots_[of_[row]]; }

    uint32_t next_layer_id()  // of a gesture that comes; never 0
    {
        if (++last_layer_id == 0) ++last_layer_id;
        return last_layer_id;
    }
    uint32_t last_layer_id = 0;

    uint32_t slot_count() const { return static_cast<uint32_t>(slots_.size()); }  // at most so many have one
    uint64_t bytes() const;
    std::pmr::memory_resource *memory() const { return gaits_.get_allocator().resource(); }

private:
    Array<Gait> gaits_;
    Array<MaskOf> masks_;
    Array<LayerState> slots_;
    Array<uint32_t> of_;  // by row, of slots_
    uint32_t first_free_ = model::none;
};

}  // namespace claque::crowd
