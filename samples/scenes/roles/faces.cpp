#include "samples/scenes/roles/faces.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "samples/scenes/check.h"

namespace scenes::roles
{
namespace
{

struct Dof {
    uint32_t index;
    std::string name;  // in small letters
    clq_dof_info info;
};

bool holds(const std::string &name, std::initializer_list<const char *> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](const char *word) { return name.find(word) != std::string::npos; });
}

std::vector<Dof> dofs_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    std::vector<Dof> dofs;
    for (uint32_t i = 0; i < info.dof_count; ++i) {
        Dof dof = {i, {}, clq_dof_info_init()};
        check(clq_template_get_dof(tmpl, i, &dof.info));
        for (const char *c = dof.info.name; *c; ++c)
            dof.name += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
        dofs.push_back(dof);
    }
    return dofs;
}

// The end of its range that is farther from rest, `share` of the way.
clq_dof_value moved(const Dof &dof, float share)
{
    const float up = dof.info.max - dof.info.rest, down = dof.info.min - dof.info.rest;
    return {dof.index, dof.info.rest + share * (up >= -down ? up : down)};
}

// `share` of the way to its largest value, or, below 0, to its smallest.
clq_dof_value leaning(const Dof &dof, float share)
{
    const float end = share < 0 ? dof.info.min : dof.info.max;
    return {dof.index, dof.info.rest + (end - dof.info.rest) * (share < 0 ? -share : share)};
}

uint32_t turning(const std::vector<Dof> &dofs, const char *part, const char *axis)
{
    for (const Dof &dof : dofs)
        if (dof.info.kind == CLQ_DOF_ROTATION && holds(dof.name, {part}) && holds(dof.name, {axis})) return dof.index;
    return CLQ_NONE;
}

uint32_t turning(const std::vector<Dof> &dofs, std::initializer_list<const char *> parts, const char *axis)
{
    for (const char *part : parts) {
        const uint32_t found = turning(dofs, part, axis);
        if (found != CLQ_NONE) return found;
    }
    return CLQ_NONE;
}

void find_gaze(const std::vector<Dof> &dofs, Faces &out)
{
    clq_gaze_def &gaze = out.gaze;
    int eyes[2] = {0, 0};
    for (const Dof &dof : dofs) {
        if (dof.info.kind != CLQ_DOF_ROTATION || !holds(dof.name, {"eye"}) || holds(dof.name, {"brow", "lid"}))
            continue;
        const bool yaw = holds(dof.name, {"yaw"});
        if (!yaw && !holds(dof.name, {"pitch"})) continue;
        int &count = eyes[yaw ? 0 : 1];
        if (count < 2) (yaw ? gaze.eye_yaw : gaze.eye_pitch)[count++] = dof.index;
        out.eyes.push_back(dof.info.node);
    }
    gaze.neck_yaw = turning(dofs, {"neck", "head"}, "yaw");
    gaze.neck_pitch = turning(dofs, {"neck", "head"}, "pitch");
    gaze.spine_yaw = turning(dofs, {"spine", "chest", "shoulder", "torso"}, "yaw");
    gaze.spine_pitch = turning(dofs, {"spine", "chest", "shoulder", "torso"}, "pitch");
    for (const uint32_t dof : {gaze.neck_yaw, gaze.neck_pitch, gaze.spine_yaw, gaze.spine_pitch})
        if (out.eyes.empty() && dof != CLQ_NONE) out.eyes.push_back(dofs[dof].info.node);
    out.looks = !out.eyes.empty();
    gaze.wander_s = 3;
}

void find_expressions(const std::vector<Dof> &dofs, Faces &out)
{
    DofValues up, down, aslant;
    for (const Dof &dof : dofs) {
        const bool mouth = holds(dof.name, {"jaw", "mouth", "lid", "blink"});
        if (dof.info.kind == CLQ_DOF_MORPH && !mouth) out.expressions.push_back({dof.info.name, {leaning(dof, 1)}});
        if (holds(dof.name, {"brow", "ear_", "ear.", "ears", "crest", "whisker"})) {
            up.push_back(leaning(dof, 0.9f)), down.push_back(leaning(dof, -0.9f));
            aslant.push_back(leaning(dof, 0.6f));
        }
        if (holds(dof.name, {"head_roll", "head.roll"})) aslant.push_back(leaning(dof, 0.6f));
    }
    if (!up.empty()) out.expressions.push_back({"raised", up});
    if (!down.empty()) out.expressions.push_back({"lowered", down});
    if (!aslant.empty()) out.expressions.push_back({"aslant", aslant});
}

}  // namespace

Faces faces_of(const clq_template *tmpl)
{
    Faces out;
    out.gaze = clq_mechanism_def_init().gaze;
    const std::vector<Dof> dofs = dofs_of(tmpl);
    find_gaze(dofs, out);
    find_expressions(dofs, out);
    for (const Dof &dof : dofs) {
        if (holds(dof.name, {"lid", "blink"})) out.shut.push_back(moved(dof, 1));
        if (!holds(dof.name, {"jaw", "mouth"})) continue;
        out.wide.push_back(moved(dof, 0.9f));
        out.round.push_back(moved(dof, 0.55f));
        out.narrow.push_back(moved(dof, 0.25f));
    }
    return out;
}

std::vector<clq_phrase_key> keys_of(const std::string &text, float &length_s)
{
    constexpr float letter_s = 0.09f;
    const std::string wide = "aA", round = "oOuUwWqQ", shut = "bBmMpPfFvV .,;:!?-";
    std::vector<clq_phrase_key> keys;
    length_s = 0;
    for (const char c : text) {
        const uint32_t pose = wide.find(c) != std::string::npos    ? 0u
                              : round.find(c) != std::string::npos ? 1u
                              : shut.find(c) != std::string::npos  ? CLQ_NONE
                                                                   : 2u;
        if (keys.empty() || keys.back().pose != pose) keys.push_back({length_s, pose});
        length_s += letter_s;
    }
    return keys;
}

}  // namespace scenes::roles
