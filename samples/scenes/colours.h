// The colours of a scene's people from a file (S2 5.2), applied again when the file changes.
#pragma once

#include <claque/colour_files.h>

#include <memory>
#include <string>

#include "samples/scenes/library.h"
#include "samples/scenes/scene.h"

namespace scenes
{

struct DestroyMap {
    void operator()(clq_colour_map *map) const { clq_colour_map_destroy(map); }
};
using ColourMap = std::unique_ptr<clq_colour_map, DestroyMap>;

// The map that comes with claque (samples/maps/roman-classes.toml).
const std::string &roman_classes();

ColourMap read_colours(Library &library, const std::string &toml, const std::string &where);

// The class for individuals of this class name or this template; CLQ_NONE if the map has none.
uint32_t class_for(const clq_colour_map *map, const std::string &called, const char *template_name);

// Gives each individual of the scene the colours of its class; individuals without a class keep theirs. Throws
// Failure, with no individual changed, if a class does not fit its template, or no individual has a class.
void colour(const Scene &scene, const clq_colour_map *map, uint64_t crowd_seed);

// A file of colours for a scene.
class ColourFile
{
public:
    ColourFile(Library &library, std::string path);

    // Reads the file if this is the first call or its content has changed, and applies it to the scene; then returns
    // true. Throws Failure if it cannot; the scene is then unchanged, and the same content is not tried again.
    bool apply(const Scene &scene, uint64_t crowd_seed);

private:
    Library &library_;
    std::string path_, last_;  // content
    bool read_ = false;
};

}  // namespace scenes
