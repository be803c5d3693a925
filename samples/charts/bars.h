// Bar charts: panels one above the other that share their groups, with clusters of bars in each group.
#pragma once

#include "samples/charts/drawing.h"

namespace charts
{

struct Cluster {
    std::string name;  // in the legend, which is that of the first panel
    Fill fill = Fill::solid;
};

struct Panel {
    std::string title, unit;
    std::vector<Cluster> clusters;
    // [group][cluster][colour]; negative: no bar
    std::vector<std::vector<std::vector<double>>> values;
    int height_px = 240;  // of the bars alone
};

struct BarChart {
    std::string title, subtitle;
    std::vector<std::string> colours;  // names for the legend, at most series_colours
    struct Group {
        std::string name, detail;
    };
    std::vector<Group> groups;
    std::vector<Panel> panels;
    std::vector<std::string> notes;  // lines below
};

Drawing drawing_of(const BarChart &chart);

}  // namespace charts
