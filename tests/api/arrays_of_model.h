// A Model as the arrays that a host of its own would pass to clq_template_build.
#pragma once

#include <claque/template.h>

#include <deque>

#include "lib/model/model.h"

namespace claque::test
{

// Points into the model, which must outlive it. Parts that are not drawn are left out.
class ArraysOfModel
{
public:
    explicit ArraysOfModel(const model::Model &model);
    ArraysOfModel(const ArraysOfModel &) = delete;
    ArraysOfModel &operator=(const ArraysOfModel &) = delete;

    clq_template_def def;

private:
    void add_rig(const model::Model &model);
    void add_looks(const model::Model &model);
    void add_part(const model::Model &model, const model::Part &part);
    void add_clips(const model::Model &model);
    void add_notes(const model::Model &model);

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

}  // namespace claque::test
