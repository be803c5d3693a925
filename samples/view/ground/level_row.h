// The levels of one character beside each other: the same pose in the triangles of each.
#pragma once

#include "samples/scenes/library.h"

namespace view
{

class LevelRow
{
public:
    // From `place` on, in steps of `step_m` to the character's left. `rgb`: colours by zone; empty: the template's own.
    LevelRow(scenes::Library &library, clq_template *tmpl, const clq_transform &place, double step_m,
             const clq_play &play, uint32_t texture_set, const std::vector<uint8_t> &rgb);

    void update(const clq_camera &camera, double time_s);
    clq_view *view() const { return view_; }
    // Of a level: where it stands.
    const std::vector<clq_transform> &places() const { return places_; }

private:
    clq_template *tmpl_;
    scenes::Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;  // ends with its crowd
    std::vector<clq_actor> actors_;
    std::vector<clq_transform> places_;
};

}  // namespace view
