// A recorded camera path: key frames, smooth in between, and named sections of it (S1 7: "four different sections, each
// of them showing an average specific number of characters"). Where the camera is depends on the time alone.
#pragma once

#include <claque/view.h>

#include <array>
#include <string>
#include <vector>

namespace scenes
{

struct Viewpoint {
    std::array<double, 3> eye, target;  // metres
    double fov_deg = 0;                 // the whole upright angle
    double near_m = 0;                  // nothing nearer is drawn; the farther it is, the finer is depth
};

struct KeyFrame {
    double time_s = 0;
    Viewpoint view;
};

struct PathSection {
    std::string name;
    double start_s = 0, end_s = 0;
};

class CameraPath
{
public:
    // Reads a description (odeon/path.toml shows all there is); `where` names it in sentences. Throws Failure where it
    // is no TOML, lacks something, or cannot be filmed, with the key frame and the numbers.
    CameraPath(const std::string &toml, const std::string &where);

    // Held before the first key frame and after the last. Passes through every key frame; position and direction have
    // no jump in speed at them.
    Viewpoint at(double time_s) const;
    clq_camera camera(double time_s, double aspect) const;

    double start_s() const { return keys_.front().time_s; }
    double end_s() const { return keys_.back().time_s; }
    const std::vector<KeyFrame> &keys() const { return keys_; }
    const std::vector<PathSection> &sections() const { return sections_; }

private:
    std::vector<KeyFrame> keys_;
    std::vector<PathSection> sections_;
    double far_m_ = 0;
};

// The path that comes with a scene; null where it has none.
const std::string *recorded_path(const std::string &scene);

}  // namespace scenes
