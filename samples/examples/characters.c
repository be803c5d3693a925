/* What a character has: a glTF file from memory with a marker, degrees of freedom with their ranges, a texture set and
 * a degree of freedom that are added to a built-in person, and colour classes from a file. */
#include <claque/assets.h>
#include <claque/colour_files.h>
#include <claque/colours.h>

#include "samples/examples/check.h"

/* A triangle that turns about y, in a binary buffer that is part of the text: nine floats, two times, two rotations. */
static const char gltf[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],"
    "\"nodes\":[{\"name\":\"flag\",\"mesh\":0,\"extras\":{\"claque\":{\"dofs\":[{\"name\":\"dip\","
    "\"kind\":\"rotation\",\"axis\":[1,0,0],\"min\":-0.5,\"max\":1,\"rest\":0.25}]}}}],"
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
    "\"animations\":[{\"name\":\"turn\",\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"rotation\"}}],"
    "\"samplers\":[{\"input\":1,\"output\":2}],"
    "\"extras\":{\"claque\":{\"markers\":[{\"name\":\"half\",\"time_s\":0.5}]}}}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"
    "\"max\":[1,1,0]},"
    "{\"bufferView\":1,\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\",\"min\":[0],\"max\":[1]},"
    "{\"bufferView\":2,\"componentType\":5126,\"count\":2,\"type\":\"VEC4\"}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":8},"
    "{\"buffer\":0,\"byteOffset\":44,\"byteLength\":32}],"
    "\"buffers\":[{\"byteLength\":76,\"uri\":\"data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAgD8AAAAAAAAAAA==\"}]}";

static const char colours[] =
    "[[classes]]\nname = \"mourners\"\ntemplate = \"citizen\"\n[classes.zones]\n"
    "tunic = { hue = [0, 360], saturation = [0, 0], brightness = [0.05, 0.1] }\n";

int main(void)
{
    clq_context *context;
    check(clq_context_create(NULL, &context));

    clq_asset *asset;
    clq_template *flag, *citizen;
    check(clq_asset_load(context, gltf, sizeof gltf - 1, NULL, &asset));
    check(clq_asset_build(context, asset, 0, &flag));
    clq_asset_destroy(asset);
    clq_dof_info dip = clq_dof_info_init();
    check(clq_template_get_dof(flag, clq_template_find_dof(flag, "dip"), &dip));
    expect(dip.kind == CLQ_DOF_ROTATION && dip.min == -0.5f && dip.max == 1 && dip.rest == 0.25f,
           "the degree of freedom is as in the file");
    clq_marker_info half = clq_marker_info_init();
    check(clq_template_get_marker(flag, 0, &half));
    expect(strcmp(half.name, "half") == 0 && half.time_s == 0.5f, "the marker is as in the file");
    clq_template_destroy(flag);
    check(clq_template_load_gltf(context, gltf, sizeof gltf - 1, NULL, &flag)); /* the same at once, in levels */
    expect(clq_template_find_node(flag, "flag") == 0, "the template has the file's node");
    clq_template_destroy(flag);
    expect(clq_asset_load(context, gltf, 40, NULL, &asset) == CLQ_FORMAT, "a file that is cut off is refused");

    /* A third texture set for the citizen. Images without pixels keep the materials' own. */
    clq_asset_info info = clq_asset_info_init();
    check(clq_asset_builtin(context, "citizen", &asset));
    check(clq_asset_get_info(asset, &info));
    clq_image_def *images = calloc(info.material_count, sizeof *images);
    if (!images) return 1;
    check(clq_asset_add_texture_set(context, asset, "as ever", images, info.material_count));
    free(images);
    /* A degree of freedom that the citizen lacks: a gaze mechanism may then turn its head. */
    clq_asset_dof nod = clq_asset_dof_init();
    nod.node_name = "head";
    nod.dof = clq_dof_def_init();
    nod.dof.name = "nod", nod.dof.axis[0] = 1, nod.dof.min = -0.6f, nod.dof.max = 0.6f;
    check(clq_asset_add_dofs(context, asset, &nod, 1));
    check(clq_asset_build(context, asset, 0, &citizen));
    clq_asset_destroy(asset);
    expect(clq_template_find_dof(citizen, "nod") != CLQ_NONE, "the template has the new degree of freedom");
    const uint32_t set = clq_template_find_texture_set(citizen, "as ever");
    expect(set == 2 && clq_template_find_texture_set(citizen, "bearded") == 1, "the new set follows the built-in one");
    expect(strcmp(clq_template_get_texture_set_name(citizen, set), "as ever") == 0, "it has its name");
    expect(clq_template_get_texture_set_name(citizen, 3)[0] == 0, "beyond the last set there is none");
    expect(clq_template_find_texture_set(citizen, "bald") == CLQ_NONE, "an unknown name is not found");

    clq_crowd *crowd;
    clq_actor actor;
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = citizen, def.texture_set = set;
    check(clq_crowd_create(context, NULL, &crowd));
    check(clq_actor_create(crowd, &def, &actor));

    const char path[] = "mourners.toml";
    FILE *file = fopen(path, "wb");
    if (!file || fputs(colours, file) < 0 || fclose(file) != 0) return perror(path), 1;
    clq_colour_map *map;
    check(clq_colour_map_load_file(context, path, &map));
    remove(path);
    check(clq_crowd_randomise_colours(crowd, map, clq_colour_map_find(map, "mourners"), &actor, 1));
    const uint32_t tunic = clq_template_find_zone(citizen, "tunic");
    float rgb[3 * 8];
    check(clq_actor_get_colours(crowd, actor, rgb, 8));
    expect(tunic < 8 && rgb[3 * tunic] < 0.11f && rgb[3 * tunic] > 0.04f, "the tunic is nearly black");
    expect(clq_colour_map_load_file(context, path, &map) == CLQ_IO, "a file that is not there cannot be read");

    clq_colour_map_destroy(map);
    clq_crowd_destroy(crowd);
    clq_template_destroy(citizen);
    check(clq_context_destroy(context));
    return printf("the flag dips by %.2f to %.2f rad; a citizen in texture set %u mourns\n", (double)dip.min,
                  (double)dip.max, set) < 0;
}
