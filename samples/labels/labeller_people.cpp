// What a labeller says of people: their boxes, joints and visible pixels.
#include <algorithm>
#include <cmath>

#include "samples/labels/labeller.h"
#include "samples/labels/projection.h"

namespace labels
{

using scenes::check;

void Labeller::take_people(Sample &out)
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(scene_.view(), &stats));
    std::vector<std::pair<uint32_t, Person>> found;  // with the individual
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor drawn = clq_drawn_actor_init();
        check(clq_view_get_drawn_actor(scene_.view(), i, &drawn));
        if (drawn.shadow_only) continue;
        Person person;
        person.actor = drawn.actor.index1;
        clq_template_info info = clq_template_info_init();
        check(clq_template_get_info(drawn.tmpl, &info));
        person.character = info.name;
        clq_actor_info actor = clq_actor_info_init();
        check(clq_actor_get_info(scene_.scene().crowd(), drawn.actor, &actor));
        take_box(i, drawn, actor.root, out, person);
        if (wanted_.keypoints) take_keypoints(drawn, actor.root, out, person);
        found.emplace_back(i, std::move(person));
    }
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) { return a.second.actor < b.second.actor; });
    person_of_.assign(stats.visible, SIZE_MAX);
    for (auto &[individual, person] : found) {
        person_of_[individual] = out.people.size();
        out.people.push_back(std::move(person));
    }
    for (size_t i = 0; i < individuals_.size(); ++i) {
        if (individuals_[i] == CLQ_NONE) continue;
        Person &person = out.people[person_of_[individuals_[i]]];
        const double x = static_cast<double>(i % static_cast<size_t>(out.width)),
                     y = static_cast<double>(i / static_cast<size_t>(out.width));
        Box &box = person.visible;
        if (person.visible_px++ == 0) box = {x, y, x + 1, y + 1};
        box.x0 = std::min(box.x0, x), box.y0 = std::min(box.y0, y);
        box.x1 = std::max(box.x1, x + 1), box.y1 = std::max(box.y1, y + 1);
    }
}

void Labeller::take_box(uint32_t index, const clq_drawn_actor &drawn, const clq_transform &root, const Sample &sample,
                        Person &out)
{
    std::vector<float> xyz(3 * static_cast<size_t>(drawn.vertex_count));
    check(clq_view_get_vertices(scene_.view(), index, xyz.data(), nullptr, drawn.vertex_count));
    const float *m = drawn.model_view;
    const auto in_eye = [&](const std::array<double, 3> &p) {
        std::array<double, 3> eye;
        for (size_t r = 0; r < 3; ++r)
            eye[r] = static_cast<double>(m[r]) * p[0] + static_cast<double>(m[4 + r]) * p[1] +
                     static_cast<double>(m[8 + r]) * p[2] + static_cast<double>(m[12 + r]);
        return eye;
    };
    std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    Box box = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    bool beyond = false;  // a vertex behind the eye: the box then has no end
    for (size_t v = 0; v < drawn.vertex_count; ++v) {
        const std::array<double, 3> p = {static_cast<double>(xyz[3 * v]), static_cast<double>(xyz[3 * v + 1]),
                                         static_cast<double>(xyz[3 * v + 2])};
        for (size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
        std::array<double, 2> px;
        if (!project_eye(sample, in_eye(p), px)) beyond = true;
        else {
            box.x0 = std::min(box.x0, px[0]), box.y0 = std::min(box.y0, px[1]);
            box.x1 = std::max(box.x1, px[0]), box.y1 = std::max(box.y1, px[1]);
        }
    }
    if (beyond) box = {0, 0, static_cast<double>(sample.width), static_cast<double>(sample.height)};
    out.whole = box;
    const double scale = std::fabs(static_cast<double>(root.scale));
    for (size_t k = 0; k < 3; ++k) out.size_m[k] = scale * (high[k] - low[k]);
    out.centre =
        from_eye(sample.camera, in_eye({(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}));
    for (size_t k = 0; k < 4; ++k) out.rotation_xyzw[k] = static_cast<double>(root.orientation_xyzw[k]);
}

Keypoint Labeller::keypoint_at(const clq_drawn_actor &drawn, const Skeletons::Place &place, double below_m,
                               const Sample &sample) const
{
    Keypoint out;
    if (place.node == CLQ_NONE) return out;
    double m[16];
    check(clq_actor_get_node(scene_.scene().crowd(), drawn.actor, place.node, sample.time_s, m));
    for (size_t k = 0; k < 3; ++k)
        out.world[k] = m[12 + k] + m[k] * place.at[0] + m[4 + k] * place.at[1] + m[8 + k] * place.at[2];
    out.seen = Seen::outside;
    double depth_m = 0;
    if (!project(sample, out.world, out.px, depth_m)) return out;
    const double x = std::floor(out.px[0]), y = std::floor(out.px[1]);
    if (x < 0 || y < 0 || x >= sample.width || y >= sample.height) return out;
    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(sample.width) + static_cast<size_t>(x);
    // A joint lies within the body: the person's own surface may be in front of it.
    const bool shown =
        sample.actor[at] == drawn.actor.index1 && static_cast<double>(sample.depth_m[at]) > depth_m - below_m;
    out.seen = shown ? Seen::visible : Seen::hidden;
    return out;
}

void Labeller::take_keypoints(const clq_drawn_actor &drawn, const clq_transform &root, const Sample &sample,
                              Person &out)
{
    const Skeletons::Skeleton &skeleton = skeletons_.of(drawn.tmpl);
    const double scale = std::fabs(static_cast<double>(root.scale));
    for (const Skeletons::Place &place : skeleton.places)
        out.keypoints.push_back(keypoint_at(drawn, place, scale * place.below_m, sample));
    out.head = keypoint_at(drawn, skeleton.head, scale * skeleton.head.below_m, sample);
}

}  // namespace labels
