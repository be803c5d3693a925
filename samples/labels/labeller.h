// Draws a scene and labels it: the colour picture, a visibility picture, and what follows from it.
#pragma once

#include <functional>
#include <optional>

#include "samples/labels/sample.h"
#include "samples/labels/skeleton.h"
#include "samples/scenes/scene_renderer.h"

namespace labels
{

struct Wanted {
    bool colours = true, zones = true, depth = true, normals = true, positions = false;
    bool flow = true, silhouettes = true, keypoints = true;
    bool scene_depth = false;  // needs colours
    double step_s = 0.04;      // of optical flow, forward and backward
    const KeypointSet *keypoint_set = &coco_keypoints();
    std::function<void()> drawn = [] {};  // called when the colour picture is read
};

class Labeller
{
public:
    // The scene's crowd has exact poses (scenes::CrowdOptions.exact_poses).
    Labeller(scenes::Library &library, scenes::SceneRenderer &scene, const Wanted &wanted);

    Sample label(int frame, double time_s);
    // None where `wanted` is false of what the sample says of its people; silhouettes and flow, which take longest, are
    // then not made.
    std::optional<Sample> label_if(int frame, double time_s, const std::function<bool(const Sample &)> &wanted);
    // Silhouette pictures of the last sample.
    size_t silhouette_pictures() const { return silhouette_pictures_; }

private:
    Sample begin(int frame, double time_s);
    void finish(Sample &out);
    void read_numbers(std::vector<uint32_t> &numbers, const uint8_t *drawn);
    void take_channels(Sample &out);
    void take_people(Sample &out);
    void take_box(uint32_t index, const clq_drawn_actor &drawn, const clq_transform &root, const Sample &sample,
                  Person &out);
    void take_keypoints(const clq_drawn_actor &drawn, const clq_transform &root, const Sample &sample, Person &out);
    Keypoint keypoint_at(const clq_drawn_actor &drawn, const Skeletons::Place &place, double below_m,
                         const Sample &sample) const;
    void measure_silhouettes(Sample &out);
    std::vector<float> flow_to(double time_s, const Sample &sample);

    scenes::SceneRenderer &scene_;
    Wanted wanted_;
    Skeletons skeletons_;
    void (*colour_mask_)(unsigned char, unsigned char, unsigned char, unsigned char) = nullptr;
    std::vector<uint32_t> numbers_;      // of the visibility picture, rows from the bottom
    std::vector<uint32_t> individuals_;  // the same, top row first
    std::vector<size_t> person_of_;      // by individual: of Sample::people
    size_t silhouette_pictures_ = 0;
};

}  // namespace labels
