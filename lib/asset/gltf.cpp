#include "lib/asset/gltf.h"

#include <string_view>

#include "lib/asset/gltf_build.h"
#include "lib/asset/gltf_header.h"
#include "lib/asset/near_colours.h"

namespace claque::asset
{

using base::fail;

namespace
{

// Errors that the model check still finds are errors of the file, not of the caller.
void check_as_format(const model::Model &model)
{
    try {
        model::check(model);
    } catch (const base::Error &error) {
        fail(CLQ_FORMAT, "%s", error.what());
    }
}

// VRM 1.0 is another extension, and faces +z as glTF does.
bool is_vrm_0(const JsonView &root)
{
    const JsonView extensions = root["extensions"];
    return extensions.is_object() && extensions["VRM"].exists() && !extensions["VRMC_vrm"].exists();
}

// Other formats are refused before the parser of JSON speaks about them. A GLB begins with "glTF", JSON with a brace.
void expect_gltf(const uint8_t *bytes, size_t size)
{
    std::string_view text(reinterpret_cast<const char *>(bytes), size);
    if (text.substr(0, 4) == "glTF") return;
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && text[first] == '{') return;
    if (text.substr(0, 7) == "claqueT")
        fail(CLQ_FORMAT,
             "it is a prepared template: clq_template_load and commands that show a character read it; parts and clips "
             "are taken from the file of which it was made");
    fail(CLQ_FORMAT,
         "it is neither glTF nor BVH: 'claque convert FILE --out NAME.glb' makes a GLB of most other formats, such as "
         "FBX, Collada, OBJ, IQM and MD2");
}

}  // namespace

model::Model load_gltf(const uint8_t *bytes, size_t size, const LoadOptions &options, double *own_turn_deg)
{
    if (size == 0) fail(CLQ_FORMAT, "the file is empty");
    expect_gltf(bytes, size);
    Budget budget(options.memory_limit_bytes);
    budget.add_input(size);
    const Container container = open_container(bytes, size);
    const JsonDocument document(container.json, container.json_size, budget.remaining());
    const JsonView root = document.root();
    check_header(root);
    File file(root, container, options, budget);
    model::Model model;
    build_model(file, model);
    model.root_motions = std::move(file.root_motions);
    model.warnings = std::move(file.warnings);
    model.source_bytes = budget.source_bytes();
    check_as_format(model);
    if (own_turn_deg) *own_turn_deg = is_vrm_0(root) ? 180 : 0;
    give_ranges(model, material_zones(model), options.colours);
    return model;
}

}  // namespace claque::asset
