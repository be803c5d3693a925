// What of a face a template's degrees of freedom can move, found by their names.
#pragma once

#include <claque/claque.h>

#include <string>
#include <vector>

namespace scenes::roles
{

using DofValues = std::vector<clq_dof_value>;

struct Expression {
    std::string name;
    DofValues values;
};

struct Faces {
    clq_gaze_def gaze;  // without the point between the eyes
    bool looks = false;
    std::vector<uint32_t> eyes;  // nodes of the eyes, or of what turns the head
    std::vector<Expression> expressions;
    DofValues shut;                 // the lids
    DofValues wide, round, narrow;  // the mouth

    bool speaks() const { return !wide.empty(); }
};

Faces faces_of(const clq_template *tmpl);

// A text as the keys of a mouth: vowels open it, lips close it.
std::vector<clq_phrase_key> keys_of(const std::string &text, float &length_s);

}  // namespace scenes::roles
