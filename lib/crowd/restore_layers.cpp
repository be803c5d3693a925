// Gaits, masks and what actors blend, from the bytes of a saved crowd.
#include "lib/crowd/gait.h"
#include "lib/crowd/save_check.h"
#include "lib/crowd/save_fields.h"

namespace claque::crowd
{

using base::fail;

void read_layers(Reader &in, const std::function<const model::Template *(uint32_t)> &template_at, Layers &out)
{
    std::pmr::memory_resource *memory = out.memory();
    const uint32_t gaits = in.count(20);
    for (uint32_t i = 0; i < gaits; ++i) {
        Gait gait(memory);
        uint32_t tmpl = 0;
        in.value(tmpl);
        gait.tmpl = template_at(tmpl);
        walk_gait(in, gait);
        check_gait(gait);
        out.add(std::move(gait));
    }
    const uint32_t masks = in.count(8);
    for (uint32_t i = 0; i < masks; ++i) {
        uint32_t tmpl = 0;
        in.value(tmpl);
        Array<float> weights(memory);
        in.array(weights, 4, [&](float &weight) { in.value(weight); });
        out.add(checked_mask(*template_at(tmpl), std::move(weights)));
    }
    in.value(out.last_layer_id);
}

bool read_layer_state(Reader &in, uint32_t row, LayerState &out)
{
    bool some = false;
    in.flag(some);
    if (!some) return false;
    uint8_t fades = 0, layers = 0;
    walk_source(in, out.now);
    in.value(fades), in.value(layers);
    if (fades > max_fades || layers > max_layers)
        fail(CLQ_FORMAT, "a saved crowd's actor %u has %u fades and %u layers", row, fades, layers);
    out.fade_count = fades, out.layer_count = layers;
    for (uint32_t k = 0; k < fades; ++k) walk_fade(in, out.fades[k]);
    for (uint32_t k = 0; k < layers; ++k) walk_layer(in, out.layers[k]);
    if (out.is_plain()) fail(CLQ_FORMAT, "a saved crowd's actor %u blends one clip alone", row);
    return true;
}

}  // namespace claque::crowd
