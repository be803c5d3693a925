#include "samples/scenes/posed_template.h"

#include <algorithm>

namespace scenes
{

void PoseBox::hold(const std::array<double, 3> &point)
{
    for (size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
    }
}

void PoseBox::hold(const PoseBox &other)
{
    if (other.is_none()) return;
    hold(other.low), hold(other.high);
}

PosedTemplate::PosedTemplate(Library &library, const clq_template *tmpl) : tmpl_(tmpl)
{
    check(clq_template_get_info(tmpl, &info_));
    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.period_near_s = crowd_def.period_far_s = crowd_def.lod_scale = 0;
    crowd_def.cache = CLQ_CACHE_NONE;
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), &crowd_def, &crowd));
    crowd_.reset(crowd);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = const_cast<clq_template *>(tmpl);
    def.play.clip = CLQ_NONE;
    check(clq_actor_create(crowd, &def, &actor_));
    check(clq_view_create(crowd, &view_));
}

void PosedTemplate::pose(uint32_t clip, double time_s)
{
    clq_play play = clq_play_init();
    play.clip = clip, play.speed = 0, play.phase_s = static_cast<float>(time_s);
    check(clq_actor_play(crowd_.get(), actor_, &play));
}

std::array<double, 16> PosedTemplate::node(uint32_t node) const
{
    std::array<double, 16> m;
    check(clq_actor_get_node(crowd_.get(), actor_, node, 0, m.data()));
    return m;
}

void PosedTemplate::show()
{
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(crowd_.get(), actor_, &info));
    if (info.refpoint_radius > 0) away_ = 4 * static_cast<double>(info.refpoint_radius);  // a sphere round the origin
    clq_look_at_def look = clq_look_at_def_init();
    look.target[2] = 0, look.eye[2] = away_;
    look.z_near = static_cast<float>(away_ / 100), look.z_far = static_cast<float>(4 * away_);
    clq_camera camera = {};
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view_, &camera));
    check(clq_crowd_update(crowd_.get(), 0, &view_, 1));
    check(clq_view_get_drawn_actor(view_, 0, &drawn_));
}

std::vector<float> PosedTemplate::vertices()
{
    show();
    std::vector<float> xyz(3 * static_cast<size_t>(drawn_.vertex_count));
    check(clq_view_get_vertices(view_, 0, xyz.data(), nullptr, drawn_.vertex_count));
    return xyz;
}

PoseBox PosedTemplate::box()
{
    PoseBox out = PoseBox::none();
    if (info_.vertex_count == 0) return out;
    const std::vector<float> xyz = vertices();
    const float *const m = drawn_.model_view;
    for (size_t v = 0; v < xyz.size(); v += 3) {
        std::array<double, 3> at = {0, 0, away_};  // the eye looks along -z, unturned
        for (size_t axis = 0; axis < 3; ++axis)
            at[axis] += static_cast<double>(m[axis] * xyz[v] + m[4 + axis] * xyz[v + 1] + m[8 + axis] * xyz[v + 2] +
                                            m[12 + axis]);
        out.hold(at);
    }
    return out;
}

double PosedTemplate::length_s(uint32_t clip) const
{
    clq_clip_info info = clq_clip_info_init();
    check(clq_template_get_clip(tmpl_, clip, &info));
    return static_cast<double>(info.duration_s);
}

std::vector<PoseBox> PosedTemplate::boxes_of_clip(uint32_t clip, uint32_t poses)
{
    constexpr double end = 0.9999;  // at 1 it begins again
    std::vector<PoseBox> out;
    for (uint32_t k = 0; k < poses; ++k) {
        pose(clip, length_s(clip) * end * k / std::max(1u, poses - 1));
        out.push_back(box());
    }
    return out;
}

PoseBox PosedTemplate::box_of_clip(uint32_t clip, uint32_t poses)
{
    PoseBox out = PoseBox::none();
    for (const PoseBox &box : boxes_of_clip(clip, poses)) out.hold(box);
    return out;
}

// The first clips give the box, each at its middle time, since rest poses spread their arms. Sideways it is their mean.
// Upwards one clip gives it: some sit, a few raise their arms, and two thirds are no higher than one that stands. Its
// ground is the lowest point of all its poses, as it may jump in the middle.
PoseBox standing_box(PosedTemplate &posed, uint32_t first_clip, bool one_clip)
{
    constexpr uint32_t most = 8, poses = 9;
    const uint32_t first = std::min(first_clip, posed.info().clip_count);
    const uint32_t clips = std::min(posed.info().clip_count - first, one_clip ? 1 : most);
    posed.pose(CLQ_NONE, 0);
    if (clips == 0 || posed.info().vertex_count == 0) return posed.box();
    struct Upwards {
        uint32_t clip;
        double high, size;
    };
    std::vector<Upwards> upwards;
    PoseBox out = {};
    for (uint32_t i = 0; i < clips; ++i) {
        posed.pose(first + i, posed.length_s(first + i) / 2);
        const PoseBox box = posed.box();
        for (size_t axis = 0; axis < 3; ++axis)
            out.low[axis] += box.low[axis] / clips, out.high[axis] += box.high[axis] / clips;
        upwards.push_back({first + i, box.high[1], box.size(1)});
    }
    const auto chosen = upwards.begin() + static_cast<std::ptrdiff_t>(upwards.size() * 2 / 3);
    std::nth_element(upwards.begin(), chosen, upwards.end(),
                     [](const Upwards &a, const Upwards &b) { return a.size < b.size; });
    out.low[1] = posed.box_of_clip(chosen->clip, poses).low[1];
    out.high[1] = chosen->high;
    return out;
}

}  // namespace scenes
