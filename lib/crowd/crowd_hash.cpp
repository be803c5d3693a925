// Hashes of whole states: of a crowd, and of the properties of a template that a crowd depends on.
#include "lib/crowd/save.h"

namespace claque::crowd
{

uint64_t Crowd::hash() const
{
    base::HashingSink measure;
    save_contents(*this, measure);
    return measure.hash;
}

uint64_t structure_hash(const model::Template &tmpl)
{
    base::HashingSink measure;
    Writer out(measure);
    const auto name = [&](const auto &text) { out.text(text); };
    const model::Rig &rig = tmpl.rig;
    out.array(rig.parents, 4, [&](uint32_t parent) { out.value(parent); });
    out.array(rig.node_names, 4, name);
    out.array(rig.clip_names, 4, name);
    out.array(rig.clips, 12, [&](const model::Clip &clip) {
        out.value(clip.start_s), out.value(clip.duration_s), out.value(clip.channel_count);
    });
    out.array(rig.dof_names, 4, name);
    out.array(rig.dofs, 33, [&](const model::Dof &dof) {
        out.value(dof.node), out.value(dof.kind), out.value(dof.morph_target);
        for (int k = 0; k < 3; ++k) out.value(dof.axis[k]);
        out.value(dof.min), out.value(dof.max), out.value(dof.rest);
    });
    out.array(tmpl.zone_names, 4, name);
    out.array(tmpl.levels, 16, [&](const model::Level &level) {
        out.value(level.switch_distance_m), out.value(level.skeletal_level);
        out.value(level.vertex_count), out.count(level.indices.size());
    });
    out.array(tmpl.textures, 8,
              [&](const model::Texture &texture) { out.value(texture.width), out.value(texture.height); });
    out.array(tmpl.texture_sets, 4, name);
    for (int k = 0; k < 3; ++k) out.value(tmpl.sklsroot.centre[k]);
    out.value(tmpl.sklsroot.radius);
    out.flush();
    return measure.hash;
}

}  // namespace claque::crowd
