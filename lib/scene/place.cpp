#include "lib/scene/place.h"

#include <cmath>
#include <limits>

#include "lib/base/hash.h"
#include "lib/behave/behave.h"
#include "lib/math/eye_transform.h"

namespace claque::scene
{

namespace
{

bool is_finite(const glm::dvec3 &p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double length_of(const glm::vec3 &v)
{
    const glm::dvec3 d(v);
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

double world_scale_of(const crowd::Crowd &crowd, uint32_t row)
{
    const uint32_t group = crowd.group_of(row);
    const float outer = group == model::none ? 1 : crowd.group(group).transform.scale;
    return std::fabs(double(crowd.transform_of(row).scale * outer));
}

struct Motion {
    double speed = 0;  // the highest, world units a second
    double jumps = 0;  // from pieces of the track to the next ones, all together
};

Motion motion_of(const crowd::Follow &follow)
{
    Motion out;
    const track::Track *piece = follow.track;
    out.speed = piece->top_speed;
    for (const track::Track *earlier : follow.earlier) {
        if (!earlier) break;
        out.speed = std::fmax(out.speed, earlier->top_speed);
        const double border_s = piece->start_s;
        const glm::dvec3 jump = track::position_at(*piece, border_s) - track::position_at(*earlier, border_s);
        out.jumps += std::sqrt(jump.x * jump.x + jump.y * jump.y + jump.z * jump.z);
        piece = earlier;
    }
    return out;
}

// Quaternions and matrices of members are rounded to float, so that what they place reaches a little further.
constexpr double rounding = 1 + 1e-5;

}  // namespace

bool place_at(const crowd::Crowd &crowd, uint32_t row, double time_s, glm::dvec3 &out) noexcept
{
    if (!crowd::is_present(crowd, row, time_s)) return false;
    if (crowd.behaviours().has_root_path_play(row))
        out = composed_position(crowd::reference_of(crowd, row, time_s),
                                behave::root_transform_at(crowd, row, time_s).position);
    else out = crowd::reference_position_of(crowd, row, time_s);
    return is_finite(out);
}

bool body_at(const crowd::Crowd &crowd, uint32_t row, double time_s, Body &out) noexcept
{
    if (!crowd::is_present(crowd, row, time_s)) return false;
    crowd::Transform root = crowd::reference_of(crowd, row, time_s);
    if (crowd.behaviours().has_root_path_play(row))
        root = composed(root, behave::root_transform_at(crowd, row, time_s));
    const crowd::Extent &extent = crowd.extent_of(row);
    const glm::dvec3 centre(crowd.template_of(row).sklsroot.centre);
    out.place = root.position;
    out.centre = root.position + math::rotation_of(root.orientation) * (centre * double(root.scale));
    out.radius = std::fabs(double(root.scale)) * double(extent.sklsroot) + double(extent.slack);
    return is_finite(out.place) && is_finite(out.centre);
}

bool bounds_at(const crowd::Crowd &crowd, uint32_t row, double time_s, double spare, Bounds &out) noexcept
{
    const glm::dvec3 reference = crowd::reference_position_of(crowd, row, time_s);
    if (!is_finite(reference)) return false;
    const crowd::Behaviours &behaviours = crowd.behaviours();
    const crowd::Extent &extent = crowd.extent_of(row);
    const double scale = world_scale_of(crowd, row) * rounding;
    const double way = behaviours.has_root_path_play(row)
                           ? scale * double(behaviours.path(behaviours.root_path_play(row).path).reach)
                           : 0.0;
    const double reach = length_of(crowd.template_of(row).sklsroot.centre) + double(extent.sklsroot);
    out.leaf.reach = rounded_up(scale * reach + double(extent.slack));
    out.leaf.speed = 0;
    out.valid_s = HUGE_VAL;
    double margin = way;
    if (const crowd::Follow *follow = crowd.follows().of(row)) {
        // Different for each, so that those placed at one time are not all placed again at another.
        spare *= 0.5 + 0.5 * double(base::mix(row + 1) >> 11) / 9007199254740992.0;
        const Motion motion = motion_of(*follow);
        const double speed = motion.speed;
        margin += motion.jumps;
        if (speed > 0) margin += spare;
        if (std::isfinite(speed)) out.leaf.speed = rounded_up(speed);
        else margin = HUGE_VAL;
        if (speed > 0 && std::isfinite(speed)) out.valid_s = spare / (speed * rounding);
    }
    out.tight = box_round(reference, way);
    out.leaf.box = box_round(reference, margin);
    return true;
}

}  // namespace claque::scene
