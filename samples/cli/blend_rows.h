// What the rows of a strip of blends show: a fade by each curve, layers over parts of the body, two gaits in step.
#pragma once

#include <string>
#include <vector>

#include "samples/cli/portraits.h"

namespace cli
{

struct BlendOptions {
    std::vector<std::string> fade = {"stand_wave", "sit_cheer"};  // from, to
    std::string over = "walk", layer = "stand_wave", added = "sit_laugh", node = "chest";
    std::vector<std::string> gaits = {"walk", "jog"};
    double length_s = 0.6;  // of fades
    uint32_t phases = 9;    // pictures in each row; at least 2
};

struct BlendRow {
    std::string label, about;
    Portraits::Command command;
    std::vector<double> times_s;
    bool from_the_side = false;
};

// Throws Failure if no clip or node has a name that the options use; the message lists the names there are.
std::vector<BlendRow> blend_rows(const clq_template *tmpl, const BlendOptions &options);

// The greatest speed of any node relative to the root while a row plays, in model units a second. A jump shows as a
// high speed.
double fastest_node(scenes::Library &library, clq_template *tmpl, const BlendRow &row);

}  // namespace cli
