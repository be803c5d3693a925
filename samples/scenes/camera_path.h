// A recorded camera path: key frames, smooth in between, and named sections of it (S1 7: "four different sections,
// each of them showing an average specific number of characters"). The camera's position depends on the time alone.
#pragma once

#include <claque/view.h>

#include <array>
#include <string>
#include <vector>

namespace scenes
{

class TomlTable;

struct Viewpoint {
    std::array<double, 3> eye, target;  // metres
    double fov_deg = 0;                 // the whole vertical angle
    double near_m = 0;                  // near plane; depth is finer the farther it is
};

struct KeyFrame {
    double time_s = 0;
    Viewpoint view;
    std::string at;  // in its file, for messages
};

struct PathSection {
    std::string name;
    double start_s = 0, end_s = 0;
};

class CameraPath
{
public:
    // Reads a description (odeon/path.toml uses every key); `where` names it in error messages. Throws Failure with
    // the key frame and the numbers if the text is not TOML, lacks something, or describes a path that no camera can
    // follow.
    CameraPath(const std::string &toml, const std::string &where);
    // The same from a table within another description.
    explicit CameraPath(TomlTable &path);

    // Constant before the first key frame and after the last. Passes through every key frame, where the speed of
    // position and direction is continuous.
    Viewpoint at(double time_s) const;
    clq_camera camera(double time_s, double aspect) const;

    double start_s() const { return keys_.front().time_s; }
    double end_s() const { return keys_.back().time_s; }
    const std::vector<KeyFrame> &keys() const { return keys_; }
    const std::vector<PathSection> &sections() const { return sections_; }

private:
    void read(TomlTable &path);

    std::vector<KeyFrame> keys_;
    std::vector<PathSection> sections_;
    double far_m_ = 0;
};

// The path that comes with a scene; null if it has none.
const std::string *recorded_path(const std::string &scene);

}  // namespace scenes
