#include "lib/crowd/save.h"

#include "lib/crowd/descriptions.h"
#include "lib/crowd/save_rows.h"

namespace claque::crowd
{

namespace
{

void write_templates(Writer &out, const Tables &tables)
{
    out.count(tables.templates.size());
    for (const model::Template *tmpl : tables.templates) {
        out.text(tmpl->name);
        out.value(structure_hash(*tmpl));
    }
}

uint32_t number_of(const Tables &tables, const model::Template *tmpl)
{
    uint32_t i = 0;
    while (i < tables.templates.size() && tables.templates[i] != tmpl) ++i;
    return i;
}

void write_behaviours(Writer &out, const Tables &tables)
{
    out.count(tables.behaviours.mechanism_count());
    for (uint32_t i = 0; i < tables.behaviours.mechanism_count(); ++i) write_mechanism(out, tables, i);
    out.count(tables.behaviours.path_count());
    for (uint32_t i = 0; i < tables.behaviours.path_count(); ++i) write_path(out, tables, i);
}

void write_layers(Writer &out, const Tables &tables)
{
    out.count(tables.layers.gait_count());
    for (uint32_t i = 0; i < tables.layers.gait_count(); ++i) write_gait(out, tables, i);
    out.count(tables.layers.mask_count());
    for (uint32_t i = 0; i < tables.layers.mask_count(); ++i) write_mask(out, tables, i);
    out.value(tables.layers.last_layer_id);
}

}  // namespace

void write_mechanism(Writer &out, const Tables &tables, uint32_t index)
{
    const Mechanism &m = tables.behaviours.mechanism(index);
    out.value(static_cast<uint8_t>(m.kind.index()));
    out.value(number_of(tables, m.tmpl));
    walk_levels(out, m);
    std::visit([&](const auto &kind) { walk_kind(out, kind); }, m.kind);
}

void write_path(Writer &out, const Tables &tables, uint32_t index) { walk_path(out, tables.behaviours.path(index)); }

void write_gait(Writer &out, const Tables &tables, uint32_t index)
{
    out.value(number_of(tables, tables.layers.gait(index).tmpl));
    walk_gait(out, tables.layers.gait(index));
}

void write_mask(Writer &out, const Tables &tables, uint32_t index)
{
    out.value(number_of(tables, tables.layers.mask(index).tmpl));
    out.array(*tables.layers.mask(index).weights, 4, [&](float weight) { out.value(weight); });
}

void save_contents(const Crowd &crowd, base::Sink &sink)
{
    const Tables &tables = crowd.tables;
    Writer out(sink);
    out.value(tables.seed);
    write_templates(out, tables);
    write_behaviours(out, tables);
    write_layers(out, tables);
    write_rows(out, tables.groups.all, [&](uint32_t row) {
        walk_transform(out, tables.groups.all[row].transform);
        out.flag(tables.groups.all[row].enabled), out.value(tables.groups.all[row].speed);
    });
    write_rows(out, tables.actors.all, [&](uint32_t row) { write_actor(out, crowd, row); });
    write_rows(out, tables.extras.attached, [&](uint32_t row) { walk_attached(out, tables.extras.attached[row]); });
    out.flush();
}

void save(const Crowd &crowd, base::Sink &sink)
{
    base::HashingSink measure;
    save_contents(crowd, measure);
    const auto header = base::file_header(save_form, measure.size, measure.hash);
    sink.take(header.data(), header.size());
    save_contents(crowd, sink);
}

}  // namespace claque::crowd
