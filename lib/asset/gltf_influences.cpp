#include "lib/asset/gltf_influences.h"

#include <algorithm>

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
    set.weights = file.accessors.floats(file.accessors.reference(weights), 4, weights.path());
    if (set.joints.size() != 4 * vertices || set.weights.size() != 4 * vertices)
        fail(CLQ_FORMAT, "%s and %s have %zu and %zu elements, the primitive has %zu positions", joints.path().c_str(),
             weights.path().c_str(), set.joints.size() / 4, set.weights.size() / 4, vertices);
    for (size_t i = 0; i < set.weights.size(); ++i)
        if (set.weights[i] < 0) fail(CLQ_FORMAT, "%s: vertex %zu has a negative weight", weights.path().c_str(), i / 4);
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
    std::fill(joints, joints + count, sets[0].joints[4 * v]);
    std::fill(weights, weights + count, 0.0f);
    if (!(sum > 0)) {
        weights[0] = 1;
        return false;
    }
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
    size_t weightless = 0;
    for (size_t v = 0; v < vertices; ++v) {
        const size_t at = v * part.influence_count;
        if (!gather(sets, v, part.influence_count, &part.joints[at], &part.weights[at])) ++weightless;
    }
    if (weightless)
        file.warn(base::text_of("%s: %zu vertices have no weights: each follows the first joint it lists",
                                attributes.path().c_str(), weightless));
    return true;
}

}  // namespace claque::asset
