#include "samples/parity/write/describe.h"
#include "samples/parity/write/gl_query.h"
#include "samples/parity/write/scene_glb.h"
#include "samples/scenes/check.h"

#include <algorithm>

namespace parity
{

using scenes::check;

namespace
{

struct Poses {
    explicit Poses(const Shown &shown) : palettes(12 * shown.palette_rows()), weights(shown.morph_weights())
    {
        std::vector<float> columns;
        for (const Individual &who : shown.individuals()) {
            columns.resize(12 * static_cast<size_t>(who.shown.joint_count));
            check(clq_view_get_pose(shown.view(), who.place, columns.data(), who.shown.joint_count,
                                    weights.data() + who.first_weight, who.shown.morph_weight_count));
            float *rows = palettes.data() + 12 * static_cast<size_t>(who.first_palette);
            for (size_t joint = 0; joint < who.shown.joint_count; ++joint)
                for (size_t row = 0; row < 3; ++row)
                    for (size_t column = 0; column < 4; ++column)
                        rows[12 * joint + 4 * row + column] = columns[12 * joint + 3 * column + row];
        }
    }
    std::vector<float> palettes, weights;
};

// S2 2.2: a row an individual, a column a key.
void write_atlas(const Folder &folder, const Shown &shown)
{
    const size_t count = shown.individuals().size(), plates = (count + atlas_rows - 1) / atlas_rows;
    std::vector<uint8_t> atlas(plates * atlas_rows * atlas_columns * 3), rgb;
    for (size_t i = 0; i < count; ++i) {
        const Individual &who = shown.individuals()[i];
        rgb.resize(3 * static_cast<size_t>(who.shown.zone_count));
        check(clq_view_get_colours(shown.view(), who.place, rgb.data(), who.shown.zone_count));
        const size_t most = 3 * (atlas_columns - 1);  // zones beyond that no texture can name
        std::copy_n(rgb.begin(), std::min(rgb.size(), most),
                    atlas.begin() + static_cast<std::ptrdiff_t>(3 * (i * atlas_columns + 1)));
    }
    folder.array("atlas.npy", atlas, {plates, atlas_rows, atlas_columns, 3});
}

}  // namespace

size_t write_scene(scenes::Stage &stage, const Moment &moment, const std::string &folder_path)
{
    const Folder folder(folder_path);
    folder.clear();
    stage.update(moment.time_s);
    stage.draw_setting();
    const Shown shown(stage.view());
    const Skinned skinned(shown);
    const Poses poses(shown);
    write_individuals(folder, shown, skinned);
    write_atlas(folder, shown);
    folder.array("palettes.npy", poses.palettes, {shown.palette_rows(), 3, 4});
    folder.array("morph_weights.npy", poses.weights, {poses.weights.size()});
    const std::string glb = scene_glb(shown, poses.palettes, stage.eye().projection);
    folder.write("scene.glb", glb.data(), glb.size());

    Json json = described("scene", stage, moment, shown);
    json["palette_rows"] = shown.palette_rows();
    json["morph_weights"] = poses.weights.size();
    for (size_t i = 0; i < shown.meshes().size(); ++i) json["meshes"][i]["mesh"] = i;
    json["lighting"] = lighting_of(stage.offscreen());
    json["fog"] = fog_of(stage.offscreen());
    write_json(folder, json);
    return shown.individuals().size();
}

}  // namespace parity
