// A result: what the CPU path makes of a time.
#include "samples/parity/write/describe.h"
#include "samples/parity/write/gl_query.h"
#include "samples/parity/write/id_pictures.h"

namespace parity
{

clq_draw_stats draw_alone(scenes::SceneRenderer &scene_renderer)
{
    scene_renderer.begin_picture();
    scene_renderer.gl().ClearColor(0, 0, 0, 1);  // a scene may have filled it with haze
    scene_renderer.gl().Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
    return scene_renderer.draw_crowd();
}

size_t write_result(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time,
                    const std::string &folder_path)
{
    Folder folder(folder_path);
    scene_renderer.update(capture_time.time_s);
    const clq_draw_stats drawn = draw_alone(scene_renderer);
    const size_t height = static_cast<size_t>(capture_time.height), width = static_cast<size_t>(capture_time.width);
    folder.array("colour.npy", scene_renderer.read(), {height, width, 3});
    std::vector<float> depth;
    scene_renderer.offscreen().read_depth(depth);
    folder.array("depth.npy", depth, {height, width});

    const DrawnActors drawn_actors(scene_renderer.view());
    const Skinned skinned(drawn_actors);
    write_individuals(folder, drawn_actors, skinned);
    folder.array("positions.npy", skinned.positions, {drawn_actors.vertices(), 3});
    folder.array("normals.npy", skinned.normals, {drawn_actors.vertices(), 3});
    const IdPictures ids = id_pictures(scene_renderer);
    folder.array("actor.npy", ids.actor, {height, width});
    folder.array("zone.npy", ids.zone, {height, width});

    Json json = described("result", scene_renderer, capture_time, drawn_actors);
    json["draws"] = {{"individuals", drawn.individuals},
                     {"calls", drawn.draws},
                     {"triangles", drawn.triangles},
                     {"vertices", drawn.vertices}};
    json["subpixel_bits"] = subpixel_bits(scene_renderer.offscreen());
    write_json(folder, json);
    folder.complete();
    return drawn_actors.individuals().size();
}

}  // namespace parity
