// Restores gaits, masks, and the fades and layers of actors.
#include "lib/crowd/descriptions.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/gait.h"
#include "lib/crowd/layer_rules.h"
#include "lib/crowd/restore.h"

namespace claque::crowd
{

using base::fail;

void read_gait(Reader &in, Tables &out)
{
    Gait gait(out.layers.memory());
    uint32_t tmpl = 0;
    in.value(tmpl);
    gait.tmpl = template_at(out, tmpl);
    walk_gait(in, gait);
    check_gait(gait);
    out.layers.add(std::move(gait));
}

void read_mask(Reader &in, Tables &out)
{
    uint32_t tmpl = 0;
    in.value(tmpl);
    Array<float> weights(out.layers.memory());
    in.array(weights, 4, [&](float &weight) { in.value(weight); });
    out.layers.add(checked_mask(*template_at(out, tmpl), std::move(weights)));
}

void read_layers(Reader &in, Tables &out)
{
    const uint32_t gaits = in.count(20);
    for (uint32_t i = 0; i < gaits; ++i) read_gait(in, out);
    const uint32_t masks = in.count(8);
    for (uint32_t i = 0; i < masks; ++i) read_mask(in, out);
    in.value(out.layers.last_layer_id);
}

void read_layer_state(Reader &in, Crowd &out, uint32_t row)
{
    bool watched = false, some = false;
    in.flag(watched), in.flag(some);
    set_watched(out.tables.actors, row, watched);
    if (!some) return;
    LayerState read;
    uint8_t fades = 0, layers = 0;
    walk_source(in, read.now);
    in.value(fades), in.value(layers);
    if (fades > max_fades || layers > max_layers)
        fail(CLQ_FORMAT, "a saved crowd's actor %u has %u fades and %u layers", row, fades, layers);
    read.fade_count = fades, read.layer_count = layers;
    for (uint32_t k = 0; k < fades; ++k) walk_fade(in, read.fades[k]);
    for (uint32_t k = 0; k < layers; ++k) walk_layer(in, read.layers[k]);
    if (read.is_plain()) fail(CLQ_FORMAT, "a saved crowd's actor %u blends one clip alone", row);
    const Play &own = out.play_of(row), &now = read.now.play;
    if (now.clip != own.clip || now.start_s != own.start_s || now.speed != own.speed || now.phase_s != own.phase_s)
        fail(CLQ_FORMAT, "a saved crowd's actor %u fades to what it does not play", row);
    check_layering(out, row, read);
    change(out, row, read);
}

}  // namespace claque::crowd
