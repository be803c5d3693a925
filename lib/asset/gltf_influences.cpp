#include "lib/asset/gltf_influences.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/nearest_vertex.h"

namespace claque::asset
{

using base::fail;

namespace
{

struct Set {
    std::vector<uint32_t> joints;  // 4 a vertex
    std::vector<float> weights;
};

Set read_set(File &file, const JsonView &joints, const JsonView &weights, size_t vertices)
{
    Set set;
    set.joints = file.accessors.integers(file.accessors.reference(joints), 4, joints.path());
    set.weights = file.accessors.any_floats(file.accessors.reference(weights), 4, weights.path());
    if (set.joints.size() != 4 * vertices || set.weights.size() != 4 * vertices)
        fail(CLQ_FORMAT, "%s and %s have %zu and %zu elements, the primitive has %zu positions", joints.path().c_str(),
             weights.path().c_str(), set.joints.size() / 4, set.weights.size() / 4, vertices);
    for (size_t i = 0; i < set.weights.size(); ++i) {
        if (!std::isfinite(set.weights[i])) set.weights[i] = 0;  // some exporters divide by a sum of 0
        if (set.weights[i] < 0) fail(CLQ_FORMAT, "%s: vertex %zu has a negative weight", weights.path().c_str(), i / 4);
    }
    return set;
}

std::vector<Set> read_sets(File &file, const JsonView &attributes, size_t vertices)
{
    std::vector<Set> sets;
    for (size_t n = 0;; ++n) {
        const JsonView joints = attributes[("JOINTS_" + std::to_string(n)).c_str()];
        const JsonView weights = attributes[("WEIGHTS_" + std::to_string(n)).c_str()];
        if (!joints.exists() && !weights.exists()) return sets;
        sets.push_back(read_set(file, joints, weights, vertices));
    }
}

uint32_t busiest(const std::vector<Set> &sets, size_t vertices)
{
    uint32_t maximum = 1;
    for (size_t v = 0; v < vertices; ++v) {
        uint32_t count = 0;
        for (const Set &set : sets)
            for (size_t k = 0; k < 4; ++k) count += set.weights[4 * v + k] > 0;
        maximum = std::max(maximum, count);
    }
    return maximum;
}

// True if the vertex has any weight.
bool gather(const std::vector<Set> &sets, size_t v, uint32_t count, uint32_t *joints, float *weights)
{
    double sum = 0;
    for (const Set &set : sets)
        for (size_t k = 0; k < 4; ++k) sum += static_cast<double>(set.weights[4 * v + k]);
    if (!(sum > 0)) return false;
    std::fill(weights, weights + count, 0.0f);
    uint32_t at = 0;
    for (const Set &set : sets)
        for (size_t k = 0; k < 4; ++k)
            if (set.weights[4 * v + k] > 0) {
                joints[at] = set.joints[4 * v + k];
                weights[at++] = static_cast<float>(static_cast<double>(set.weights[4 * v + k]) / sum);
            }
    // Unused slots repeat a joint that is used, because the joints that a file has in its unused slots need not exist.
    std::fill(joints + at, joints + count, joints[0]);
    return true;
}

// Vertices without weights move as the weighted ones nearest to them, or as the builder decides where there are none.
void lend_weights(File &file, const std::string &path, const std::vector<uint32_t> &weightless, model::Part &part)
{
    const size_t vertices = part.positions.size(), count = part.influence_count;
    std::vector<uint32_t> weighted;
    for (uint32_t v = 0, next = 0; v < vertices; ++v)
        if (next < weightless.size() && weightless[next] == v) ++next;
        else weighted.push_back(v);
    if (weighted.empty()) {
        std::fill(part.joints.begin(), part.joints.end(), none);
        std::fill(part.weights.begin(), part.weights.end(), 1.0f);
        return file.warn(
            base::text_of("%s: no vertex has weights: all move with the joint above the mesh, or else the "
                          "skin's first",
                          path.c_str()));
    }
    const NearestVertex nearest(part.positions, std::move(weighted));
    for (const uint32_t v : weightless) {
        const size_t from = nearest.to(part.positions[v]) * count, to = v * count;
        std::copy_n(part.joints.begin() + static_cast<std::ptrdiff_t>(from), count,
                    part.joints.begin() + static_cast<std::ptrdiff_t>(to));
        std::copy_n(part.weights.begin() + static_cast<std::ptrdiff_t>(from), count,
                    part.weights.begin() + static_cast<std::ptrdiff_t>(to));
    }
    file.warn(
        base::text_of("%s: %zu of %zu vertices have no weights above 0: they move as the weighted vertices "
                      "nearest to them",
                      path.c_str(), weightless.size(), vertices));
}

}  // namespace

bool read_influences(File &file, const JsonView &attributes, model::Part &part)
{
    const size_t vertices = part.positions.size();
    const std::vector<Set> sets = read_sets(file, attributes, vertices);
    if (sets.empty()) return false;
    part.influence_count = busiest(sets, vertices);
    file.budget.charge(uint64_t(8) * vertices * part.influence_count, attributes.path().c_str());
    part.joints.resize(vertices * part.influence_count);
    part.weights.resize(vertices * part.influence_count);
    std::vector<uint32_t> weightless;
    for (uint32_t v = 0; v < vertices; ++v) {
        const size_t at = size_t(v) * part.influence_count;
        if (!gather(sets, v, part.influence_count, &part.joints[at], &part.weights[at])) weightless.push_back(v);
    }
    if (weightless.empty()) return true;
    file.budget.charge(uint64_t(8) * vertices, attributes.path().c_str());
    lend_weights(file, attributes.path(), weightless, part);
    return true;
}

}  // namespace claque::asset
