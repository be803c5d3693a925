// The parts that all charts share: the sheet with its title above and notes below, and a legend.
#pragma once

#include "samples/charts/axis_scale.h"
#include "samples/charts/drawing.h"

namespace charts
{

constexpr int sheet_width_px = 960, margin_right_px = 20;

class Sheet
{
public:
    explicit Sheet(double left_px);

    const double left, right = sheet_width_px - margin_right_px;
    double y = 0;  // the height of the sheet that is used so far

    template <class Kind>
    void add(Kind mark)
    {
        drawing_.marks.emplace_back(std::move(mark));
    }
    void head(const std::string &title, const std::string &subtitle);
    void note(const std::string &text);

    struct Swatch {
        std::string name;
        Paint paint;
        Fill fill = Fill::solid;
        Dash dash = Dash::solid;
        double line_width = 0;  // 0: a box
    };
    void legend(const std::vector<Swatch> &swatches);

    // Grid, numbers and title of a vertical axis over the full width, between these two heights.
    void upright(const AxisScale &axis_scale, double top, double bottom, const std::string &title);

    Drawing finish(const std::string &title);

private:
    Drawing drawing_;  // whose first mark is the ground
};

// `text` in lines that fit.
std::vector<std::string> lines_of(const std::string &text, Face face, double width);

}  // namespace charts
