/* A C99 host, compiled against the first released headers (tests/abi/v1), runs with the present library. It fills many
 * defs and out structs of that time and prints one hash of all that the library tells it. */
#include <claque/claque.h>

#include <stdio.h>

#if CLQ_VERSION != 200
#error "this host is for the headers in tests/abi/v1"
#endif

enum { ROWS = 5, VERTICES = 2 * ROWS, ACTORS = 12 };

static unsigned long long all = 1469598103934665603u;

static void add(const void *bytes, size_t count)
{
    const unsigned char *p = (const unsigned char *)bytes;
    for (size_t i = 0; i < count; ++i) all = (all ^ p[i]) * 1099511628211u;
}

static void add_number(double number) { add(&number, sizeof number); }

static int failures;

static void check(clq_status status, const char *what)
{
    if (status == CLQ_OK) return;
    fprintf(stderr, "%s: %s: %s\n", what, clq_status_name(status), clq_last_error());
    ++failures;
}

#define CHECK(call) check(call, #call)

/* A ribbon of two joints with a rotation and a translation as degrees of freedom, two zones and two clips. */
static clq_template *ribbon(clq_context *context)
{
    float inverse_binds[2][16] = {{0}}, positions[VERTICES][3], normals[VERTICES][3], uvs[VERTICES][2];
    float weights[VERTICES][2];
    uint32_t joints[VERTICES][2], indices[ROWS - 1][6];
    uint8_t texels[64][4];
    const float times[3] = {0, 0.5f, 1}, turns[3][4] = {{0, 0, 0, 1}, {0.5f, 0, 0, 0.8660254f}, {0, 0, 0, 1}};
    for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 4; ++k) inverse_binds[j][5 * k] = 1;
    inverse_binds[1][13] = -1;
    for (int t = 0; t < 64; ++t) {
        texels[t][0] = texels[t][1] = texels[t][2] = 255;
        texels[t][3] = t % 8 < 4 ? 100 : 200;
    }
    for (int v = 0; v < VERTICES; ++v) {
        const float bent = 0.25f * (float)(v / 2);
        positions[v][0] = v % 2 ? 0.3f : -0.3f, positions[v][1] = 2 * bent, positions[v][2] = 0;
        normals[v][0] = normals[v][1] = 0, normals[v][2] = 1;
        uvs[v][0] = v % 2 ? 0.95f : 0.05f, uvs[v][1] = 0.05f + 0.8f * bent;
        weights[v][0] = 1 - bent, weights[v][1] = bent;
        joints[v][0] = 0, joints[v][1] = 1;
    }
    for (uint32_t row = 0; row + 1 < ROWS; ++row) {
        const uint32_t v = 2 * row;
        indices[row][0] = v, indices[row][1] = v + 1, indices[row][2] = v + 3;
        indices[row][3] = v, indices[row][4] = v + 3, indices[row][5] = v + 2;
    }

    clq_node_def nodes[2] = {clq_node_def_init(), clq_node_def_init()};
    nodes[0].name = "root";
    nodes[1].name = "tip", nodes[1].parent = 0, nodes[1].translation[1] = 1;
    clq_joint_def palette[2] = {clq_joint_def_init(), clq_joint_def_init()};
    palette[0].inverse_bind = inverse_binds[0];
    palette[1].node = 1, palette[1].inverse_bind = inverse_binds[1];
    clq_dof_def dof = clq_dof_def_init();
    dof.name = "nod", dof.node = 1, dof.kind = CLQ_DOF_ROTATION, dof.axis[0] = 1, dof.min = -0.5f, dof.max = 0.5f;
    clq_image_def image = clq_image_def_init();
    image.width_px = image.height_px = 8, image.rgba = texels[0], image.alpha = CLQ_ALPHA_ZONE_KEYS;
    clq_zone_def zones[2] = {clq_zone_def_init(), clq_zone_def_init()};
    zones[0].name = "cloth", zones[0].key = 100, zones[0].range.saturation_min = 0.5f;
    zones[1].name = "skin", zones[1].key = 200, zones[1].range.hue_max_deg = 30;
    clq_material_def material = clq_material_def_init();
    material.image = 0, material.double_sided = true;
    clq_part_def part = clq_part_def_init();
    part.material = 0, part.vertex_count = VERTICES;
    part.positions = positions[0], part.normals = normals[0], part.uvs = uvs[0];
    part.influence_count = 2, part.joints = joints[0], part.weights = weights[0];
    part.index_count = 6 * (ROWS - 1), part.indices = indices[0];
    clq_channel_def channel = clq_channel_def_init();
    channel.node = 1, channel.target = CLQ_CHANNEL_ROTATION;
    channel.key_count = 3, channel.times_s = times, channel.values = turns[0];
    clq_clip_def clips[2] = {clq_clip_def_init(), clq_clip_def_init()};
    clips[0].name = "bend", clips[0].channel_count = 1, clips[0].channels = &channel;
    clips[1].name = "bend again", clips[1].channel_count = 1, clips[1].channels = &channel;
    clq_marker_def marker = clq_marker_def_init();
    marker.name = "bent", marker.time_s = 0.5f;

    clq_template_def def = clq_template_def_init();
    def.name = "ribbon";
    def.node_count = 2, def.nodes = nodes;
    def.joint_count = 2, def.joints = palette;
    def.image_count = 1, def.images = &image;
    def.zone_count = 2, def.zones = zones;
    def.material_count = 1, def.materials = &material;
    def.part_count = 1, def.parts = &part;
    def.clip_count = 2, def.clips = clips;
    def.dof_count = 1, def.dofs = &dof;
    def.marker_count = 1, def.markers = &marker;
    clq_template *tmpl = NULL;
    CHECK(clq_template_build(context, &def, &tmpl));
    return tmpl;
}

