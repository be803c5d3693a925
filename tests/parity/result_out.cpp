#include "tests/parity/result_out.h"

#include "samples/parity/write/files.h"

namespace parity_test
{
namespace
{

void write_pictures(const contexts::Offscreen &context, Peer &peer, const SceneIn &scene, parity::Folder &folder)
{
    const size_t height = static_cast<size_t>(scene.height), width = static_cast<size_t>(scene.width);
    std::vector<uint8_t> rgb;
    std::vector<float> depth;
    peer.draw_all(What::colour);
    context.read_rgb(rgb);
    context.read_depth(depth);
    folder.array("colour.npy", rgb, {height, width, 3});
    folder.array("depth.npy", depth, {height, width});
    peer.draw_all(What::actor);
    context.read_rgb(rgb);
    std::vector<uint32_t> actors;
    for (size_t i = 0; i < rgb.size(); i += 3)
        actors.push_back(rgb[i] | static_cast<uint32_t>(rgb[i + 1]) << 8 | static_cast<uint32_t>(rgb[i + 2]) << 16);
    folder.array("actor.npy", actors, {height, width});
    peer.draw_all(What::zone);
    context.read_rgb(rgb);
    std::vector<uint16_t> zones;
    for (size_t i = 0; i < rgb.size(); i += 3) zones.push_back(rgb[i]);
    folder.array("zone.npy", zones, {height, width});
}

}  // namespace

void write_result(const contexts::Offscreen &context, Peer &peer, const SceneIn &scene, const std::string &scene_folder,
                  const std::string &folder_path)
{
    parity::Folder folder(folder_path);
    write_pictures(context, peer, scene, folder);
    std::vector<float> positions, normals;
    if (peer.skin(positions, normals)) {
        folder.array("positions.npy", positions, {positions.size() / 3, 3});
        folder.array("normals.npy", normals, {normals.size() / 3, 3});
    }
    for (const char *name : {"actors.npy", "sizes.npy", "model_view.npy"}) {
        const std::string bytes = bytes_of(scene_folder + "/" + name);
        folder.write(name, bytes.data(), bytes.size());
    }
    Json json = scene.json;
    json["kind"] = "result";
    json["renderer"] = "GPU peer, GLSL 1.20; " + context.name();
    for (const char *scenes_own : {"palette_rows", "morph_weights", "lighting", "fog"}) json.erase(scenes_own);
    const std::string text = json.dump(2) + "\n";
    folder.write("capture.json", text.data(), text.size());
    folder.complete();
}

}  // namespace parity_test
