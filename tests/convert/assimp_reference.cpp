#include "tests/convert/assimp_reference.h"

#include <algorithm>
#include <cmath>

namespace convert_test
{
namespace
{

using Quaternion = std::array<double, 4>;  // w, x, y, z

constexpr Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix matrix_of(const aiMatrix4x4 &from)
{
    Matrix out;
    for (unsigned i = 0; i < 16; ++i) out[i] = double(from[i / 4][i % 4]);
    return out;
}

Matrix times(const Matrix &a, const Matrix &b)
{
    Matrix out = {};
    for (size_t r = 0; r < 4; ++r)
        for (size_t c = 0; c < 4; ++c)
            for (size_t k = 0; k < 4; ++k) out[4 * r + c] += a[4 * r + k] * b[4 * k + c];
    return out;
}

Point moved(const Matrix &m, const Point &p)
{
    Point out;
    for (size_t r = 0; r < 3; ++r) out[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    return out;
}

Quaternion unit(Quaternion q)
{
    double length = 0;
    for (const double x : q) length += x * x;
    for (double &x : q) x /= std::sqrt(length);
    return q;
}

Quaternion between(Quaternion a, Quaternion b, double share)
{
    double cosine = 0;
    for (size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    if (cosine < 0) {
        cosine = -cosine;
        for (double &x : b) x = -x;
    }
    double wa = 1 - share, wb = share;
    if (cosine < 1 - 1e-12) {
        const double angle = std::acos(cosine);
        wa = std::sin((1 - share) * angle) / std::sin(angle);
        wb = std::sin(share * angle) / std::sin(angle);
    }
    for (size_t i = 0; i < 4; ++i) a[i] = wa * a[i] + wb * b[i];
    return unit(a);
}

Matrix composed(const Point &move, const Quaternion &q, const Point &scale)
{
    const auto [w, x, y, z] = q;
    return {(1 - 2 * (y * y + z * z)) * scale[0],
            2 * (x * y - w * z) * scale[1],
            2 * (x * z + w * y) * scale[2],
            move[0],
            2 * (x * y + w * z) * scale[0],
            (1 - 2 * (x * x + z * z)) * scale[1],
            2 * (y * z - w * x) * scale[2],
            move[1],
            2 * (x * z - w * y) * scale[0],
            2 * (y * z + w * x) * scale[1],
            (1 - 2 * (x * x + y * y)) * scale[2],
            move[2],
            0,
            0,
            0,
            1};
}

// The keys round a time, and how far it is from the first to the second.
template <class Key>
double find(const Key *keys, unsigned count, double ticks, unsigned &first, unsigned &second)
{
    first = 0;
    while (first + 1 < count && keys[first + 1].mTime <= ticks) ++first;
    second = std::min(first + 1, count - 1);
    const double span = keys[second].mTime - keys[first].mTime;
    return span > 0 ? std::clamp((ticks - keys[first].mTime) / span, 0.0, 1.0) : 0;
}

Point sampled(const aiVectorKey *keys, unsigned count, double ticks)
{
    unsigned a, b;
    const double share = find(keys, count, ticks, a, b);
    Point out;
    for (unsigned k = 0; k < 3; ++k)
        out[k] = (1 - share) * double(keys[a].mValue[k]) + share * double(keys[b].mValue[k]);
    return out;
}

Quaternion sampled(const aiQuatKey *keys, unsigned count, double ticks)
{
    unsigned a, b;
    const double share = find(keys, count, ticks, a, b);
    const auto value = [&](unsigned k) {
        const aiQuaternion &q = keys[k].mValue;
        return unit({double(q.w), double(q.x), double(q.y), double(q.z)});
    };
    return between(value(a), value(b), share);
}

// Columns are axes: their lengths are the scale, the rest is the rotation.
Matrix animated(const aiNodeAnim &channel, const Matrix &rest, double ticks)
{
    Matrix out = rest;
    Point scale;
    for (size_t c = 0; c < 3; ++c)
        scale[c] = std::sqrt(rest[c] * rest[c] + rest[4 + c] * rest[4 + c] + rest[8 + c] * rest[8 + c]);
    Point new_scale = scale;
    if (channel.mNumScalingKeys) new_scale = sampled(channel.mScalingKeys, channel.mNumScalingKeys, ticks);
    if (channel.mNumRotationKeys) {
        const Quaternion q = sampled(channel.mRotationKeys, channel.mNumRotationKeys, ticks);
        out = composed({rest[3], rest[7], rest[11]}, q, new_scale);
    } else {
        for (size_t i = 0; i < 12; ++i)
            if (i % 4 < 3) out[i] *= new_scale[i % 4] / scale[i % 4];
    }
    if (channel.mNumPositionKeys) {
        const Point move = sampled(channel.mPositionKeys, channel.mNumPositionKeys, ticks);
        for (size_t r = 0; r < 3; ++r) out[4 * r + 3] = move[r];
    }
    return out;
}

void collect(const aiNode &node, std::map<std::string, const aiNode *> &named)
{
    named.emplace(node.mName.C_Str(), &node);
    for (unsigned c = 0; c < node.mNumChildren; ++c) collect(*node.mChildren[c], named);
}

}  // namespace

Reference::Reference(const aiScene &scene) : scene_(scene)
{
    collect(*scene.mRootNode, first_named_);
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        bool moves = false;
        for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c)
            moves = moves || first_named_.count(scene.mAnimations[a]->mChannels[c]->mNodeName.C_Str());
        if (moves) animations_.push_back(static_cast<int>(a));
    }
}

double Reference::rate_of(int animation) const
{
    const double rate = scene_.mAnimations[animation]->mTicksPerSecond;
    return rate > 0 ? rate : 25;
}

double Reference::first_of(int animation) const
{
    double first = 0;
    const aiAnimation &from = *scene_.mAnimations[animation];
    for (unsigned c = 0; c < from.mNumChannels; ++c)
        if (from.mChannels[c]->mNumRotationKeys) first = std::min(first, from.mChannels[c]->mRotationKeys[0].mTime);
    return first;
}

void Reference::place(const aiNode &node, const Matrix &above, int animation, double ticks)
{
    Matrix local = matrix_of(node.mTransformation);
    if (animation >= 0 && first_named_.at(node.mName.C_Str()) == &node) {
        const aiAnimation &from = *scene_.mAnimations[animation];
        for (unsigned c = from.mNumChannels; c-- > 0;)
            if (from.mChannels[c]->mNodeName == node.mName)
                local = animated(*from.mChannels[c], matrix_of(node.mTransformation), ticks);
    }
    // Bones of Half-Life models are listed side by side, and name their parents, which come first.
    const auto parent = globals_.find(node.mParent);
    globals_[&node] = times(parent == globals_.end() ? above : parent->second, local);
    for (unsigned c = 0; c < node.mNumChildren; ++c) place(*node.mChildren[c], globals_[&node], animation, ticks);
}

void Reference::skin(const aiNode &node, const aiMesh &mesh, std::vector<Point> &out) const
{
    std::vector<Point> sums(mesh.mNumVertices, Point{0, 0, 0});
    std::vector<double> weights(mesh.mNumVertices, 0);
    const auto vertex = [&](unsigned v) {
        return Point{double(mesh.mVertices[v].x), double(mesh.mVertices[v].y), double(mesh.mVertices[v].z)};
    };
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone &bone = *mesh.mBones[b];
        const auto found = first_named_.find(bone.mName.C_Str());
        const Matrix matrix = found == first_named_.end()
                                  ? globals_.at(&node)
                                  : times(globals_.at(found->second), matrix_of(bone.mOffsetMatrix));
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const unsigned v = bone.mWeights[w].mVertexId;
            const double weight = double(bone.mWeights[w].mWeight);
            if (!(weight > 0)) continue;
            const Point at = moved(matrix, vertex(v));
            for (size_t k = 0; k < 3; ++k) sums[v][k] += weight * at[k];
            weights[v] += weight;
        }
    }
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        if (weights[v] > 0)
            for (double &x : sums[v]) x /= weights[v];
        else sums[v] = moved(globals_.at(&node), vertex(v));
        out.push_back(sums[v]);
    }
}

void Reference::walk(const aiNode &node, std::vector<Point> &out) const
{
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh &mesh = *scene_.mMeshes[node.mMeshes[m]];
        if (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) skin(node, mesh, out);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) walk(*node.mChildren[c], out);
}

std::vector<Point> Reference::pose(int animation, double ticks)
{
    globals_.clear();
    place(*scene_.mRootNode, identity, animation, ticks);
    std::vector<Point> out;
    walk(*scene_.mRootNode, out);
    return out;
}

}  // namespace convert_test
