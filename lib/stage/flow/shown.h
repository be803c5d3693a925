// The drawing flow's side: gives commands to a crowd and remembers what later commands refer to.
#pragma once

#include <claque/stage.h>

#include <vector>

#include "lib/stage/flow/handover.h"

namespace claque::stage
{

class Shown
{
public:
    explicit Shown(clq_context *context) : context_(context) {}
    Shown(const Shown &) = delete;
    Shown &operator=(const Shown &) = delete;
    ~Shown();

    // Throws Error (OUT_OF_MEMORY, BUSY) with the command left in the list.
    void apply(Handover &from, clq_crowd *crowd, double time_s, clq_stage_applied &out);

    static constexpr uint32_t max_gestures = 4;  // as many layers as an actor has
    struct Row {
        clq_layer gestures[max_gestures] = {};  // the newest last
        // Holds of the pieces that the actor may show, the newest last: a crowd that is restored has to know them all.
        clq_track *tracks[CLQ_TRACK_PIECES] = {};
    };
    struct MaskOf {
        const Machine *machine;
        uint32_t cast, mask;
        clq_mask made;
    };
    std::vector<Row> rows;  // by agent
    std::vector<MaskOf> masks;
    double shown_s = -1e300;
    void clear();

private:
    clq_status give(Command &command, clq_crowd *crowd, clq_stage_applied &out);
    clq_status fade(const Command &command, clq_crowd *crowd, clq_stage_applied &out);
    clq_status gesture(const Command &command, clq_crowd *crowd);
    clq_status end_gesture(const Command &command, clq_crowd *crowd);
    clq_status follow(Command &command, clq_crowd *crowd);
    clq_status find_mask(const Command &command, clq_crowd *crowd, clq_mask &out);
    void call(const Command &command, clq_crowd *crowd);
    void make_row(uint32_t agent);

    clq_context *context_;
};

}  // namespace claque::stage
