// The colours of a scene's people from a file (S2 5.2), taken up anew when the file has changed.
#pragma once

#include "samples/scenes/library.h"
#include "samples/scenes/scene.h"

#include <claque/colour_files.h>

#include <memory>
#include <string>

namespace scenes
{

struct DestroyMap {
    void operator()(clq_colour_map *map) const { clq_colour_map_destroy(map); }
};
using ColourMap = std::unique_ptr<clq_colour_map, DestroyMap>;

// The map that comes with claque (samples/maps/roman-classes.toml).
const std::string &roman_classes();

ColourMap read_colours(Library &library, const std::string &toml, const std::string &where);

// The class for individuals that are called so, or wear that template; CLQ_NONE where the map has none.
uint32_t class_for(const clq_colour_map *map, const std::string &called, const char *template_name);

// Gives everybody in the scene the colours of their class; who has none keeps what it has. Throws Failure, with nobody changed,
// where a class does not fit its template, or nobody is of any.
void colour(const Scene &scene, const clq_colour_map *map, uint64_t crowd_seed);

// A file of colours, and a scene that wears them.
class ColourFile
{
public:
    ColourFile(Library &library, std::string path);

    // The first time, or where the file is another than the last time it was looked at: reads it, and gives the scene what it
    // holds; true. Throws Failure where it cannot: the scene is then as it was, and the same file is not tried again.
    bool apply(const Scene &scene, uint64_t crowd_seed);

private:
    Library &library_;
    std::string path_, last_;  // content
    bool read_ = false;
};

}  // namespace scenes
