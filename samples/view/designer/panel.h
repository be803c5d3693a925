// The panel Designer (S2 5.2, Fig. 10): what people wear, changed on the whole crowd at once.
#pragma once

#include "samples/view/model.h"
#include "samples/view/ui.h"
#include "samples/view/world.h"

namespace view
{

void designer_panel(Ui &ui, Model &model, const World &world);

}  // namespace view
