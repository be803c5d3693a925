// The classes of a scene's people (S2 5.3): what each wears and how it behaves, and the scenes that have them.
#pragma once

#include <claque/template.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/odeon/temperament.h"
#include "samples/scenes/placement.h"

namespace scenes
{

class Library;

// A class of people: its character and colours, how many they are, and what they play.
struct SocialClass {
    std::string name;
    std::string character;  // built-in, or a file
    struct Dye {
        std::string zone;
        clq_hsb_range range;
    };
    std::vector<Dye> palette = {};  // zones that are not named keep the template's own range
    std::string at = {};            // in the file that describes it, for messages
    Placement placement = {};       // of a file
    std::function<void(Library &, clq_asset *)> add_clips = {};  // to a file, or none

    // Where people sit.
    uint32_t count = 0;
    Temperament temperament = Temperament::grave;

    // Where people walk.
    double share = 1;
    struct Clips {
        std::string walk, slow_walk, run, turn;  // names of its clips; empty: found by their usual names
        std::vector<std::string> idles;
    };
    Clips clips = {};
    WalkingNodes limbs = {};
};

// Whether a character is a file, not a built-in one.
inline bool is_file(const std::string &character) { return character.find_first_of("./") != std::string::npos; }

// Whether a file is a template that `claque prepare` wrote.
inline bool is_prepared(const std::string &path) { return path.size() > 4 && path.substr(path.size() - 4) == ".clq"; }

class SocialClasses
{
public:
    virtual ~SocialClasses() = default;
    // The class name of number `person` of Scene::actors().
    virtual std::string class_of(size_t person) const = 0;
};

// The ranges of all zones of the template, with those of the class's palette in their places. Throws Failure if it has
// no such zone.
std::vector<clq_hsb_range> ranges_of(const clq_template *tmpl, const SocialClass &one);

}  // namespace scenes
