// Rules of samples (docs/labels.md): between which limits cameras, people, light and sensors are chosen.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/scenario/scenario.h"

namespace labels
{

struct Span {
    double first = 0, last = 0;  // equal: always this number
};

// A camera that looks at one person of the scene.
struct CameraRules {
    Span height_m = {1.6, 1.6};  // above the feet of the person
    Span distance_m = {3, 10};   // from the person, on the level
    Span heading_deg = {0, 360};
    std::optional<Span> pitch_deg;  // up is positive; none: it looks at the head
    Span fov_deg = {50, 50};        // the whole vertical angle
    double faces_m = 0.5;           // the middle of no head is nearer
};

// What is absent stays as the scene has it.
struct Rules {
    std::optional<Span> time_s, count;
    std::vector<std::pair<std::string, Span>> classes;  // by name: the share of its people that are there
    std::vector<std::string> colours;                   // files of colours, one of which is taken
    std::optional<CameraRules> camera;
    std::optional<Span> hour, sun, sky;          // the last two are factors
    std::optional<Span> visibility_m;            // of haze
    std::optional<Span> read_noise, shot_noise;  // standard deviations in 255ths: of black, and in addition of white
    std::optional<Span> jpeg_quality;
    std::map<std::string, std::string> places;  // of keys, as "light.hour", for messages
    std::vector<std::string> files;             // all that they name
};

// `where` names the text in messages. Throws scenes::Failure with file, line, column and rule.
Rules read_rules(const std::string &toml, const std::string &where, const scenes::ScenarioFiles &files);
// Of a file; names in it are relative to its folder.
Rules load_rules(const std::string &path);

}  // namespace labels
