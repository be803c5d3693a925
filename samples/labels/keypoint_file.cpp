// Keypoints of one's own: names, the joints or nodes that they belong to, and lines between them.
#include <algorithm>

#include "samples/io/files.h"
#include "samples/io/joined.h"
#include "samples/labels/joint_names.h"
#include "samples/labels/keypoints.h"
#include "samples/scenes/check.h"
#include "samples/scenes/odeon/toml_table.h"

namespace labels
{
namespace
{

using scenes::TomlTable;

constexpr size_t most_points = 256;
const char *const face_points[] = {"nose", "left_eye", "right_eye", "left_ear", "right_ear"};

OwnPoint read_point(TomlTable &point)
{
    OwnPoint out;
    if (point.has("joint") == point.has("nodes")) point.refuse("needs one of 'joint' and 'nodes'");
    if (point.has("nodes")) out.nodes = point.texts("nodes");
    if (point.has("joint")) {
        out.joint = point.text("joint");
        std::vector<std::string> all = joint_names();
        all.insert(all.end(), std::begin(face_points), std::end(face_points));
        if (std::find(all.begin(), all.end(), out.joint) == all.end())
            point.refuse("has no joint '" + out.joint + "' to be at; there are " + io::joined(all), "joint");
    }
    if (point.has("offset_m")) out.offset_m = point.triple("offset_m", {-10, 10}, "[left, up, forwards]");
    point.done();
    return out;
}

}  // namespace

KeypointSet read_keypoints(const std::string &text, const std::string &where)
{
    const toml::table table = scenes::parse_toml(text, where);
    TomlTable all(table, where, "the file of keypoints");
    KeypointSet out;
    out.name = all.text("name");
    for (TomlTable &point : all.tables("points", "[[points]]")) {
        const std::string name = point.text("name");
        if (name.empty()) point.refuse("has the name \"\"", "name");
        if (!out.own.emplace(name, read_point(point)).second) point.refuse("is a second point '" + name + "'", "name");
        out.names.push_back(name);
        if (out.names.size() > most_points)
            point.refuse("is one too many: there are at most " + std::to_string(most_points));
    }
    if (out.names.empty()) all.refuse("has no [[points]]");
    for (TomlTable &line : all.tables("lines", "[[lines]]")) {
        const auto end = [&](const char *key) {
            const std::string name = line.text(key);
            const auto at = std::find(out.names.begin(), out.names.end(), name);
            if (at == out.names.end()) line.refuse("has no point '" + name + "' to end at", key);
            return static_cast<int>(at - out.names.begin());
        };
        const int from = end("from"), to = end("to");
        out.edges.push_back({from, to});
        line.done();
    }
    all.done();
    return out;
}

KeypointSet keypoint_set(const std::string &name)
{
    if (name == "coco") return coco_keypoints();
    if (name == "smpl") return smpl_keypoints();
    if (name.find_first_of("./") == std::string::npos)
        throw scenes::Failure("there are no keypoints '" + name + "'; there are coco, smpl, and files of your own");
    std::string text;
    const std::string wrong = io::read_whole(name, text);
    if (!wrong.empty()) throw scenes::Failure(wrong);
    return read_keypoints(text, name);
}

}  // namespace labels
