#include "lib/crowd/save.h"

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
    const Behaviours &from = tables.behaviours;
    out.count(from.mechanism_count());
    for (uint32_t i = 0; i < from.mechanism_count(); ++i) {
        const Mechanism &m = from.mechanism(i);
        out.value(static_cast<uint8_t>(m.kind.index()));
        out.value(number_of(tables, m.tmpl));
        walk_levels(out, m);
        std::visit([&](const auto &kind) { walk_kind(out, kind); }, m.kind);
    }
    out.count(from.path_count());
    for (uint32_t i = 0; i < from.path_count(); ++i) walk_path(out, from.path(i));
}

void write_layers(Writer &out, const Tables &tables)
{
    const Layers &from = tables.layers;
    out.count(from.gait_count());
    for (uint32_t i = 0; i < from.gait_count(); ++i) {
        out.value(number_of(tables, from.gait(i).tmpl));
        walk_gait(out, from.gait(i));
    }
    out.count(from.mask_count());
    for (uint32_t i = 0; i < from.mask_count(); ++i) {
        out.value(number_of(tables, from.mask(i).tmpl));
        out.array(*from.mask(i).weights, 4, [&](float weight) { out.value(weight); });
    }
    out.value(from.last_layer_id);
}

}  // namespace

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
        out.flag(tables.groups.all[row].enabled);
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
