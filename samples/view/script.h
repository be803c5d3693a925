// Scripts of the view: what a person would do, written down. docs/view.md describes the steps.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "samples/view/ui.h"
#include "samples/view/world.h"

namespace view
{

struct Step {
    std::vector<std::string> words;
    std::string at;  // in its file, for messages
};

struct Script {
    std::vector<Step> steps;
    double frames_per_s = 25;
    bool measured = false;  // times are real ones, so that pictures differ from run to run
};

// `where` names it in messages. Throws scenes::Failure with the step and the rule.
Script read_script(const std::string &toml, const std::string &where);

// Plays a script as the input of one frame after another.
class Player
{
public:
    // Pictures may have at most the size that it starts with.
    Player(Script script, int width, int height);

    // The input of the next frame, from what the last one showed. Returns false at the end. Throws scenes::Failure if a
    // step names what is not there.
    bool next(Input &input, const Ui &ui, const World &world);
    // The picture that the last frame is for; empty: none.
    const std::string &shot() const { return shot_; }

private:
    void begin(const Step &step, const Ui &ui, const World &world);
    void click(const Step &step, const Ui &ui, const World &world);
    void drag(const Step &step, const Ui &ui, const World &world);
    void type(const Step &step, const Ui &ui);
    void press_keys(const Step &step);
    void turn_wheel(const Step &step, const World &world);
    void wait(const Step &step);
    void resize(const Step &step);
    void drop(const Step &step);
    void see(const Step &step, const Ui &ui) const;
    Box reach(const Step &step, const std::string &name, const Ui &ui);
    void move(float x, float y);
    void press(float x, float y, Button button);
    void turn_to(const Box &box, float from, float to, float t);
    Input still() const;  // nothing happens

    Script script_;
    size_t at_ = 0;
    int most_width_, most_height_, scrolls_ = 0;
    Input now_;
    std::deque<Input> frames_;
    bool again_ = false;  // the step has scrolled to its widget and begins once more
    std::string pending_shot_, shot_;
};

}  // namespace view
