// The GL functions that Dear ImGui's OpenGL2 backend calls. The backend expects to be linked with libGL; here its calls
// go to the functions of the current context, which may be OSMesa's, EGL's or a window's.
#pragma once

#include <cstdint>
#include <string>

#include "samples/processes/tile_borders.h"
#include "samples/scenes/gl.h"

namespace view
{

// From the current context, for all later calls. Returns false with the name of the missing function if it cannot.
bool load_gl_calls(scenes::GetProcAddress get, void *user, std::string &missing);

// A square picture of RGBA bytes as a texture that is sampled at its nearest texel; 0 makes one. Returns its name.
unsigned put_picture(unsigned texture, int side_px, const uint8_t *rgba);
void drop_picture(unsigned texture);

// Pixels of three bytes, in rows of `row_px` pixels, the lowest first. Reads these columns, `below` lines up, into the
// same columns of the rows.
void read_columns(const processes::Tile &columns, int below, int height, uint8_t *rgb, int row_px);
// Draws rows into the lower left corner of the viewport, over all that is there, and leaves GL's state as it was.
void draw_rows(int width, int height, const uint8_t *rgb, int row_px);

}  // namespace view
