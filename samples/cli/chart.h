// Bar charts as SVG text: panels one above the other that share their groups, clusters of bars in each group.
#pragma once

#include <string>
#include <vector>

namespace cli
{

// How bars of one cluster are filled; what is compared within a cluster has colours.
enum class Fill { solid, hatched, dotted };

struct Cluster {
    std::string name;  // in the legend, which is that of the first panel
    Fill fill = Fill::solid;
};

struct Panel {
    std::string title, unit;
    std::vector<Cluster> clusters;
    // [group][cluster][colour]; negative: there is no such bar
    std::vector<std::vector<std::vector<double>>> values;
    int height_px = 240;  // of the bars alone
};

struct Chart {
    std::string title, subtitle;
    std::vector<std::string> colours;  // names for the legend, at most five
    struct Group {
        std::string name, detail;
    };
    std::vector<Group> groups;
    std::vector<Panel> panels;
    std::vector<std::string> notes;  // lines below
};

// Follows the reader's light or dark theme, on a ground of its own. The same for the same chart.
std::string svg_of(const Chart &chart);

// Steps of 1, 2 or 5 times a power of ten, so that at most `most` of them reach `largest`.
double tick_step(double largest, int most);

}  // namespace cli
