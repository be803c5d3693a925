// What stands behind clq_asset, and its way into libclaque: through the public clq_template_def, as any host's arrays.
#pragma once

#include <claque/assets.h>

#include <deque>

#include "lib/asset/gltf.h"

struct clq_asset {
    explicit clq_asset(claque::model::Model &&loaded) : model(std::move(loaded)) {}
    claque::model::Model model;
    std::vector<claque::asset::RootMotionRequest> root_motions;
};

namespace claque::api
{

// An asset as the arrays of a clq_template_def. Points into it, which must outlive it. Hidden parts and parts
// without triangles are left out.
class TemplateDef
{
public:
    explicit TemplateDef(const clq_asset &asset);
    TemplateDef(const TemplateDef &) = delete;
    TemplateDef &operator=(const TemplateDef &) = delete;

    clq_template_def def;

private:
    void add_rig(const model::Model &model);
    void add_materials(const model::Model &model);
    void add_part(const model::Model &model, const model::Part &part);
    void add_clips(const model::Model &model);
    void add_markers(const clq_asset &asset);

    std::vector<clq_node_def> nodes_;
    std::vector<clq_dof_def> dofs_;
    std::vector<clq_joint_def> joints_;
    std::deque<std::array<float, 16>> inverse_binds_;
    std::vector<clq_image_def> images_;
    std::vector<clq_zone_def> zones_;
    std::vector<clq_material_def> materials_;
    std::vector<clq_part_def> parts_;
    std::deque<std::vector<uint32_t>> indices_;
    std::deque<std::vector<clq_morph_def>> morphs_;
    std::vector<clq_clip_def> clips_;
    std::vector<clq_channel_def> channels_;
    std::vector<clq_marker_def> markers_;
    std::vector<clq_root_motion_def> root_motions_;
    std::vector<clq_texture_set_def> texture_sets_;
};

}  // namespace claque::api
