#include "lib/behave/face.h"

namespace claque::behave
{

namespace
{

base::Span<const crowd::DofValue> values_of(const Face::Layer &layer, base::Span<const crowd::Shape> shapes,
                                            base::Span<const crowd::DofValue> values)
{
    const crowd::Shape &shape = shapes[layer.shape];
    return {values.data + shape.first, shape.count};
}

const crowd::DofValue *find(base::Span<const crowd::DofValue> values, uint32_t dof)
{
    for (const crowd::DofValue &value : values)
        if (value.dof == dof) return &value;
    return nullptr;
}

}  // namespace

Face Face::of(uint32_t shape)
{
    Face face;
    if (shape != model::none) face.layers[face.count++] = {shape, 1};
    return face;
}

void Face::blend(const Face &other, double by)
{
    if (!(by > 0)) return;
    if (by >= 1) {
        *this = other;
        return;
    }
    for (uint32_t i = 0; i < count; ++i) layers[i].weight *= 1 - by;
    for (uint32_t i = 0; i < other.count; ++i) layers[count++] = {other.layers[i].shape, other.layers[i].weight * by};
}

void lay(const Face &face, base::Span<const crowd::Shape> shapes, base::Span<const crowd::DofValue> values,
         Writer &writer) noexcept
{
    for (uint32_t i = 0; i < face.count; ++i) {
        for (const crowd::DofValue &value : values_of(face.layers[i], shapes, values)) {
            bool done = false;
            for (uint32_t k = 0; k < i && !done; ++k)
                done = find(values_of(face.layers[k], shapes, values), value.dof) != nullptr;
            if (done) continue;
            double sum = 0, weight = 0;
            for (uint32_t k = i; k < face.count; ++k)
                if (const crowd::DofValue *other = find(values_of(face.layers[k], shapes, values), value.dof)) {
                    weight += face.layers[k].weight;
                    sum += face.layers[k].weight * static_cast<double>(other->value);
                }
            if (weight > 0)
                writer.write(value.dof, static_cast<float>(sum / weight), static_cast<float>(weight < 1 ? weight : 1));
        }
    }
}

}  // namespace claque::behave
