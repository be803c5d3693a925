#include <algorithm>
#include <stdexcept>

#include "tests/reference/gltf_reference.h"

namespace claque::reference
{
namespace
{

using Value = std::vector<double>;

// Stored value of a key: `which` is 0 in-tangent, 1 value, 2 out-tangent of a spline, 0 for the other kinds.
Value key_value(const Channel &channel, size_t key, size_t which)
{
    const size_t per_key = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    const double *first = channel.values.data() + (key * per_key + which) * channel.width;
    return Value(first, first + channel.width);
}

Quat quat_of(const Value &v) { return {v.at(0), v.at(1), v.at(2), v.at(3)}; }

Value between_linear(const Channel &channel, size_t key, double t)
{
    const Value a = key_value(channel, key, 0), b = key_value(channel, key + 1, 0);
    if (channel.path == Path::Rotation) {
        const Quat q = slerp(normalized(quat_of(a)), normalized(quat_of(b)), t);
        return {q.x, q.y, q.z, q.w};
    }
    Value mixed(channel.width);
    for (size_t i = 0; i < channel.width; ++i) mixed[i] = a[i] * (1 - t) + b[i] * t;
    return mixed;
}

Value between_spline(const Channel &channel, size_t key, double t)
{
    const double span = channel.times[key + 1] - channel.times[key];
    const Value value0 = key_value(channel, key, 1), leaving0 = key_value(channel, key, 2);
    const Value arriving1 = key_value(channel, key + 1, 0), value1 = key_value(channel, key + 1, 1);
    const double t2 = t * t, t3 = t2 * t;
    Value mixed(channel.width);
    for (size_t i = 0; i < channel.width; ++i)
        mixed[i] = (2 * t3 - 3 * t2 + 1) * value0[i] + (t3 - 2 * t2 + t) * span * leaving0[i] +
                   (3 * t2 - 2 * t3) * value1[i] + (t3 - t2) * span * arriving1[i];
    return mixed;
}

Value raw_sample(const Channel &channel, double time_s)
{
    const std::vector<double> &times = channel.times;
    const size_t value_slot = channel.interpolation == Interpolation::CubicSpline ? 1 : 0;
    if (time_s <= times.front()) return key_value(channel, 0, value_slot);
    if (time_s >= times.back()) return key_value(channel, times.size() - 1, value_slot);
    const size_t key = static_cast<size_t>(std::upper_bound(times.begin(), times.end(), time_s) - times.begin()) - 1;
    const double t = (time_s - times[key]) / (times[key + 1] - times[key]);
    if (channel.interpolation == Interpolation::Step) return key_value(channel, key, 0);
    return channel.interpolation == Interpolation::Linear ? between_linear(channel, key, t)
                                                          : between_spline(channel, key, t);
}

// The nodes with the channels' values put in.
std::vector<Node> posed_nodes(const Character &character, size_t clip, double time_s)
{
    std::vector<Node> nodes = character.nodes;
    if (clip == rest) return nodes;
    for (const Channel &channel : character.clips.at(clip).channels) {
        Node &node = nodes.at(channel.node);
        const Value v = sample(channel, time_s);
        if (channel.path == Path::Weights) {
            node.morph_weights = v;
            continue;
        }
        if (node.has_matrix) throw std::runtime_error("node " + node.name + " has a matrix and is animated");
        if (channel.path == Path::Rotation) node.rotation = quat_of(v);
        else (channel.path == Path::Translation ? node.translation : node.scale) = Vec3{v.at(0), v.at(1), v.at(2)};
    }
    return nodes;
}

std::vector<Mat4> world_matrices(const std::vector<Node> &nodes)
{
    std::vector<Mat4> worlds(nodes.size());
    for (size_t i = 0; i < nodes.size(); ++i)
        for (int at = static_cast<int>(i); at >= 0; at = nodes[static_cast<size_t>(at)].parent) {
            const Node &node = nodes[static_cast<size_t>(at)];
            const Mat4 local = node.has_matrix ? node.matrix : compose(node.translation, node.rotation, node.scale);
            worlds[i] = local * worlds[i];
        }
    return worlds;
}

std::vector<Vec3> morphed(const std::vector<Vec3> &base, const Part &part, const std::vector<double> &weights,
                          std::vector<Vec3> MorphTarget::*deltas)
{
    std::vector<Vec3> result = base;
    for (size_t t = 0; t < part.targets.size() && t < weights.size(); ++t) {
        const std::vector<Vec3> &delta = part.targets[t].*deltas;
        for (size_t v = 0; v < delta.size() && v < result.size(); ++v) result[v] = result[v] + delta[v] * weights[t];
    }
    return result;
}

Mat4 vertex_matrix(const Character &character, const Part &part, size_t vertex, const std::vector<Mat4> &worlds)
{
    if (part.skin < 0) return worlds[part.node];
    const Skin &skin = character.skins.at(static_cast<size_t>(part.skin));
    Mat4 blended = zero_matrix();
    for (size_t k = vertex * part.influences; k < (vertex + 1) * part.influences; ++k) {
        if (part.weights[k] == 0) continue;
        const size_t joint = part.joints[k];
        add_scaled(blended, worlds.at(skin.joints.at(joint)) * skin.inverse_binds.at(joint), part.weights[k]);
    }
    return blended;
}

}  // namespace

std::vector<double> sample(const Channel &channel, double time_s)
{
    const Value value = raw_sample(channel, time_s);
    if (channel.path != Path::Rotation) return value;
    const Quat q = normalized(quat_of(value));
    return {q.x, q.y, q.z, q.w};
}

Shape evaluate(const Character &character, size_t clip, double time_s)
{
    const std::vector<Node> nodes = posed_nodes(character, clip, time_s);
    const std::vector<Mat4> worlds = world_matrices(nodes);
    Shape shape;
    for (const Part &part : character.parts) {
        const std::vector<double> &weights = nodes[part.node].morph_weights;
        const std::vector<Vec3> positions = morphed(part.positions, part, weights, &MorphTarget::positions);
        std::vector<Vec3> normals = morphed(part.normals, part, weights, &MorphTarget::normals);
        normals.resize(positions.size());
        for (size_t v = 0; v < positions.size(); ++v) {
            const Mat4 matrix = vertex_matrix(character, part, v, worlds);
            shape.positions.push_back(transform_point(matrix, positions[v]));
            shape.stretches.push_back(condition_number(matrix));
            shape.mirrored.push_back(dot(matrix.column(0), cross(matrix.column(1), matrix.column(2))) < 0);
            shape.normals.push_back(transform_normal(matrix, normals[v]));
        }
    }
    return shape;
}

}  // namespace claque::reference
