// One labelled picture.
#pragma once

#include <claque/visibility.h>

#include <array>
#include <string>
#include <vector>

namespace labels
{

struct Box {  // pixels from the top left corner; x1 and y1 are excluded
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool empty() const { return !(x1 > x0 && y1 > y0); }
};

// Outside the picture, hidden by something or by the person itself, or visible. Absent: the skeleton lacks the joint.
enum class Seen { absent, outside, hidden, visible };

struct Keypoint {
    Seen seen = Seen::absent;
    std::array<double, 2> px = {0, 0};
    std::array<double, 3> world = {0, 0, 0};
};

struct Person {
    uint32_t actor = 0;  // index1: the same in all pictures
    std::string character;
    Box visible;  // of its pixels
    Box whole;    // of all its vertices, whatever hides them; may reach beyond the picture
    size_t visible_px = 0;
    size_t whole_px = 0;  // of its silhouette within the picture; 0: not measured
    std::vector<Keypoint> keypoints;
    // In the world: the box along its own axes round all its vertices.
    std::array<double, 3> centre = {0, 0, 0}, size_m = {0, 0, 0};
    std::array<double, 4> rotation_xyzw = {0, 0, 0, 1};
    Keypoint head;  // the middle of its head

    double visibility() const { return whole_px == 0 ? 0 : double(visible_px) / double(whole_px); }
};

// Pictures have their top row first.
struct Sample {
    int frame = 0;
    double time_s = 0;
    int width = 0, height = 0;
    clq_camera camera = {};
    std::vector<uint8_t> rgb;              // [3 *]
    std::vector<uint32_t> actor;           // index1; 0: none
    std::vector<uint16_t> zone;            // zone + 1; 0: none
    std::vector<uint16_t> part;            // part + 1; 0: none
    std::vector<float> depth_m;            // NaN: none
    std::vector<float> scene_depth;        // of the colour picture with its scenery, as GL has it: [0, 1]; 1: the sky
    std::vector<float> normal;             // [3 *] in the world
    std::vector<double> position;          // [3 *] in the world
    std::vector<float> forward, backward;  // [2 *] optical flow, pixels to the right and down
    std::vector<Person> people;            // all that the view lists, by actor
};

}  // namespace labels
