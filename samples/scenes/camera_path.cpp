#include "samples/scenes/camera_path.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/check.h"
#include "samples/scenes/eye.h"
#include "samples/scenes/odeon/toml_table.h"

namespace scenes
{

const std::string &odeon_path();      // odeon/path.toml, embedded by the build
const std::string &vehicle_path();    // town/path.toml
const std::string &multitude_path();  // multitude/path.toml

namespace
{

using PathPoint = std::array<double, 3>;

constexpr Limits anywhere = {-1e6, 1e6}, film = {0, 86400}, angle = {5, 120}, depth = {0.001, 1e6},
                 nearest = {0.001, 5};  // the sky is drawn at ten metres
constexpr double least_m = 0.01;        // from the eye to its target

double distance(const PathPoint &a, const PathPoint &b)
{
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    return std::sqrt(x * x + y * y + z * z);
}

// `look` has no up direction for views within about two degrees of straight up or down.
bool is_upright(const Viewpoint &v)
{
    const double x = v.target[0] - v.eye[0], z = v.target[2] - v.eye[2];
    return std::sqrt(x * x + z * z) > 0.035 * distance(v.eye, v.target);
}

KeyFrame read_key(TomlTable &d, double far_m)
{
    KeyFrame key;
    key.time_s = d.number("time_s", film);
    key.at = d.place();
    key.view.eye = d.triple("eye", anywhere, "[x, y, z]");
    key.view.target = d.triple("target", anywhere, "[x, y, z]");
    key.view.fov_deg = d.number("fov_deg", angle);
    key.view.near_m = d.number("near_m", nearest);
    d.done();
    if (!(key.view.near_m < far_m))
        d.refuse("has near_m = " + show(key.view.near_m) + ", which is not below far_m = " + show(far_m));
    if (distance(key.view.eye, key.view.target) < least_m)
        d.refuse("looks at its own position: eye and target are " + show(distance(key.view.eye, key.view.target)) +
                 " m apart");
    if (!is_upright(key.view)) d.refuse("looks straight up or down, where no direction is upright");
    return key;
}

std::vector<KeyFrame> read_keys(TomlTable &path, double far_m)
{
    std::vector<KeyFrame> keys;
    for (TomlTable &d : path.tables("keys", "key frame")) {
        const KeyFrame key = read_key(d, far_m);
        if (!keys.empty() && !(key.time_s > keys.back().time_s))
            d.refuse("is at " + show(key.time_s) + " s, which is not after the one before it, at " +
                     show(keys.back().time_s) + " s");
        keys.push_back(key);
    }
    if (keys.size() < 2) path.refuse("needs at least 2 key frames ([[keys]]), and has " + std::to_string(keys.size()));
    return keys;
}

std::vector<PathSection> read_sections(TomlTable &path, double start_s, double end_s)
{
    std::vector<PathSection> sections;
    for (TomlTable &d : path.tables("sections", "section")) {
        PathSection s;
        s.name = d.text("name");
        s.start_s = d.number("start_s", film);
        s.end_s = d.number("end_s", film);
        d.done();
        const std::string span = "'" + s.name + "' from " + show(s.start_s) + " to " + show(s.end_s) + " s ";
        if (s.name.empty()) d.refuse("has no name");
        for (const PathSection &other : sections)
            if (other.name == s.name) d.refuse("has the name '" + s.name + "' of another section");
        if (!(s.end_s > s.start_s)) d.refuse(span + "ends before it begins");
        if (s.start_s < start_s || s.end_s > end_s)
            d.refuse(span + "is not within the key frames, which are from " + show(start_s) + " to " + show(end_s) +
                     " s");
        if (!sections.empty() && s.start_s < sections.back().end_s)
            d.refuse(span + "begins before the one before it ends, at " + show(sections.back().end_s) + " s");
        sections.push_back(s);
    }
    if (sections.size() > 16) path.refuse("has more than 16 sections: " + std::to_string(sections.size()));
    return sections;
}

// A cubic through four values at four times, the middle two at 0 and 1. Its tangents are Catmull and Rom's for uneven
// times (those of the parabola through three neighbours), so speed is continuous at a key. Both ends are at rest.
double between(const double (&t)[4], const double (&v)[4], double time)
{
    const double h = t[2] - t[1], u = (time - t[1]) / h;
    const double slope = (v[2] - v[1]) / h;
    const double before = t[1] > t[0] ? (v[1] - v[0]) / (t[1] - t[0]) : 0;
    const double after = t[3] > t[2] ? (v[3] - v[2]) / (t[3] - t[2]) : 0;
    const double m1 = t[1] > t[0] ? (before * h + slope * (t[1] - t[0])) / (t[2] - t[0]) : 0;
    const double m2 = t[3] > t[2] ? (slope * (t[3] - t[2]) + after * h) / (t[3] - t[1]) : 0;
    const double u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * v[1] + (u3 - 2 * u2 + u) * h * m1 + (3 * u2 - 2 * u3) * v[2] + (u3 - u2) * h * m2;
}

}  // namespace

CameraPath::CameraPath(const std::string &toml, const std::string &where)
{
    const toml::table table = parse_toml(toml, where);
    TomlTable path(table, where, "the camera path");
    read(path);
}

CameraPath::CameraPath(TomlTable &path) { read(path); }

void CameraPath::read(TomlTable &path)
{
    far_m_ = path.number("far_m", depth);
    keys_ = read_keys(path, far_m_);
    sections_ = read_sections(path, start_s(), end_s());
    path.done();
    // Between valid key frames a camera may still cross its own target, or swing over it.
    for (size_t k = 0; k + 1 < keys_.size(); ++k)
        for (int step = 1; step < 64; ++step) {
            const double time = keys_[k].time_s + (keys_[k + 1].time_s - keys_[k].time_s) * step / 64;
            const Viewpoint v = at(time);
            if (distance(v.eye, v.target) < least_m || !is_upright(v))
                throw Failure(keys_[k + 1].at + ": between key frame " + std::to_string(k + 1) + " and " +
                              std::to_string(k + 2) + ", at " + show(time) +
                              " s, the camera looks straight up or down, or stands on its target");
        }
}

Viewpoint CameraPath::at(double time_s) const
{
    if (!(time_s > start_s())) return keys_.front().view;
    if (time_s >= end_s()) return keys_.back().view;
    const auto next = std::upper_bound(keys_.begin(), keys_.end(), time_s,
                                       [](double time, const KeyFrame &key) { return time < key.time_s; });
    const size_t k = static_cast<size_t>(next - keys_.begin()) - 1;
    const KeyFrame &a = keys_[k], &b = keys_[k + 1];
    const KeyFrame &before = k > 0 ? keys_[k - 1] : a, &after = k + 2 < keys_.size() ? keys_[k + 2] : b;
    const double t[4] = {before.time_s, a.time_s, b.time_s, after.time_s};
    const auto cubic = [&](auto &&value) {
        const double v[4] = {value(before.view), value(a.view), value(b.view), value(after.view)};
        return between(t, v, time_s);
    };
    Viewpoint v;
    for (size_t axis = 0; axis < 3; ++axis) {
        v.eye[axis] = cubic([axis](const Viewpoint &at) { return at.eye[axis]; });
        v.target[axis] = cubic([axis](const Viewpoint &at) { return at.target[axis]; });
    }
    // Values with limits stay between those of the two key frames.
    const double u = (time_s - a.time_s) / (b.time_s - a.time_s), eased = u * u * (3 - 2 * u);
    v.fov_deg = a.view.fov_deg + (b.view.fov_deg - a.view.fov_deg) * eased;
    v.near_m = a.view.near_m + (b.view.near_m - a.view.near_m) * eased;
    return v;
}

clq_camera CameraPath::camera(double time_s, double aspect) const
{
    const Viewpoint v = at(time_s);
    return look({v.eye[0], v.eye[1], v.eye[2]}, {v.target[0], v.target[1], v.target[2]}, v.fov_deg, aspect, v.near_m,
                far_m_);
}

const std::string *recorded_path(const std::string &scene)
{
    return scene == "odeon"       ? &odeon_path()
           : scene == "vehicle"   ? &vehicle_path()
           : scene == "multitude" ? &multitude_path()
                                  : nullptr;
}

}  // namespace scenes
