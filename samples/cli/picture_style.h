// Colours and spaces that the command's own pictures share.
#pragma once

#include "samples/cli/letters.h"

namespace cli
{

constexpr Ink paper = {244, 242, 238}, ink = {38, 36, 34}, quiet = {120, 116, 110};
constexpr int margin_px = 16;

}  // namespace cli
