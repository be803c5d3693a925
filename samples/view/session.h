// A view from frame to frame: a function of its model and of what a person does.
#pragma once

#include "samples/view/hands.h"
#include "samples/view/painter.h"
#include "samples/view/panels.h"
#include "samples/view/tiles/task.h"

namespace view
{

class Session
{
public:
    // Throws scenes::Failure.
    Session(Surface &surface, Open open, const Switches &switches, float scale, Now now);
    // The same with what `open` made already, with the same switches.
    Session(Surface &surface, Open open, Loaded loaded, const Switches &switches, float scale, Now now);

    void on_drop(Drop drop) { drop_ = std::move(drop); }
    // The people wear a map's colours from the next frame on, and the designer has them. Throws scenes::Failure.
    void put_on(const std::string &colours);
    // One frame: the person's input, the panels, the crowd at the model's time, and the picture of it all.
    void frame(const Input &input);

    // The picture is drawn by another; null: by the world. It must live until this ends.
    void paint_by(Painter *painter) { painter_ = painter; }
    // Draws this tile of the picture alone, without the interface.
    void show_tile(const tiles::Task &task) { tile_ = task; }
    // Of the last frame: what the person could click on, and what the camera showed. Two sessions that got the same
    // inputs do the same as long as these are equal.
    uint64_t fingerprint() const;

    // The context is lost: shows the same in another one. What was done to single people is lost with it.
    void renew();

    Model &model() { return model_; }
    const Ui &ui() const { return ui_; }
    const World &world() const { return world_; }

private:
    void take_times();
    void take_drop(const std::string &path);

    Surface &surface_;
    Painter *painter_ = nullptr;
    std::optional<tiles::Task> tile_;
    Now now_;
    Drop drop_;
    World world_;
    Ui ui_;
    Hands hands_;
    Model model_;
};

// The camera path of a model, as docs/scenarios.md describes paths.
std::string path_text(const View &view);

}  // namespace view
