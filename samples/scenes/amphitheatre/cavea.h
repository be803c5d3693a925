// The stands: rows of seats, stairs, openings, walkways and the walls behind them.
#pragma once

#include "samples/scenes/amphitheatre/masonry.h"

namespace scenes::amphitheatre
{

void build_cavea(Masonry &masonry, const Plan &plan);

}  // namespace scenes::amphitheatre
