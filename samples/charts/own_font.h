// The font beside the program.
#pragma once

namespace charts
{

// Where fonts lie in ../share/claque/fonts of the program, as in a Python wheel, text is drawn with these alone;
// fontconfig then reads no settings of the system. Elsewhere it does nothing.
void prefer_own_font();

}  // namespace charts
