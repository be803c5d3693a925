// Where a camera stands that looks at one of the people.
#pragma once

#include "samples/labels/skeleton.h"
#include "samples/labels/variation/choice.h"
#include "samples/scenes/scene_renderer.h"

namespace labels
{

struct Head {
    uint32_t actor = 0;  // index1
    std::array<double, 3> at = {0, 0, 0};
    double ground_m = 0;  // the height at which the person stands
};

// Of all individuals whose skeletons have a head, whether they are shown or not.
std::vector<Head> heads_of(Skeletons &skeletons, const scenes::Scene &scene, double time_s);

struct Standpoint {
    clq_camera camera = {};
    Head person;
    uint32_t attempt = 0;
    double height_m = 0, distance_m = 0, heading_deg = 0, fov_deg = 0;
    std::optional<double> pitch_deg;  // where there is a rule for it
};

// The camera of one attempt. None, with a reason of a few words, if the person would not be in the picture or a face
// too near.
std::optional<Standpoint> stand(const CameraRules &rules, const std::vector<Head> &heads, const Choice &choice,
                                uint32_t attempt, double aspect, std::string &why_not);

// Whether no scenery lies between the person's head and the camera, or a hand's breadth behind it. Draws, and leaves
// another camera.
bool has_free_sight(scenes::SceneRenderer &scene, const Standpoint &from, double time_s);

Json standpoint_json(const Standpoint &standpoint);

}  // namespace labels
