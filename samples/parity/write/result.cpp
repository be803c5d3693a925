#include "samples/parity/write/describe.h"
#include "samples/parity/write/id_pictures.h"

namespace parity
{

clq_draw_stats draw_alone(scenes::Stage &stage)
{
    stage.draw_setting();
    stage.gl().DepthMask(1);
    stage.gl().ClearColor(0, 0, 0, 1);
    stage.gl().Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
    return stage.draw_crowd();
}

size_t write_result(scenes::Stage &stage, const Moment &moment, const std::string &folder_path)
{
    const Folder folder(folder_path);
    folder.clear();
    stage.update(moment.time_s);
    const clq_draw_stats drawn = draw_alone(stage);
    const size_t height = static_cast<size_t>(moment.height), width = static_cast<size_t>(moment.width);
    folder.array("colour.npy", stage.read(), {height, width, 3});
    std::vector<float> depth;
    stage.offscreen().read_depth(depth);
    folder.array("depth.npy", depth, {height, width});

    const Shown shown(stage.view());
    const Skinned skinned(shown);
    write_individuals(folder, shown, skinned);
    folder.array("positions.npy", skinned.positions, {shown.vertices(), 3});
    folder.array("normals.npy", skinned.normals, {shown.vertices(), 3});
    const IdPictures ids = id_pictures(stage.offscreen(), shown, skinned, stage.eye().projection);
    folder.array("actor.npy", ids.actor, {height, width});
    folder.array("zone.npy", ids.zone, {height, width});

    Json json = described("result", stage, moment, shown);
    json["draws"] = {{"individuals", drawn.individuals},
                     {"calls", drawn.draws},
                     {"triangles", drawn.triangles},
                     {"vertices", drawn.vertices}};
    write_json(folder, json);
    return shown.individuals().size();
}

}  // namespace parity