static void read_template(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    clq_clip_info clip = clq_clip_info_init();
    clq_marker_info marker = clq_marker_info_init();
    clq_zone_info zone = clq_zone_info_init();
    clq_dof_info dof = clq_dof_info_init();
    clq_level_info level = clq_level_info_init();
    clq_mesh mesh = clq_mesh_init();
    clq_triangles triangles = clq_triangles_init();
    clq_texels texels = clq_texels_init();
    clq_influences influences = clq_influences_init();
    uint16_t joints[4 * VERTICES];
    float weights[4 * VERTICES];
    CHECK(clq_template_get_info(tmpl, &info));
    CHECK(clq_template_get_clip(tmpl, clq_template_find_clip(tmpl, "bend"), &clip));
    CHECK(clq_template_get_marker(tmpl, 0, &marker));
    CHECK(clq_template_get_zone(tmpl, clq_template_find_zone(tmpl, "skin"), &zone));
    CHECK(clq_template_get_dof(tmpl, clq_template_find_dof(tmpl, "nod"), &dof));
    CHECK(clq_template_get_level(tmpl, 0, &level));
    CHECK(clq_template_get_mesh(tmpl, 0, &mesh));
    CHECK(clq_template_get_triangles(tmpl, 0, 0, &triangles));
    CHECK(clq_template_get_texture(tmpl, 0, 0, &texels));
    influences.per_vertex = 4, influences.joints = joints, influences.weights = weights;
    influences.capacity = 4 * VERTICES;
    CHECK(clq_template_get_influences(tmpl, 0, &influences));
    add_number(info.triangle_count), add_number(info.zone_count), add_number((double)info.sklsroot_radius);
    add_number((double)clip.duration_s), add_number((double)marker.time_s), add_number(zone.clean_count);
    add_number((double)dof.max), add_number(level.vertex_count);
    add_number(triangles.double_sided), add_number(texels.width_px);
    add(mesh.positions, 3 * mesh.vertex_count * sizeof(float));
    add(triangles.indices, triangles.index_count * sizeof(uint32_t));
    add(weights, sizeof weights);
}

/* Fills the crowd; actors[0] gets everything that an actor can have. */
static void fill(clq_context *context, clq_crowd *crowd, clq_template *tmpl, clq_actor *actors)
{
    for (int i = 0; i < ACTORS; ++i) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl;
        def.transform.position[0] = 2.0 * (i % 4 - 1.5), def.transform.position[2] = -3.0 * (i / 4);
        def.play.clip = 0, def.play.phase_s = 0.125f * (float)i;
        def.seed = (uint64_t)i;
        CHECK(clq_actor_create(crowd, &def, &actors[i]));
    }
    clq_dof_value nod = {0, 0.4f};
    clq_mechanism_def blink = clq_mechanism_def_init();
    blink.kind = CLQ_MECHANISM_BLINK, blink.tmpl = tmpl;
    blink.blink.closed.count = 1, blink.blink.closed.values = &nod;
    clq_mechanism_attachment use = clq_mechanism_attachment_init();
    CHECK(clq_crowd_add_mechanism(crowd, &blink, &use.mechanism));
    CHECK(clq_actor_attach_mechanism(crowd, actors[0], &use));
    const float square[4][3] = {{1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {-1, 0, 1}};
    clq_root_path_def path = clq_root_path_def_init();
    path.count = 4, path.positions = square[0], path.duration_s = 5;
    clq_root_path_play round = clq_root_path_play_init();
    CHECK(clq_crowd_add_root_path(crowd, &path, &round.path));
    CHECK(clq_actor_play_root_path(crowd, actors[1], &round));
    clq_attachment_def bag = clq_attachment_def_init();
    bag.node = 1, bag.radius = 0.5f;
    CHECK(clq_actor_attach(crowd, actors[0], &bag, NULL));
    clq_fade_def fade = clq_fade_def_init();
    fade.play.clip = 1, fade.play.start_s = fade.at_s = 0.25;
    CHECK(clq_actor_fade_to(crowd, actors[2], &fade));
    clq_layer_def layer = clq_layer_def_init();
    layer.play.clip = 1, layer.weight = 0.5f;
    const char *const names[1] = {"tip"};
    clq_mask_def mask = clq_mask_def_init();
    mask.tmpl = tmpl, mask.node_count = 1, mask.nodes = names;
    CHECK(clq_crowd_add_mask(crowd, &mask, &layer.mask));
    CHECK(clq_actor_add_layer(crowd, actors[3], &layer, NULL));
    clq_group group;
    CHECK(clq_group_create(crowd, NULL, &group));
    CHECK(clq_actor_join(crowd, actors[4], group, NULL));
    CHECK(clq_actor_set_watched(crowd, actors[0], true));

    clq_palette_entry red = clq_palette_entry_init();
    red.range.hue_max_deg = 20, red.range.saturation_min = 0.8f;
    clq_zone_colours cloth = clq_zone_colours_init();
    cloth.zone = "cloth", cloth.palette_count = 1, cloth.palette = &red;
    clq_colour_class reds = clq_colour_class_init();
    reds.name = "reds", reds.zone_count = 1, reds.zones = &cloth;
    clq_colour_map_def map_def = clq_colour_map_def_init();
    map_def.class_count = 1, map_def.classes = &reds;
    clq_colour_map *map = NULL;
    CHECK(clq_colour_map_create(context, &map_def, &map));
    CHECK(clq_crowd_randomise_colours(crowd, map, 0, actors, ACTORS));
    clq_colour_sample_def sample = clq_colour_sample_def_init();
    sample.tmpl = tmpl;
    float rgb[6];
    CHECK(clq_colour_map_sample(map, &sample, rgb, 2));
    add(rgb, sizeof rgb);
    clq_colour_map_destroy(map);
}

