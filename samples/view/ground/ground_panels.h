// The panels of the testing ground, each with a file of its own.
#pragma once

#include "samples/view/panels.h"

namespace view
{

// All of them, with their headings.
void ground_panels(Ui &ui, Model &model, const World &world);

// The role of the picked individual, begun if it has none; null: none is picked.
scenes::roles::Role *picked_role(Model &model, const World &world);

void motion_panel(Ui &ui, Model &model, scenes::roles::Role &role, const clq_template *tmpl);
void face_panel(Ui &ui, Model &model, scenes::roles::Role &role);
void check_panel(Ui &ui, Model &model, const World &world, const clq_template *tmpl);
void state_panel(Ui &ui, Model &model);
void flight_panel(Ui &ui, Model &model, scenes::roles::Role &role, const clq_template *tmpl);
// Numbers at the levels in a row.
void level_marks(Ui &ui, const World &world);
// A choice of what the mouse does, which the gaze and the path share.
void mouse_choice(Ui &ui, Model &model, const std::string &list, Tool tool, const char *name);

// Of the usual names of joints those that a template has.
std::vector<std::string> joints_of(const clq_template *tmpl);

}  // namespace view
