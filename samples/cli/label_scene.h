// The pictures that claque labels makes: those of a film, or samples that rules vary.
#pragma once

#include <memory>

#include "samples/cli/scene_arguments.h"
#include "samples/labels/labeller.h"
#include "samples/labels/variation/rules.h"

namespace cli
{

struct LabelledPicture {
    labels::Sample sample;
    Json choice;  // null: nothing was chosen
    size_t silhouette_pictures = 0;
};

class LabelScene
{
public:
    virtual ~LabelScene() = default;
    virtual LabelledPicture label(int number) = 0;
};

// Frame k shows k / fps seconds.
std::unique_ptr<LabelScene> film_scene(scenes::Library &library, const scenes::SceneOptions &options,
                                       const labels::Wanted &wanted, double fps);

// Number k is sample k, whatever was made before; without a rule for the time it shows k / fps seconds. Throws
// scenes::Failure if the scene cannot follow a rule, with the rule's place in its file.
std::unique_ptr<LabelScene> varied_scene(scenes::Library &library, const SceneArguments &arguments,
                                         const scenes::SceneOptions &options, const labels::Wanted &wanted, double fps,
                                         const labels::Rules &rules);

}  // namespace cli
