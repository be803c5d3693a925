#include "samples/cli/filtering.h"

#include "samples/cli/characters.h"

namespace cli
{

nlohmann::json filtering(const scenes::SceneRenderer &scene_renderer)
{
    nlohmann::json all = nlohmann::json::array();
    for (const clq_template *tmpl : scene_renderer.scene().templates()) {
        const clq_prepared_info info = scene_renderer.prepared(tmpl);
        all.push_back({{"template", info_of(tmpl).name},
                       {"triangles", info.triangle_count},
                       {"filtered", info.linear_count},
                       {"edges_between", info.edge_count},
                       {"luminance_step", {{"mean", info.step_mean}, {"max", info.step_max}}}});
    }
    return all;
}

}  // namespace cli
