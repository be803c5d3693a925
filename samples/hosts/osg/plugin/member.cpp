#include "samples/hosts/osg/plugin/member.h"

#include "lib/base/near_names.h"
#include "samples/io/files.h"
#include "samples/scenes/random.h"

namespace osg_plugin
{
namespace
{

using scenes::check;

std::string name_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    return info.name;
}

// Samples once, so that a class that does not fit the template is refused while the description is read.
void try_class(const clq_colour_map *map, uint32_t colour_class, const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    std::vector<float> rgb(3 * size_t(info.zone_count));
    clq_colour_sample_def def = clq_colour_sample_def_init();
    def.colour_class = colour_class, def.tmpl = tmpl;
    check(clq_colour_map_sample(map, &def, rgb.data(), info.zone_count));
}

std::vector<std::string> classes_of(const clq_colour_map *map)
{
    clq_colour_map_def def = clq_colour_map_def_init();
    check(clq_colour_map_get_def(map, &def));
    std::vector<std::string> names;
    for (uint32_t i = 0; i < def.class_count; ++i) names.emplace_back(def.classes[i].name);
    return names;
}

}  // namespace

Member::Member(scenes::Library &library, const PersonFile &file)
    : cast_(scenes::walkers::cast(library, file.looks, scenes::Lod::on))
{
    const scenes::walkers::GaitClips clips = scenes::walkers::gait_clips(cast_);
    clq_locomotion_info locomotion = clq_locomotion_info_init();
    check(clq_locomotion_get_info(cast_.locomotion.get(), &locomotion));
    const bool runs = file.gait == Gait::run;
    if (runs && clips.run == CLQ_NONE)
        throw scenes::Failure(file.looks.at + ": the character " + file.looks.character + " has no clip named run");
    clip_ = runs ? clips.run : clips.walk;
    stride_ = static_cast<double>(runs ? locomotion.run_stride : locomotion.walk_stride);
    idles_ = clips.idles;
    clq_clip_info clip = clq_clip_info_init();
    check(clq_template_get_clip(tmpl(), clip_, &clip));
    clip_s_ = static_cast<double>(clip.duration_s);
    ranges_ = scenes::ranges_of(tmpl(), file.looks);
    if (file.colours.empty()) return;
    scenes::asked_at(file.colours_at, [&] {
        std::string text;
        const std::string wrong = io::read_whole(file.colours, text);
        if (!wrong.empty()) throw scenes::Failure(wrong);
        map_ = scenes::read_colours(library, text, file.colours);
        colour_class_ = file.colour_class.empty() ? clq_colour_map_find_template(map_.get(), name_of(tmpl()).c_str())
                                                  : clq_colour_map_find(map_.get(), file.colour_class.c_str());
        const bool named = !file.colour_class.empty();
        if (colour_class_ == CLQ_NONE)
            throw scenes::Failure(file.colours + " has no class " +
                                  (named ? "named " + file.colour_class : "for the template " + name_of(tmpl())) +
                                  claque::base::names_near(file.colour_class, classes_of(map_.get())));
        try_class(map_.get(), colour_class_, tmpl());
    });
}

clq_play Member::gait_at(double phase) const
{
    clq_play play = clq_play_init();
    play.clip = clip_;
    play.speed = 0;
    play.phase_s = static_cast<float>(phase * clip_s_);
    return play;
}

clq_play Member::idle(uint64_t seed) const
{
    clq_play play = clq_play_init();
    if (idles_.empty()) return play;
    play.clip = idles_[scenes::random_bits(seed, 0, scenes::Purpose::clip) % idles_.size()];
    clq_clip_info clip = clq_clip_info_init();
    check(clq_template_get_clip(tmpl(), play.clip, &clip));
    play.phase_s = static_cast<float>(scenes::random_unit(seed, 0, scenes::Purpose::phase)) * clip.duration_s;
    return play;
}

void Member::colour(clq_crowd *crowd, clq_actor actor) const
{
    if (map_) check(clq_crowd_randomise_colours(crowd, map_.get(), colour_class_, &actor, 1));
    else check(clq_actor_randomise_colours(crowd, actor, ranges_.data(), static_cast<uint32_t>(ranges_.size())));
}

}  // namespace osg_plugin
