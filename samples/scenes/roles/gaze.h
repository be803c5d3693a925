// How a template looks at points: what turns, and where its eyes are.
#pragma once

#include "samples/scenes/library.h"
#include "samples/scenes/roles/faces.h"

namespace scenes::roles
{

// With the middle of the eyes in the rest pose. `faces` are those of the template, and it looks.
clq_gaze_def gaze_of(Library &library, clq_template *tmpl, const Faces &faces);

}  // namespace scenes::roles
