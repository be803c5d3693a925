// A file that is right and needs what claque does not know, and one that is wrong.
#include "tests/support/written_files.h"

namespace claque::testing
{

WrittenFiles written_refused()
{
    const char *const unknown = "EXT_mesh_gpu_instancing";
    Maker instances;
    instances.triangle();
    for (const char *list : {"extensionsUsed", "extensionsRequired"}) instances.json[list] = Json::array({unknown});
    const int places = instances.floats("VEC3", 2, {0, 0, 0, 3, 0, 0});
    instances.json["nodes"][0]["extensions"][unknown] = {{"attributes", {{"TRANSLATION", places}}}};

    Maker repeats;
    repeats.triangle();
    repeats.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", repeats.view(Bytes{1, 1})}, {"componentType", u8}}},
        {"values", {{"bufferView", repeats.view(std::vector<float>{0, 0, 1, 0, 0, 2})}}}};
    return {{"WrittenInstances.glb", instances.glb()}, {"WrittenRepeats.glb", repeats.glb()}};
}

}  // namespace claque::testing
