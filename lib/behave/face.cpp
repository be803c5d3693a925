#include "lib/behave/face.h"

namespace claque::behave
{

namespace
{

base::Span<const crowd::DofValue> values_of(const Face::Entry &layer, base::Span<const crowd::DofPose> poses,
                                            base::Span<const crowd::DofValue> values)
{
    const crowd::DofPose &pose = poses[layer.pose];
    return {values.data + pose.first, pose.count};
}

const crowd::DofValue *find(base::Span<const crowd::DofValue> values, uint32_t dof)
{
    for (const crowd::DofValue &value : values)
        if (value.dof == dof) return &value;
    return nullptr;
}

}  // namespace

Face Face::of(uint32_t pose)
{
    Face face;
    if (pose != model::none) face.entries[face.count++] = {pose, 1};
    return face;
}

void Face::blend(const Face &other, double by)
{
    if (!(by > 0)) return;
    if (by >= 1) {
        *this = other;
        return;
    }
    for (uint32_t i = 0; i < count; ++i) entries[i].weight *= 1 - by;
    for (uint32_t i = 0; i < other.count; ++i) entries[count++] = {other.entries[i].pose, other.entries[i].weight * by};
}

void apply_face(const Face &face, base::Span<const crowd::DofPose> poses, base::Span<const crowd::DofValue> values,
                Writer &writer) noexcept
{
    for (uint32_t i = 0; i < face.count; ++i) {
        for (const crowd::DofValue &value : values_of(face.entries[i], poses, values)) {
            bool done = false;
            for (uint32_t k = 0; k < i && !done; ++k)
                done = find(values_of(face.entries[k], poses, values), value.dof) != nullptr;
            if (done) continue;
            double sum = 0, weight = 0;
            for (uint32_t k = i; k < face.count; ++k)
                if (const crowd::DofValue *other = find(values_of(face.entries[k], poses, values), value.dof)) {
                    weight += face.entries[k].weight;
                    sum += face.entries[k].weight * static_cast<double>(other->value);
                }
            if (weight > 0)
                writer.write(value.dof, static_cast<float>(sum / weight), static_cast<float>(weight < 1 ? weight : 1));
        }
    }
}

}  // namespace claque::behave