static void read_crowd(clq_crowd *crowd, const clq_view *view, clq_actor actor)
{
    clq_actor_info info = clq_actor_info_init();
    clq_crowd_stats stats = clq_crowd_stats_init();
    clq_key_pose_stats key_poses = clq_key_pose_stats_init();
    clq_view_stats seen = clq_view_stats_init();
    clq_drawn_actor drawn = clq_drawn_actor_init();
    float positions[VERTICES][3], palette[24];
    const clq_time_range range = {0, 2};
    size_t events = 0;
    CHECK(clq_actor_get_info(crowd, actor, &info));
    CHECK(clq_crowd_get_stats(crowd, &stats));
    CHECK(clq_crowd_get_key_pose_stats(crowd, &key_poses));
    CHECK(clq_view_get_stats(view, &seen));
    CHECK(clq_view_get_drawn_actor(view, 0, &drawn));
    CHECK(clq_view_get_vertices(view, 0, positions[0], NULL, VERTICES));
    CHECK(clq_view_get_palette(view, 0, palette, 2));
    CHECK(clq_crowd_get_events(crowd, &range, NULL, 0, &events));
    add_number(info.visible), add_number((double)info.eye_distance_m), add_number((double)info.sklsroot_radius);
    add_number(stats.actor_count), add_number(stats.animated), add_number(key_poses.requested);
    add_number(seen.visible), add_number(seen.triangles), add_number(drawn.vertex_count);
    add_number((double)events);
    add(positions, sizeof positions);
    add(palette, sizeof palette);
}

int main(void)
{
    clq_context_def context_def = clq_context_def_init();
    clq_crowd_def crowd_def = clq_crowd_def_init();
    clq_look_at_def look = clq_look_at_def_init();
    clq_context *context = NULL;
    clq_crowd *crowd = NULL;
    clq_view *view = NULL;
    clq_camera camera;
    clq_actor actors[ACTORS];
    CHECK(clq_context_create(&context_def, &context));
    clq_template *tmpl = ribbon(context);
    if (failures) return 1;
    read_template(tmpl);
    crowd_def.seed = 7;
    CHECK(clq_crowd_create(context, &crowd_def, &crowd));
    CHECK(clq_view_create(crowd, &view));
    fill(context, crowd, tmpl, actors);
    look.eye[1] = 2, look.eye[2] = 6;
    look.target[1] = 1, look.target[2] = -4;
    CHECK(clq_camera_look_at(&look, &camera));
    CHECK(clq_view_set_camera(view, &camera));
    for (int frame = 0; frame <= 25 && !failures; ++frame) {
        CHECK(clq_crowd_update(crowd, frame / 12.5, &view, 1));
        const uint64_t hash = clq_view_get_hash(view);
        add(&hash, sizeof hash);
    }
    read_crowd(crowd, view, actors[0]);
    clq_crowd_destroy(crowd);
    clq_template_destroy(tmpl);
    CHECK(clq_context_destroy(context));
    if (failures) return 1;
    printf("a host of headers %d with library %u: %016llx\n", CLQ_VERSION, (unsigned)clq_version(), all);
    return 0;
}
