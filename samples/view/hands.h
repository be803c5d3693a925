// What mouse, wheel and keys do to the picture itself, where no widget takes them: the camera habits of 3D programs.
#pragma once

#include "samples/view/input.h"
#include "samples/view/model.h"

namespace view
{

class Hands
{
public:
    // `for_mouse`, `for_keys`: no widget takes them.
    void act(Model &model, const Input &input, bool for_mouse, bool for_keys);

private:
    void mouse(Model &model, const Input &input, bool for_mouse);
    void keys(Model &model, const Input &input);

    Input last_;
    float start_x_ = 0, start_y_ = 0;
    bool holds_ = false, moved_ = false;
};

// The camera leaves the scene's and is moved by hand from now on.
void take_camera(Model &model);

}  // namespace view
