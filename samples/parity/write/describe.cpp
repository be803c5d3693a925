#include "samples/parity/write/describe.h"

namespace parity
{
namespace
{

// Rows of a matrix that OpenGL stores column by column.
Json rows_of(const float *columns, int size)
{
    Json out = Json::array();
    for (int row = 0; row < size; ++row) {
        Json line = Json::array();
        for (int column = 0; column < size; ++column) line.push_back(columns[4 * column + row]);
        out.push_back(line);
    }
    return out;
}

std::string version()
{
    return std::to_string(CLQ_VERSION_MAJOR) + "." + std::to_string(CLQ_VERSION_MINOR) + "." +
           std::to_string(CLQ_VERSION_PATCH);
}

}  // namespace

Json described(const char *kind, const scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time,
               const DrawnActors &drawn_actors)
{
    Json out = {{"format", "claque-parity"},
                {"version", format_version},
                {"kind", kind},
                {"renderer", "claque " + version() + ", CPU; " + scene_renderer.context_name()},
                {"scene", capture_time.scene},
                {"width", capture_time.width},
                {"height", capture_time.height},
                {"time_s", capture_time.time_s},
                {"units", {{"length", "m"}, {"time", "s"}, {"angle", "rad"}, {"colour", "8 bits, no gamma"}}}};
    drawn_actors.describe(out);
    const scenes::Eye &eye = scene_renderer.eye();
    out["projection"] = rows_of(eye.projection, 4);
    out["camera"] = {{"eye_m", eye.position}, {"world_to_eye", rows_of(eye.rotation, 3)}};
    return out;
}

void write_individuals(Folder &folder, const DrawnActors &drawn_actors, const Skinned &skinned)
{
    drawn_actors.write_actors(folder);
    folder.array("sizes.npy", skinned.sizes, {skinned.sizes.size()});
    std::vector<float> places;
    for (const Individual &person : drawn_actors.individuals())
        for (size_t row = 0; row < 4; ++row)
            for (size_t column = 0; column < 4; ++column)
                places.push_back(person.drawn_actors.model_view[4 * column + row]);
    folder.array("model_view.npy", places, {drawn_actors.individuals().size(), 4, 4});
}

void write_json(Folder &folder, const Json &json)
{
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    folder.write("capture.json", text.data(), text.size());
}

}  // namespace parity
