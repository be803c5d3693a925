// A view from frame to frame: a function of its model and of what a person does.
#pragma once

#include "samples/view/hands.h"
#include "samples/view/panels.h"

namespace view
{

class Session
{
public:
    // Throws scenes::Failure.
    Session(Surface &surface, Open open, const Switches &switches, float scale, Now now);

    // One frame: the person's input, the panels, the crowd at the model's time, and the picture of it all.
    void frame(const Input &input);

    Model &model() { return model_; }
    const Ui &ui() const { return ui_; }
    const World &world() const { return world_; }

private:
    Now now_;
    World world_;
    Ui ui_;
    Hands hands_;
    Model model_;
};

// The camera path of a model, as docs/scenarios.md describes paths.
std::string path_text(const View &view);

}  // namespace view
