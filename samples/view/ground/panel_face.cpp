// Face: gaze, expressions, phrases and blinking.
#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

using scenes::roles::Face;

void gaze(Ui &ui, Model &model, Face &face)
{
    if (!model.ground.can.looks) return ui.faint("It has no degrees of freedom to look with.");
    if (ui.toggle("gaze", face.looks) && !face.looks) {
        face.target.reset();
        if (model.ground.tool == Tool::gaze) model.ground.tool = Tool::camera;
    }
    if (!face.looks) return;
    mouse_choice(ui, model, "left drag", Tool::gaze, "moves the target");
    if (!face.target) return ui.faint("It looks about.");
    const std::array<double, 3> &at = *face.target;
    ui.row("target", fixed(at[0], 2) + ", " + fixed(at[1], 2) + ", " + fixed(at[2], 2) + " m");
    if (ui.button("let it look about")) {
        face.target.reset();
        face.target_at_s = model.clock.time_s;
    }
}

void expressions(Ui &ui, Model &model, Face &face)
{
    const std::vector<std::string> &names = model.ground.can.expressions;
    if (names.empty()) return ui.faint("It has no expressions.");
    std::vector<std::string> items = {"none", "by chance", "at rest"};
    items.insert(items.end(), names.begin(), names.end());
    int chosen = !face.expresses ? 0 : face.expression.empty() ? 1 : -1;
    for (size_t i = 2; i < items.size(); ++i)
        if (face.expresses && items[i] == face.expression) chosen = static_cast<int>(i);
    if (!ui.choice("expression", chosen, items)) return;
    face.expresses = chosen > 0;
    face.expression = chosen < 2 ? "" : items[static_cast<size_t>(chosen)];
    face.expression_at_s = model.clock.time_s;
}

}  // namespace

void face_panel(Ui &ui, Model &model, scenes::roles::Role &role)
{
    Face &face = role.face;
    gaze(ui, model, face);
    expressions(ui, model, face);
    if (model.ground.can.blinks) ui.toggle("blinks", face.blinks);
    else ui.faint("It has no lids to shut.");
    if (!model.ground.can.speaks) return ui.faint("It has no mouth to move.");
    ui.text_field("phrase", model.ground.phrase);
    if (ui.button("say") && !model.ground.phrase.empty()) {
        face.phrase = model.ground.phrase;
        face.phrase_at_s = model.clock.time_s;
    }
    if (!face.phrase.empty()) ui.faint("said '" + face.phrase + "' at " + fixed(face.phrase_at_s, 2) + " s");
}

}  // namespace view
