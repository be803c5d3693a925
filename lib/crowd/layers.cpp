#include "lib/crowd/layers.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/base/reserve.h"

namespace claque::crowd
{

using model::none;

uint32_t LayerState::max_clip_count() const
{
    uint32_t sum = now.gait == none ? 1 : 2;
    // An inertial fade shows its source as two additive layers.
    for (uint32_t k = 0; k < fade_count; ++k)
        sum += fades[k].from.gait != none || fades[k].curve == Curve::inertial ? 2 : 1;
    return sum + layer_count;
}

float LayerState::max_additive_weight() const
{
    float sum = 0;
    bool inertial = false;
    for (uint32_t k = 0; k < fade_count; ++k) inertial = inertial || fades[k].curve == Curve::inertial;
    // With an inertial fade, the fades before it continue as additive layers too.
    for (uint32_t k = 0; k < fade_count; ++k)
        sum += fades[k].curve == Curve::inertial ? inertial_weight : inertial ? 1.0f : 0.0f;
    for (uint32_t k = 0; k < layer_count; ++k)
        if (layers[k].additive) sum += std::fabs(layers[k].weight);
    return sum;
}

MaskOf checked_mask(const model::Template &tmpl, Array<float> &&weights)
{
    if (weights.size() != tmpl.rig.node_count())
        base::fail(CLQ_ARGUMENT, "a mask of %zu nodes for template '%s', which has %u", weights.size(),
                   tmpl.name.c_str(), tmpl.rig.node_count());
    for (const float weight : weights)
        if (!(weight >= 0 && weight <= 1))
            base::fail(CLQ_ARGUMENT, "a mask's weight is %g: 0 to 1 is wanted", static_cast<double>(weight));
    const std::pmr::polymorphic_allocator<Array<float>> allocator(weights.get_allocator().resource());
    MaskOf mask;
    mask.tmpl = &tmpl;
    mask.weights = std::allocate_shared<Array<float>>(allocator, std::move(weights));
    return mask;
}

uint32_t Layers::add(Gait &&gait)
{
    base::reserve_more(gaits_);
    gaits_.push_back(std::move(gait));
    return gait_count() - 1;
}

uint32_t Layers::add(MaskOf &&mask)
{
    base::reserve_more(masks_);
    masks_.push_back(std::move(mask));
    return mask_count() - 1;
}

void Layers::reserve_row() { base::reserve_more(of_); }

void Layers::clear_row(uint32_t row) noexcept
{
    if (of_[row] != none) slots_.free(of_[row]);
    of_[row] = none;
}

LayerState &Layers::make(uint32_t row)
{
    if (of_[row] == none) {
        slots_.reserve();
        of_[row] = slots_.take();
    }
    return slots_[of_[row]];
}

void Layers::release_if_plain(uint32_t row) noexcept
{
    if (of_[row] != none && slots_[of_[row]].is_plain()) clear_row(row);
}

void Layers::reserve_copy(uint32_t from)
{
    if (of_[from] != none) slots_.reserve();
}

void Layers::copy_row(uint32_t from, uint32_t to) noexcept
{
    if (of_[from] == none) return;
    of_[to] = slots_.take();
    slots_[of_[to]] = slots_[of_[from]];
}

uint64_t Layers::bytes() const
{
    uint64_t sum = gaits_.capacity() * sizeof(Gait) + masks_.capacity() * sizeof(MaskOf) + slots_.bytes() +
                   of_.capacity() * sizeof(uint32_t);
    for (const MaskOf &mask : masks_) sum += mask.weights->size() * sizeof(float);
    return sum;
}

}  // namespace claque::crowd
