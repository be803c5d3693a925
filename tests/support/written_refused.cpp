// A file that is right and needs what claque does not know, and one that is wrong.
#include "tests/support/written_files.h"

namespace claque::testing
{

WrittenFiles written_refused()
{
    Maker requires_one;
    requires_one.triangle();
    for (const char *list : {"extensionsUsed", "extensionsRequired"})
        requires_one.json[list] = Json::array({"EXT_structural_metadata"});

    Maker repeats;
    repeats.triangle();
    repeats.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", repeats.view(Bytes{1, 1})}, {"componentType", u8}}},
        {"values", {{"bufferView", repeats.view(std::vector<float>{0, 0, 1, 0, 0, 2})}}}};
    return {{"WrittenRequires.glb", requires_one.glb()}, {"WrittenRepeats.glb", repeats.glb()}};
}

}  // namespace claque::testing
