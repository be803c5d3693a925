// Second texture sets of the four people (S1 1): the same body and clothes with another face and another weave.
#pragma once

#include "lib/figures/canvas.h"

namespace claque::figures
{

Paint paint_bearded_citizen(const Texel &texel);   // a full short beard, a tunic without stripes
Paint paint_banded_patrician(const Texel &texel);  // bands woven into palla and stola, darker brows
Paint paint_bearded_decurion(const Texel &texel);  // a long beard, a broad stripe along the toga
Paint paint_shaven_plebeian(const Texel &texel);   // no beard, a patched exomis

}  // namespace claque::figures
