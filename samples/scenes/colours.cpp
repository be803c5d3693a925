#include "samples/scenes/colours.h"

#include "samples/io/files.h"
#include "samples/scenes/social_classes.h"

namespace scenes
{
namespace
{

struct Group {
    uint32_t colour_class;
    const clq_template *tmpl;
    std::vector<clq_actor> actors;
};

clq_template_info info_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    return info;
}

// One group for all individuals of one class and one template.
std::vector<Group> groups_of(const Scene &scene, const clq_colour_map *map)
{
    std::vector<Group> groups;
    const SocialClasses *social = dynamic_cast<const SocialClasses *>(&scene);
    const std::vector<clq_actor> actors = scene.actors();
    for (size_t person = 0; person < actors.size(); ++person) {
        clq_actor_info actor = clq_actor_info_init();
        check(clq_actor_get_info(scene.crowd(), actors[person], &actor));
        const uint32_t own =
            class_for(map, social ? social->class_of(person) : std::string(), info_of(actor.tmpl).name);
        if (own == CLQ_NONE) continue;
        size_t i = 0;
        while (i < groups.size() && (groups[i].colour_class != own || groups[i].tmpl != actor.tmpl)) ++i;
        if (i == groups.size()) groups.push_back({own, actor.tmpl, {}});
        groups[i].actors.push_back(actors[person]);
    }
    return groups;
}

}  // namespace

ColourMap read_colours(Library &library, const std::string &toml, const std::string &where)
{
    clq_colour_map *map = nullptr;
    check(clq_colour_map_load(library.context(), toml.data(), toml.size(), where.c_str(), &map));
    return ColourMap(map);
}

uint32_t class_for(const clq_colour_map *map, const std::string &called, const char *template_name)
{
    const uint32_t by_name = called.empty() ? CLQ_NONE : clq_colour_map_find(map, called.c_str());
    return by_name != CLQ_NONE ? by_name : clq_colour_map_find_template(map, template_name);
}

void colour(const Scene &scene, const clq_colour_map *map, uint64_t crowd_seed)
{
    const std::vector<Group> groups = groups_of(scene, map);
    if (groups.empty())
        throw Failure("no individual in the scene is of the classes and templates that the colours are for");
    for (const Group &group : groups) {  // all groups are checked before any individual is changed
        std::vector<float> rgb(3 * static_cast<size_t>(info_of(group.tmpl).zone_count));
        clq_colour_sample_def def = clq_colour_sample_def_init();
        def.colour_class = group.colour_class, def.tmpl = group.tmpl;
        def.crowd_seed = crowd_seed;
        check(clq_colour_map_sample(map, &def, rgb.data(), static_cast<uint32_t>(rgb.size() / 3)));
    }
    for (const Group &group : groups)
        check(clq_crowd_randomise_colours(scene.crowd(), map, group.colour_class, group.actors.data(),
                                          static_cast<uint32_t>(group.actors.size())));
}

ColourFile::ColourFile(Library &library, std::string path) : library_(library), path_(std::move(path)) {}

bool ColourFile::apply(const Scene &scene, uint64_t crowd_seed)
{
    std::string text;
    const std::string wrong = io::read_whole(path_, text);
    // A file that is being replaced may be absent or empty for a moment.
    if (!wrong.empty()) {
        if (read_) return false;
        throw Failure(wrong);
    }
    if (read_ && (text.empty() || text == last_)) return false;
    read_ = true;
    last_ = std::move(text);
    colour(scene, read_colours(library_, last_, path_).get(), crowd_seed);
    return true;
}

}  // namespace scenes
