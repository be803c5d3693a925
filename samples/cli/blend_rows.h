// What the rows of a strip of blends show: a fade by each curve, layers over parts of the body, two gaits in step.
#pragma once

#include "samples/cli/portraits.h"

#include <string>
#include <vector>

namespace cli
{

struct BlendOptions {
    std::vector<std::string> fade = {"stand_wave", "sit_cheer"};  // from, to
    std::string over = "walk", layer = "stand_wave", added = "sit_laugh", node = "chest";
    std::vector<std::string> gaits = {"walk", "jog"};
    double length_s = 0.6;  // of fades
    uint32_t phases = 9;    // of each row; at least 2
};

struct BlendRow {
    std::string label, about;
    Portraits::Command command;
    std::vector<double> times_s;
    bool from_the_side = false;
};

// Throws Failure where there is no clip or node of a name, and says which there are.
std::vector<BlendRow> blend_rows(const clq_template *tmpl, const BlendOptions &options);

// The greatest speed of any node in model units a second, against the root, while a row goes by: what pops is fast.
double fastest_node(scenes::Library &library, clq_template *tmpl, const BlendRow &row);

}  // namespace cli
