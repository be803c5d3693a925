#include "lib/asset/gltf.h"

#include "lib/asset/gltf_build.h"
#include "lib/asset/gltf_header.h"

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

}  // namespace

model::Model load_gltf(const uint8_t *bytes, size_t size, const LoadOptions &options, double *own_turn_deg)
{
    if (size == 0) fail(CLQ_FORMAT, "the file is empty");
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
    return model;
}

}  // namespace claque::asset
