#include "lib/stage/machine/cast.h"

#include <claque/template_info.h>

#include "lib/base/near_names.h"
#include "lib/stage/error.h"

namespace claque::stage
{

namespace
{

void must(clq_status status)
{
    if (status != CLQ_OK) throw Error(status, clq_last_error());
}

// Their names live as long as the template.
std::vector<std::string_view> clips_of(const clq_template *tmpl)
{
    std::vector<std::string_view> all;
    clq_clip_info info = clq_clip_info_init();
    while (clq_template_get_clip(tmpl, static_cast<uint32_t>(all.size()), &info) == CLQ_OK) all.emplace_back(info.name);
    return all;
}

std::vector<std::string_view> markers_of(const clq_template *tmpl)
{
    std::vector<std::string_view> all;
    clq_marker_info info = clq_marker_info_init();
    while (clq_template_get_marker(tmpl, static_cast<uint32_t>(all.size()), &info) == CLQ_OK)
        all.emplace_back(info.name);
    return all;
}

std::vector<std::string_view> nodes_of(const clq_template *tmpl)
{
    std::vector<std::string_view> all;
    clq_template_info info = clq_template_info_init();
    must(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.node_count; ++i) all.emplace_back(clq_template_get_node_name(tmpl, i));
    return all;
}

void find_clips(const Machine &machine, const Document &document, const MachineReader &reader, const char *of,
                Cast &out)
{
    for (size_t i = 0; i < machine.clip_names.size(); ++i) {
        const std::string &name = machine.clip_names[i];
        const uint32_t clip = clq_template_find_clip(out.tmpl, name.c_str());
        if (clip == CLQ_NONE)
            document.refuse(*reader.clip_nodes[i], "the template '" + std::string(of) + "' has no clip '" + name + "'" +
                                                       base::names_near(name, clips_of(out.tmpl)));
        clq_clip_info info = clq_clip_info_init();
        must(clq_template_get_clip(out.tmpl, clip, &info));
        out.clips.push_back(clip);
        out.durations_s.push_back(static_cast<double>(info.duration_s));
    }
}

void find_markers(const Machine &machine, uint32_t count, Cast &out)
{
    for (uint32_t i = 0; i < count; ++i) {
        clq_marker_info info = clq_marker_info_init();
        must(clq_template_get_marker(out.tmpl, i, &info));
        for (size_t clip = 0; clip < out.clips.size(); ++clip)
            for (size_t marker = 0; marker < machine.marker_names.size(); ++marker) {
                if (out.clips[clip] != info.clip || machine.marker_names[marker] != info.name) continue;
                clq_clip_info of = clq_clip_info_init();
                must(clq_template_get_clip(out.tmpl, info.clip, &of));
                out.markers.push_back({static_cast<uint32_t>(clip), static_cast<uint32_t>(marker),
                                       static_cast<double>(info.time_s) - static_cast<double>(of.start_s)});
            }
    }
}

}  // namespace

Cast find_parts(const CastDef &def, const Machine &machine, const Document &document, const MachineReader &reader)
{
    Cast out;
    out.tmpl = def.tmpl;
    out.locomotion = def.locomotion;
    clq_template_info info = clq_template_info_init();
    must(clq_template_get_info(def.tmpl, &info));
    find_clips(machine, document, reader, info.name, out);
    find_markers(machine, info.marker_count, out);
    for (size_t i = 0; i < machine.marker_names.size(); ++i) {
        bool found = false;
        for (const MarkerTime &one : out.markers) found |= one.marker == i;
        if (!found)
            document.refuse(*reader.marker_nodes[i],
                            "no clip that the machine plays has a marker '" + machine.marker_names[i] +
                                "' in the template '" + std::string(info.name) + "'" +
                                base::names_near(machine.marker_names[i], markers_of(def.tmpl)));
    }
    for (size_t i = 0; i < machine.masks.size(); ++i)
        for (size_t k = 0; k < machine.masks[i].nodes.size(); ++k)
            if (clq_template_find_node(def.tmpl, machine.masks[i].nodes[k].c_str()) == CLQ_NONE)
                document.refuse(*reader.mask_nodes[i][k],
                                "the template '" + std::string(info.name) + "' has no node '" +
                                    machine.masks[i].nodes[k] + "'" +
                                    base::names_near(machine.masks[i].nodes[k], nodes_of(def.tmpl)));
    return out;
}

}  // namespace claque::stage
