// Assimp's animations as animations of glTF.
#include <algorithm>
#include <cmath>
#include <set>

#include "samples/convert/scene.h"

namespace convert
{
namespace
{

// Of formats and files that do not say, as Assimp's own programs take it.
constexpr double usual_rate_hz = 25;

struct Track {
    std::vector<float> times, values;
    size_t width = 0;

    // Two keys at one time are a jump, which glTF cannot have: the first moves to just before that time. Of more, the
    // first and the last count.
    void add(float time_s, const float *value)
    {
        if (!times.empty() && time_s < times.back()) return;
        if (!times.empty() && time_s == times.back()) {
            const float before = std::nextafter(time_s, -1.0f);
            const size_t count = times.size();
            const bool is_jump = before >= 0 && !std::equal(value, value + width, values.end() - std::ptrdiff_t(width));
            if (is_jump && (count == 1 || times[count - 2] < before)) {
                times.back() = before;
            } else {
                times.pop_back();
                values.resize(values.size() - width);
            }
        }
        times.push_back(time_s);
        values.insert(values.end(), value, value + width);
    }
};

struct Ticks {
    double rate_hz = usual_rate_hz, first = 0;  // in ticks
    float seconds(double tick) const { return static_cast<float>((tick - first) / rate_hz); }
};

Track track_of(const aiVectorKey *keys, unsigned count, const Ticks &ticks)
{
    Track out;
    out.width = 3;
    for (unsigned k = 0; k < count; ++k) {
        const float value[3] = {keys[k].mValue.x, keys[k].mValue.y, keys[k].mValue.z};
        out.add(ticks.seconds(keys[k].mTime), value);
    }
    return out;
}

Track track_of(const aiQuatKey *keys, unsigned count, const Ticks &ticks)
{
    Track out;
    out.width = 4;
    for (unsigned k = 0; k < count; ++k) {
        aiQuaternion turn = keys[k].mValue;
        turn.Normalize();
        const float value[4] = {turn.x, turn.y, turn.z, turn.w};
        out.add(ticks.seconds(keys[k].mTime), value);
    }
    return out;
}

void add_channel(Scene &scene, Json &clip, const Track &track, size_t node, const char *path)
{
    if (track.times.empty()) return;
    const size_t values = scene.glb.floats(track.width == 3 ? "VEC3" : "VEC4", track.values);
    clip["samplers"].push_back({{"input", scene.glb.times(track.times)}, {"output", values}});
    clip["channels"].push_back(
        {{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

// glTF knows no time before 0.
Ticks ticks_of(const aiAnimation &from)
{
    Ticks ticks;
    if (from.mTicksPerSecond > 0) ticks.rate_hz = from.mTicksPerSecond;
    for (unsigned c = 0; c < from.mNumChannels; ++c) {
        const aiNodeAnim &moved = *from.mChannels[c];
        if (moved.mNumPositionKeys) ticks.first = std::min(ticks.first, moved.mPositionKeys[0].mTime);
        if (moved.mNumRotationKeys) ticks.first = std::min(ticks.first, moved.mRotationKeys[0].mTime);
        if (moved.mNumScalingKeys) ticks.first = std::min(ticks.first, moved.mScalingKeys[0].mTime);
    }
    return ticks;
}

void add_clip(Scene &scene, const aiAnimation &from, const std::string &name)
{
    const Ticks ticks = ticks_of(from);
    if (!(from.mTicksPerSecond > 0))
        scene.warn("clip '" + name + "' does not say its rate: taken as 25 frames a second");
    Json clip = {{"name", name}, {"samplers", Json::array()}, {"channels", Json::array()}};
    std::set<const aiNode *> moved;
    for (unsigned c = 0; c < from.mNumChannels; ++c) {
        const aiNodeAnim &channel = *from.mChannels[c];
        const auto [node, end] = scene.named.equal_range(channel.mNodeName.C_Str());
        if (node == end || !moved.insert(node->second).second) continue;
        const size_t index = scene.nodes.at(node->second);
        add_channel(scene, clip, track_of(channel.mPositionKeys, channel.mNumPositionKeys, ticks), index,
                    "translation");
        add_channel(scene, clip, track_of(channel.mRotationKeys, channel.mNumRotationKeys, ticks), index, "rotation");
        add_channel(scene, clip, track_of(channel.mScalingKeys, channel.mNumScalingKeys, ticks), index, "scale");
    }
    if (from.mNumMorphMeshChannels + from.mNumMeshChannels > 0)
        scene.warn("clip '" + name + "' moves vertices by morph targets, which are left out");
    if (clip["channels"].empty()) return scene.warn("clip '" + name + "' moves no node: left out");
    scene.glb.add("animations", clip);
}

}  // namespace

void add_clips(Scene &scene)
{
    std::set<std::string> names;  // each clip can be chosen by its own
    for (unsigned a = 0; a < scene.from.mNumAnimations; ++a) {
        const aiAnimation &from = *scene.from.mAnimations[a];
        const std::string given = from.mName.C_Str(), base = given.empty() ? "clip " + std::to_string(a + 1) : given;
        std::string name = base;
        for (unsigned k = 2; !names.insert(name).second; ++k) name = base + "." + std::to_string(k);
        add_clip(scene, from, name);
    }
}

}  // namespace convert
