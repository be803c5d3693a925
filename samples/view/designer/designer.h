// The designer's part of the model: the design, what of it is being worked on, and its history.
#pragma once

#include <map>

#include "samples/view/designer/design.h"
#include "samples/view/designer/history.h"

namespace view
{

// What a drag round the hue circle has swept so far, in degrees.
struct Sweep {
    float start = 0, last = 0, swept = 0;
};

// What is to be done once, in the next frame.
struct DesignerWishes {
    bool undo = false, redo = false, load = false, save = false, propose = false, save_zones = false;
};

enum class BrushTool { pick, brush, fill };

struct Brush {
    BrushTool tool = BrushTool::pick;
    float diameter_px = 12, most_zones = 8;
    std::string name = "cloak";  // of the next new zone
    bool held = false;           // a stroke is not at its end yet
    float last[2] = {0, 0};      // where it was, 0 to 1
};

struct ZonePicture;

struct Designer {
    Design design;
    History<Design> history;
    std::string tmpl, colour_class, zone;  // names of what is worked on; empty or unknown: the first
    size_t entry = 0;                      // of the zone's palette
    std::map<std::string, uint32_t> sets;  // by template: the texture set that all of it wear; absent: each its own
    uint32_t texture = 0;                  // of the template, that is shown
    uint32_t people = 0;                   // 0: as many as the scene has
    std::string file = "colours.toml";
    Sweep sweep;
    DesignerWishes wishes;
    Brush brush;
    std::shared_ptr<const ZonePicture> picture;  // of the last frame
    uint64_t seen_pick = 0;                      // the last one that chose a template and a zone
    // Of the last change that reached the crowd.
    size_t changed_people = 0;
    double changed_ms = -1;
    std::string why_not, paint_failure;  // what did not, and the zones that could not be given; "": nothing
};

// What is worked on, found in the design. Null: none yet.
const ColourClass *chosen_class(const Designer &designer);
const ZoneColours *chosen_zone(const Designer &designer);
// The palette that the chosen zone shows: its own, or that of the zone it is linked to; null: the template's range.
const std::vector<clq_palette_entry> *shown_palette(const Designer &designer);
// The same, or the template's own colours as a palette of one.
std::vector<clq_palette_entry> palette_of(const Designer &designer, const clq_hsb_range &own);
// The zones of the class that another one may be linked to.
std::vector<std::string> leaders_for(const ColourClass &colours, const std::string &zone);

// Changes of the design. `by` is the widget's name, see History. What is not there yet is made: a class for the chosen
// template, and the zone in it with the range `own`, which is the template's.
void add_class(Designer &designer);
void remove_class(Designer &designer);
void name_class(Designer &designer, const std::string &name);
void set_range(Designer &designer, const clq_hsb_range &own, const clq_hsb_range &range, const std::string &by);
void set_weight(Designer &designer, const clq_hsb_range &own, float weight, const std::string &by);
void set_space(Designer &designer, const clq_hsb_range &own, clq_colour_space space);
void add_entry(Designer &designer, const clq_hsb_range &own);
void remove_entry(Designer &designer);
// `leader` empty: its own colours again, beginning with those that it showed.
void link_zone(Designer &designer, const clq_hsb_range &own, const std::string &leader);
void set_variation(Designer &designer, float variation, const std::string &by);
// The class does not name the chosen zone any more; zones that were linked to it get its colours.
void forget_zone(Designer &designer);
// A painted map in place of the one of the same texture, if there is one.
void set_zone_map(Designer &designer, SharedMap map, const std::string &by);
// The map of the chosen template's texture that is shown; null: it was not painted.
SharedMap painted_map(const Designer &designer);
uint32_t shown_set(const Designer &designer);
// Another design, as from a file.
void take_design(Designer &designer, Design next, const std::string &by);
bool undo(Designer &designer);
bool redo(Designer &designer);

}  // namespace view
