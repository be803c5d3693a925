#include "samples/scenes/template_names.h"

namespace scenes
{

std::vector<std::string> names_of_clips(const clq_template *tmpl)
{
    std::vector<std::string> names;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        check(clq_template_get_clip(tmpl, i, &clip));
        names.emplace_back(clip.name);
    }
    return names;
}

std::vector<std::string> names_of_nodes(const clq_template *tmpl)
{
    std::vector<std::string> names;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.node_count; ++i) names.emplace_back(clq_template_get_node_name(tmpl, i));
    return names;
}

std::vector<std::string> names_of_texture_sets(const clq_template *tmpl)
{
    std::vector<std::string> names;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 1; i < info.texture_set_count; ++i)  // the materials' own has no name
        names.emplace_back(clq_template_get_texture_set_name(tmpl, i));
    return names;
}

std::vector<std::string> names_of_dofs(const clq_template *tmpl)
{
    std::vector<std::string> names;
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.dof_count; ++i) {
        clq_dof_info dof = clq_dof_info_init();
        check(clq_template_get_dof(tmpl, i, &dof));
        names.emplace_back(dof.name);
    }
    return names;
}

std::string lower_case(std::string name)
{
    for (char &letter : name)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return name;
}

uint32_t standing_clip(const clq_template *tmpl)
{
    const uint32_t stand = clq_template_find_clip(tmpl, "stand");
    if (stand != CLQ_NONE) return stand;
    std::vector<std::string> names = names_of_clips(tmpl);
    for (std::string &name : names) name = lower_case(name);
    for (const char *word : {"idle", "stand"})
        for (size_t i = 0; i < names.size(); ++i)
            if (names[i].find(word) != std::string::npos) return static_cast<uint32_t>(i);
    return CLQ_NONE;
}

}  // namespace scenes
