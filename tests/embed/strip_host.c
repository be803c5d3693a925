/* A C99 host with arrays of its own needs libclaque alone: a strip of eight triangles bends over two joints. Forty of
 * them are posed, skinned and listed for a view over two seconds. The host prints the hash of every list, with all
 * matrices, colours and vertices, which is the same on every machine. */
#include <claque/claque.h>

#include <stdio.h>
#include <string.h>

enum { ROWS = 5, STRIPS = 40 };

static int check(clq_status status)
{
    if (status != CLQ_OK) fprintf(stderr, "%s: %s\n", clq_status_name(status), clq_last_error());
    return status == CLQ_OK;
}

static clq_template *strip(clq_context *context)
{
    float inverse_binds[2][16], positions[ROWS][2][3], normals[ROWS][2][3], uvs[ROWS][2][2], weights[ROWS][2][2];
    uint32_t joints[ROWS][2][2], indices[ROWS - 1][6];
    uint8_t texels[64][4];
    const float times[3] = {0, 0.5f, 1}, turns[3][4] = {{0, 0, 0, 1}, {0.5f, 0, 0, 0.8660254f}, {0, 0, 0, 1}};
    memset(inverse_binds, 0, sizeof inverse_binds);
    for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 4; ++k) inverse_binds[j][5 * k] = 1;
    inverse_binds[1][13] = -1;
    for (int t = 0; t < 64; ++t) {
        memset(texels[t], 255, 3);
        texels[t][3] = t % 8 < 4 ? 100 : 200;
    }
    for (int row = 0; row < ROWS; ++row)
        for (int side = 0; side < 2; ++side) {
            const float at[3] = {side ? 0.3f : -0.3f, 0.5f * (float)row, 0}, normal[3] = {0, 0, 1};
            const float bent = 0.25f * (float)row;
            memcpy(positions[row][side], at, sizeof at);
            memcpy(normals[row][side], normal, sizeof normal);
            uvs[row][side][0] = side ? 0.95f : 0.05f, uvs[row][side][1] = 0.05f + 0.2f * (float)row;
            weights[row][side][0] = 1 - bent, weights[row][side][1] = bent;
            joints[row][side][0] = 0, joints[row][side][1] = 1;
        }
    for (uint32_t row = 0; row + 1 < ROWS; ++row) {
        const uint32_t v = 2 * row, corners[6] = {v, v + 1, v + 3, v, v + 3, v + 2};
        memcpy(indices[row], corners, sizeof corners);
    }

    clq_node_def nodes[2];
    memset(nodes, 0, sizeof nodes);
    nodes[0].name = "root", nodes[0].parent = CLQ_NONE;
    nodes[1].name = "tip", nodes[1].parent = 0, nodes[1].translation[1] = 1;
    const clq_joint_def palette[2] = {{0, inverse_binds[0]}, {1, inverse_binds[1]}};
    const clq_image_def image = {"strip", 8, 8, texels[0], CLQ_ALPHA_ZONE_KEYS};
    const clq_zone_def zones[2] = {{"cloth", 100, {0.8f, 0.2f, 0.1f}, {0, 360, 0.5f, 1, 0.5f, 1}},
                                   {"skin", 200, {0.9f, 0.7f, 0.6f}, {15, 30, 0.2f, 0.4f, 0.6f, 1}}};
    clq_material_def material;
    memset(&material, 0, sizeof material);
    material.name = "strip", material.zone = CLQ_NONE;
    clq_part_def part;
    memset(&part, 0, sizeof part);
    part.name = "strip", part.vertex_count = 2 * ROWS;
    part.positions = positions[0][0], part.normals = normals[0][0], part.uvs = uvs[0][0];
    part.influence_count = 2, part.joints = joints[0][0], part.weights = weights[0][0];
    part.index_count = 6 * (ROWS - 1), part.indices = indices[0];
    const clq_channel_def channel = {1, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, 3, times, turns[0]};
    const clq_clip_def clip = {"bend", 1, &channel};

    clq_template_def def = clq_template_def_init();
    def.name = "strip";
    def.node_count = 2, def.nodes = nodes;
    def.joint_count = 2, def.joints = palette;
    def.image_count = 1, def.images = &image;
    def.zone_count = 2, def.zones = zones;
    def.material_count = 1, def.materials = &material;
    def.part_count = 1, def.parts = &part;
    def.clip_count = 1, def.clips = &clip;
    clq_template *tmpl = NULL;
    check(clq_template_build(context, &def, &tmpl));
    return tmpl;
}

static int stand(clq_crowd *crowd, clq_template *tmpl)
{
    for (int i = 0; i < STRIPS; ++i) {
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl;
        def.transform.position[0] = 2.0 * (i % 8 - 3.5), def.transform.position[2] = -3.0 * (i / 8);
        def.play.clip = 0, def.play.phase_s = 0.125f * (float)(i % 7);
        def.seed = (uint64_t)i;
        if (!check(clq_actor_create(crowd, &def, &actor))) return 0;
        if (!check(clq_actor_randomise_colours(crowd, actor, NULL, 0))) return 0;
    }
    return 1;
}

int main(void)
{
    clq_look_at_def look = clq_look_at_def_init();
    clq_context *context = NULL;
    clq_crowd *crowd = NULL;
    clq_view *view = NULL;
    clq_camera camera;
    clq_view_stats stats = clq_view_stats_init();
    unsigned long long all = 0;
    if (!check(clq_context_create(NULL, &context))) return 1;
    clq_template *tmpl = strip(context);
    if (!tmpl || !check(clq_crowd_create(context, NULL, &crowd)) || !check(clq_view_create(crowd, &view))) return 1;
    if (!stand(crowd, tmpl)) return 1;
    look.eye[1] = 2, look.eye[2] = 6;
    look.target[1] = 1, look.target[2] = -4;
    look.fov_y_rad = 0.8f, look.aspect = 1.25f, look.z_far = 100;
    if (!check(clq_camera_look_at(&look, &camera))) return 1;
    if (!check(clq_view_set_camera(view, &camera))) return 1;
    for (int frame = 0; frame <= 50; ++frame) {
        if (!check(clq_crowd_update(crowd, frame / 25.0, &view, 1))) return 1;
        all = all * 1099511628211u + clq_view_get_hash(view);
    }
    if (!check(clq_view_get_stats(view, &stats))) return 1;
    printf("%u of %d in view, %u triangles, fingerprint %08lx%08lx\n", (unsigned)stats.visible, (int)STRIPS,
           (unsigned)stats.triangles, (unsigned long)(all >> 32), (unsigned long)(all & 0xffffffffu));
    clq_crowd_destroy(crowd);
    clq_template_destroy(tmpl);
    return !check(clq_context_destroy(context));
}
