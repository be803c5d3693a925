// The panels of the view. Each is a function of the model and of the world of the last frame, and has a file of its
// own.
#pragma once

#include "samples/view/model.h"
#include "samples/view/ui.h"
#include "samples/view/world.h"

namespace view
{

void time_bar(Ui &ui, Model &model, size_t letters);
// The last words of that bar: about the last thing that was done, or else as much of what the mouse and the keys do as
// has room in a line of so many letters.
std::string status(const Model &model, size_t letters);
void camera_panel(Ui &ui, Model &model, const World &world);
void person_panel(Ui &ui, Model &model, const World &world);
void character_panel(Ui &ui, Model &model, const World &world);
void frame_panel(Ui &ui, Model &model, const World &world);

// The places of the panels in a picture.
struct Layout {
    Box side, bottom;
    int picture_width, picture_height;  // of the rest, in the upper left corner
    size_t letters;                     // in a line of the lower panel
};
Layout layout_of(const Ui &ui, const Model &model, int width, int height);

// All of them.
void panels(Ui &ui, Model &model, const World &world, const Input &input);
// What is drawn over the picture of this frame.
void marks(Ui &ui, const Model &model, const World &world);

// Numbers as people read them.
std::string fixed(double value, int digits);
std::string whole(uint64_t value);       // 12 345
std::string memory(uint64_t bytes);      // 1.5 MiB
std::string milliseconds(double value);  // negative: not measured

}  // namespace view
