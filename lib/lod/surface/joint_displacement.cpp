#include "lib/lod/surface/joint_displacement.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t max_clips = 32, poses_per_clip = 4;
constexpr size_t max_points = 16;  // per joint

// Returns rest positions of vertices whose weight for a joint is at least a quarter, for each joint.
std::vector<std::vector<glm::vec3>> points_of(const model::Model &model, const std::vector<SourcePart> &parts)
{
    std::vector<std::vector<glm::vec3>> points(model.rig.palette.size());
    for (const SourcePart &piece : parts) {
        const model::Part &part = *piece.part;
        const std::vector<glm::vec3> &rest = piece.rest ? *piece.rest : part.positions;
        for (size_t i = 0; i < part.joints.size(); ++i)
            if (part.weights[i] >= 0.25f) points[part.joints[i]].push_back(rest[i / part.influence_count]);
    }
    for (std::vector<glm::vec3> &all : points) {
        if (all.size() <= max_points) continue;
        for (size_t i = 0; i < max_points; ++i) all[i] = all[i * all.size() / max_points];
        all.resize(max_points);
    }
    return points;
}

// Returns, for each palette entry, an entry of the nearest ancestor node that has one, or model::none.
std::vector<uint32_t> entries_above(const model::Rig &rig)
{
    std::vector<uint32_t> entry(rig.parents.size(), model::none), above;
    for (uint32_t i = 0; i < rig.palette.size(); ++i) entry[rig.palette[i].node] = i;
    for (const model::PaletteEntry &one : rig.palette) {
        uint32_t node = rig.parents[one.node];
        while (node != model::none && entry[node] == model::none) node = rig.parents[node];
        above.push_back(node == model::none ? model::none : entry[node]);
    }
    return above;
}

}  // namespace

std::vector<double> joint_displacements(const model::Model &model, const std::vector<SourcePart> &parts)
{
    const model::Rig &rig = model.rig;
    if (rig.clips.empty()) return {};
    const std::vector<std::vector<glm::vec3>> points = points_of(model, parts);
    const std::vector<uint32_t> above = entries_above(rig);
    pose::Workspace workspace(rig);
    // From rest positions back to bind positions, for each palette entry.
    std::vector<math::Affine> back;
    for (const math::Affine &matrix : workspace.pose(model::none, 0)) back.push_back(math::inverse(matrix));
    std::vector<double> squares(rig.palette.size(), 0);
    const uint32_t count = static_cast<uint32_t>(rig.clips.size()), first_late = model.first_late_clip;
    const uint32_t late = first_late > 0 && first_late + model.late_clip_count <= count ? model.late_clip_count : 0;
    const uint32_t clips = std::min(max_clips, count - late);
    for (uint32_t k = 0; k < clips; ++k) {
        const uint32_t clip = k < first_late ? k : k + late;
        for (uint32_t i = 0; i < poses_per_clip; ++i) {
            const model::Clip &c = rig.clips[clip];
            const base::Span<const math::Affine> palette =
                workspace.pose(clip, double(c.start_s) + double(c.duration_s) * (i + 0.5) / poses_per_clip);
            for (size_t joint = 0; joint < points.size(); ++joint) {
                if (above[joint] == model::none) continue;
                const math::Affine own = math::mul(palette[joint], back[joint]),
                                   other = math::mul(palette[above[joint]], back[above[joint]]);
                for (const glm::vec3 p : points[joint]) {
                    const glm::dvec3 off =
                        glm::dvec3(math::transform_point(own, p)) - glm::dvec3(math::transform_point(other, p));
                    squares[joint] += glm::dot(off, off) / double(points[joint].size());
                }
            }
        }
    }
    for (double &square : squares) square = std::sqrt(square / (double(clips) * poses_per_clip));
    return squares;
}

}  // namespace claque::lod
