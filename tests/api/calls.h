// Calls of the C API that take a struct, in one line for tests.
#pragma once

#include <claque/claque.h>

namespace api_test
{

inline clq_status look_at(clq_camera *out, const double (&eye)[3], const double (&target)[3], const float (&up)[3],
                          float fov_y_rad, float aspect, float z_near, float z_far)
{
    clq_look_at_def def = clq_look_at_def_init();
    for (int k = 0; k < 3; ++k) def.eye[k] = eye[k], def.target[k] = target[k], def.up[k] = up[k];
    def.fov_y_rad = fov_y_rad, def.aspect = aspect, def.z_near = z_near, def.z_far = z_far;
    return clq_camera_look_at(&def, out);
}

inline clq_status fade_to(clq_crowd *crowd, clq_actor actor, clq_fade_def def, double at_s, float length_s,
                          clq_curve curve)
{
    def.at_s = at_s, def.length_s = length_s, def.curve = curve;
    return clq_actor_fade_to(crowd, actor, &def);
}

inline clq_status attach(clq_crowd *crowd, clq_actor actor, uint32_t node, const float (&centre)[3], float radius,
                         clq_attachment *out)
{
    clq_attachment_def def = clq_attachment_def_init();
    def.node = node, def.radius = radius;
    for (int k = 0; k < 3; ++k) def.centre[k] = centre[k];
    return clq_actor_attach(crowd, actor, &def, out);
}

inline clq_status sample_play(clq_crowd *crowd, clq_actor actor, clq_random_play_def def, uint32_t sample_index,
                              double start_s, clq_play *out)
{
    def.sample_index = sample_index, def.start_s = start_s;
    return clq_actor_sample_play(crowd, actor, &def, out);
}

inline clq_status get_events(clq_crowd *crowd, double from_s, double to_s, clq_event *out, size_t capacity,
                             size_t *out_count)
{
    const clq_time_range range = {from_s, to_s};
    return clq_crowd_get_events(crowd, &range, out, capacity, out_count);
}

inline clq_status sample_colours(const clq_colour_map *map, uint32_t colour_class, const clq_template *tmpl,
                                 uint64_t crowd_seed, uint64_t actor_seed, float *out_rgb, uint32_t zone_count)
{
    clq_colour_sample_def def = clq_colour_sample_def_init();
    def.colour_class = colour_class, def.tmpl = tmpl;
    def.crowd_seed = crowd_seed, def.actor_seed = actor_seed;
    return clq_colour_map_sample(map, &def, out_rgb, zone_count);
}

inline clq_status get_texture(const clq_template *tmpl, uint32_t set, uint32_t texture, uint8_t *rgb, uint32_t *zones,
                              size_t capacity, uint32_t *out_width_px, uint32_t *out_height_px)
{
    clq_texels texels = clq_texels_init();
    texels.rgb = rgb, texels.zones = zones, texels.capacity = capacity;
    const clq_status status = clq_template_get_texture(tmpl, set, texture, &texels);
    if (status == CLQ_OK) *out_width_px = texels.width_px, *out_height_px = texels.height_px;
    return status;
}

inline clq_status get_split_picture(const clq_template *tmpl, uint32_t texture, uint32_t scale, uint8_t *rgb,
                                    size_t capacity_bytes, uint32_t *out_width_px, uint32_t *out_height_px)
{
    clq_picture picture = clq_picture_init();
    picture.pixels = rgb, picture.capacity_bytes = capacity_bytes;
    const clq_status status = clq_template_get_split_picture(tmpl, texture, scale, &picture);
    if (status == CLQ_OK) *out_width_px = picture.width_px, *out_height_px = picture.height_px;
    return status;
}

inline clq_status get_influences(const clq_template *tmpl, uint32_t level, uint32_t per_vertex, uint16_t *joints,
                                 float *weights, size_t capacity)
{
    clq_influences influences = clq_influences_init();
    influences.per_vertex = per_vertex, influences.joints = joints, influences.weights = weights;
    influences.capacity = capacity;
    return clq_template_get_influences(tmpl, level, &influences);
}

}  // namespace api_test
