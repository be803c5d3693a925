// The widgets of the designer: what a colour range looks like, to be dragged and typed.
#pragma once

#include "samples/view/designer/designer.h"
#include "samples/view/ui.h"

namespace view
{

// The range of hues as an arc of a circle, hue 0 at the top, growing clockwise. A drag round the circle draws the arc
// anew, from where it began to where it is; clockwise or back, across 0 as well. Returns whether it changed.
bool hue_arc(Ui &ui, const char *name, float side, Sweep &sweep, clq_hsb_range &range);
// Saturation to the right and brightness upwards, the range as a box. A drag draws the box anew, from corner to corner.
bool shade_box(Ui &ui, const char *name, float side, clq_hsb_range &range);
// A palette as a bar, each entry as long as its weight; a click chooses one.
bool palette_bar(Ui &ui, const char *name, const std::vector<clq_palette_entry> &palette, size_t &chosen);

// The ends of an arc that was swept, in whole degrees; a turn of 360 and more is the whole circle.
void arc_of(const Sweep &sweep, float &from_deg, float &to_deg);

// Two numbers in a field, as in "0.4 0.8". A pair that is out of `most`, or the wrong way round where `ordered`, is not
// taken. Returns whether it changed.
bool pair_field(Ui &ui, const char *name, float &first, float &second, float most, bool ordered);
bool read_pair(const std::string &text, float most, bool ordered, float &first, float &second);
std::string show(float value);  // the shortest digits that read back as the same number

}  // namespace view
