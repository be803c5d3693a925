#include "samples/cli/blend_rows.h"

#include <cmath>
#include <cstdio>

#include "lib/base/near_names.h"
#include "samples/scenes/template_names.h"

namespace cli
{

using scenes::check;

namespace
{

struct NamedClip {
    uint32_t clip = CLQ_NONE;
    double length_s = 0;
    std::string name;
};

NamedClip clip_named(const clq_template *tmpl, const std::string &name)
{
    NamedClip out;
    out.name = name;
    out.clip = clq_template_find_clip(tmpl, name.c_str());
    clq_clip_info info = clq_clip_info_init();
    if (out.clip != CLQ_NONE) {
        check(clq_template_get_clip(tmpl, out.clip, &info));
        out.length_s = static_cast<double>(info.duration_s);
        return out;
    }
    throw scenes::Failure("no clip is called '" + name + "'" +
                          claque::base::names_near(name, scenes::names_of_clips(tmpl)));
}

clq_play play_of(const NamedClip &clip, double start_s)
{
    clq_play play = {};
    play.clip = clip.clip;
    play.start_s = start_s;
    play.speed = 1;
    return play;
}

std::vector<double> evenly(double from_s, double to_s, uint32_t count)
{
    std::vector<double> times;
    for (uint32_t i = 0; i < count; ++i) times.push_back(from_s + (to_s - from_s) * i / (count - 1));
    return times;
}

std::string seconds(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g s", value);
    return text;
}

BlendRow fade_row(const NamedClip &from, const NamedClip &to, clq_curve curve, const char *label,
                  const BlendOptions &options)
{
    // Starts in the middle of a movement, so that the clip before the fade is seen to go on.
    const double at_s = from.length_s * 0.4, length_s = options.length_s;
    BlendRow row;
    row.label = label;
    row.about = from.name + " to " + to.name + " within " + seconds(length_s);
    row.times_s = evenly(at_s, at_s + length_s, options.phases);
    row.command = [=](clq_crowd *crowd, clq_actor actor) {
        const clq_play play = play_of(from, 0);
        check(clq_actor_play(crowd, actor, &play));
        clq_fade_def fade = clq_fade_def_init();
        fade.play = play_of(to, at_s);
        fade.at_s = at_s, fade.length_s = static_cast<float>(length_s), fade.curve = curve;
        check(clq_actor_fade_to(crowd, actor, &fade));
    };
    return row;
}

BlendRow layer_row(const clq_template *tmpl, const NamedClip &over, const NamedClip &layer, clq_layer_kind kind,
                   const BlendOptions &options)
{
    // The layer fades in until its middle, where the strip ends.
    const double fade_s = layer.length_s * 0.35, last_s = layer.length_s * 0.5;
    BlendRow row;
    row.label = kind == CLQ_LAYER_ADD ? "added" : "masked";
    row.about = layer.name + (kind == CLQ_LAYER_ADD ? " added to " : " over ") + over.name + " from " + options.node +
                " on within " + seconds(fade_s);
    row.times_s = evenly(0, last_s, options.phases);
    row.command = [=](clq_crowd *crowd, clq_actor actor) {
        const clq_play play = play_of(over, 0);
        check(clq_actor_play(crowd, actor, &play));
        const char *node = options.node.c_str();
        clq_mask_def mask = clq_mask_def_init();
        mask.tmpl = tmpl;
        mask.nodes = &node;
        mask.node_count = 1;
        mask.feather = 1;
        clq_layer_def def = clq_layer_def_init();
        check(clq_crowd_add_mask(crowd, &mask, &def.mask));
        def.kind = kind;
        def.play = play_of(layer, 0);
        def.fade_in_s = static_cast<float>(fade_s);
        check(clq_actor_add_layer(crowd, actor, &def, nullptr));
    };
    return row;
}

BlendRow gait_row(const clq_template *tmpl, const NamedClip &a, const NamedClip &b, const BlendOptions &options)
{
    const double length_s = a.length_s + b.length_s;  // about two cycles
    BlendRow row;
    row.label = "in step";
    row.about =
        a.name + " and " + b.name + " in step - share of " + b.name + " from 0 to 1 within " + seconds(length_s);
    row.from_the_side = true;
    row.times_s = evenly(0, length_s, options.phases);
    row.command = [=](clq_crowd *crowd, clq_actor actor) {
        clq_gait_def def = clq_gait_def_init();
        def.tmpl = tmpl;
        def.clip_a = a.clip, def.clip_b = b.clip;
        clq_fade_def fade = clq_fade_def_init();
        check(clq_crowd_add_gait(crowd, &def, &fade.gait));
        fade.play = play_of(a, -a.length_s);  // one loop before the strip begins
        fade.at_s = -a.length_s, fade.length_s = 0;
        check(clq_actor_fade_to(crowd, actor, &fade));
        check(clq_actor_set_gait_share(crowd, actor, 1, 0, static_cast<float>(length_s)));
    };
    return row;
}

}  // namespace

std::vector<BlendRow> blend_rows(const clq_template *tmpl, const BlendOptions &options)
{
    const NamedClip from = clip_named(tmpl, options.fade[0]), to = clip_named(tmpl, options.fade[1]);
    const NamedClip over = clip_named(tmpl, options.over);
    std::vector<BlendRow> rows;
    rows.push_back(fade_row(from, to, CLQ_CURVE_LINEAR, "linear", options));
    rows.push_back(fade_row(from, to, CLQ_CURVE_SMOOTH, "smooth", options));
    rows.push_back(fade_row(from, to, CLQ_CURVE_INERTIAL, "inertial", options));
    rows.push_back(layer_row(tmpl, over, clip_named(tmpl, options.layer), CLQ_LAYER_REPLACE, options));
    rows.push_back(layer_row(tmpl, over, clip_named(tmpl, options.added), CLQ_LAYER_ADD, options));
    rows.push_back(gait_row(tmpl, clip_named(tmpl, options.gaits[0]), clip_named(tmpl, options.gaits[1]), options));
    return rows;
}

double fastest_node(scenes::Library &library, clq_template *tmpl, const BlendRow &row)
{
    constexpr double step_s = 0.002;
    scenes::CrowdOptions crowd_options;
    crowd_options.count = 1;
    scenes::SceneCrowd cast(library, crowd_options);
    cast.enter({tmpl, scenes::stand(0, 0, 0, 0, 1, 1), {CLQ_NONE, 0, 0, 0}});
    row.command(cast.crowd(), cast.actors()[0]);
    double fastest = 0;
    const uint32_t nodes = info_of(tmpl).node_count;
    for (uint32_t node = 0; node < nodes; ++node) {
        double before[16] = {}, now[16] = {};
        // Includes a margin before and after, because poses jump at ends.
        for (double t = row.times_s.front() - 0.05; t < row.times_s.back() + 0.05; t += step_s) {
            check(clq_actor_get_node(cast.crowd(), cast.actors()[0], node, t, now));
            const double speed = std::hypot(now[12] - before[12], now[13] - before[13], now[14] - before[14]) / step_s;
            if (t >= row.times_s.front() - 0.05 + step_s / 2) fastest = std::max(fastest, speed);
            std::copy(now, now + 16, before);
        }
    }
    return fastest;
}

}  // namespace cli
