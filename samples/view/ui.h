// The widgets of the view, by name. Dear ImGui draws them; this room remembers where each one is, so that scripts reach
// it by its name.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "samples/view/input.h"

struct ImGuiContext;

namespace view
{

struct Box {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // pixels from the upper left corner

    bool holds(float x, float y) const { return x >= x0 && y >= y0 && x < x1 && y < y1; }
};

struct Widget {
    std::string name;
    Box box, clip;        // where it is, and the part of the picture that its panel shows
    bool used = false;    // in this frame
    bool chosen = false;  // one of several that is shown as the choice
    bool round = false;   // a share of it is a share of a turn: 0 at the top, clockwise
};

// Words in lines of at most so many letters, broken at spaces alone: a number keeps its decimals on its line.
std::string in_lines(const std::string &words, size_t letters);
// How many these are; what has no space is broken anywhere.
size_t line_count(const std::string &words, size_t letters);

class Ui
{
public:
    explicit Ui(float scale);
    ~Ui();
    Ui(const Ui &) = delete;
    Ui &operator=(const Ui &) = delete;

    void begin(const Input &input);
    // The context is lost: what it held is made anew in the next frame.
    void forget_context();
    // Completes what was said since begin(); then it can be drawn into the current context.
    void close();
    void draw();
    void end()
    {
        close();
        draw();
    }

    // A panel without a title, at a place of its own; its contents scroll if they are too high.
    void begin_panel(const char *name, const Box &box);
    void end_panel();
    // A part of a panel under a heading that opens and closes it. Returns whether it is open.
    bool section(const char *name, bool &open);

    // Each returns whether the person used it in this frame. Names are also what people read.
    bool button(const char *name, bool on_this_line = false);
    bool toggle(const char *name, bool &value, bool on_this_line = false);
    // `share`: of the panel's width, beside its name. A logarithmic slider needs low > 0.
    bool slider(const char *name, float &value, float low, float high, const char *format, bool logarithmic = false);
    // One of several, beside each other; their widgets are called "name: item".
    bool choice(const char *name, int &value, const std::vector<std::string> &items);
    bool text_field(const char *name, std::string &value);
    void rest_of_line(float width_em);  // the width of the next slider
    void same_line();
    // A number to drag sideways, or to type after a click. `step`: for each pixel.
    bool number(const char *name, float &value, float low, float high, const char *format, float step);
    // A picture of RGBA bytes, its side a power of two. `number` is that of its content. Returns whether the mouse was
    // pressed on it or is held; u, v: where, 0 to 1 from its upper left corner.
    bool picture(const char *name, const uint8_t *rgba, int side_px, uint64_t number, float side, float &u, float &v);
    // A widget that is drawn elsewhere with Dear ImGui: its last item.
    Widget &mark(const std::string &name, bool used);

    void text(const std::string &words);
    void faint(const std::string &words);
    void warning(const std::string &words);
    // A name and a number or word, in two columns.
    void row(const char *name, const std::string &value);
    void swatch(const float (&rgb)[3], const std::string &words);
    // `marks`: upright lines, from 0 to 1 of its width.
    void plot(const char *name, const std::vector<float> &values, const std::string &words,
              const std::vector<float> &marks = {});
    void space();

    // Marks over the picture.
    void brackets(const Box &box, const Box &within, const std::string &words);

    // Words below a point of the picture.
    void mark(float x, float y, const std::string &words);

    // Whether the mouse and the keys are for a widget rather than for the picture.
    bool takes_mouse() const;
    bool holds() const;  // whether a widget is held by the mouse, or has the keys
    bool takes_keys() const;

    float em() const { return em_; }                                 // the height of a letter in pixels
    const std::vector<Widget> &widgets() const { return widgets_; }  // of the last complete frame
    const std::vector<Widget> &texts() const { return texts_; }      // the same of all texts; the name is what they say
    const Widget *find(const std::string &name) const;

private:
    Widget placed(const std::string &name, bool used) const;  // the last item
    bool note(const std::string &name, bool used);

    ImGuiContext *context_;
    float em_;
    std::string font_;
    std::vector<Widget> widgets_, drawn_, texts_, said_;
    float next_width_em_ = 0;
    struct Uploaded {
        unsigned texture = 0;
        uint64_t number = 0;
        int side_px = 0;
    };
    std::map<std::string, Uploaded> pictures_;
};

}  // namespace view
