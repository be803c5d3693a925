#include "samples/labels/labeller.h"

#include <algorithm>
#include <cmath>

#include "samples/labels/silhouettes.h"

namespace labels
{

using scenes::check;

namespace
{

// Rows turned round: from the bottom up to from the top down.
template <class Value>
void flip(std::vector<Value> &values, int width, int height, size_t per_pixel)
{
    const size_t row = per_pixel * static_cast<size_t>(width);
    for (size_t y = 0; y < static_cast<size_t>(height) / 2; ++y)
        std::swap_ranges(values.begin() + static_cast<std::ptrdiff_t>(y * row),
                         values.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         values.begin() + static_cast<std::ptrdiff_t>((static_cast<size_t>(height) - 1 - y) * row));
}

// From the world to the eye.
std::array<double, 3> to_eye(const clq_camera &camera, const std::array<double, 3> &world)
{
    const double v[3] = {world[0] - camera.eye[0], world[1] - camera.eye[1], world[2] - camera.eye[2]};
    const float *q = camera.rotation_xyzw;
    const double a = static_cast<double>(q[0]), b = static_cast<double>(q[1]), c = static_cast<double>(q[2]),
                 w = static_cast<double>(q[3]);
    const double t[3] = {2 * (b * v[2] - c * v[1]), 2 * (c * v[0] - a * v[2]), 2 * (a * v[1] - b * v[0])};
    return {v[0] + w * t[0] + b * t[2] - c * t[1], v[1] + w * t[1] + c * t[0] - a * t[2],
            v[2] + w * t[2] + a * t[1] - b * t[0]};
}

std::array<double, 3> from_eye(const clq_camera &camera, const std::array<double, 3> &eye)
{
    clq_camera back = camera;
    for (int k = 0; k < 3; ++k) back.eye[k] = 0, back.rotation_xyzw[k] = -camera.rotation_xyzw[k];
    std::array<double, 3> out = to_eye(back, eye);
    for (size_t k = 0; k < 3; ++k) out[k] += camera.eye[k];
    return out;
}

bool project_eye(const Sample &sample, const std::array<double, 3> &eye, std::array<double, 2> &px)
{
    const float *p = sample.camera.projection;
    const auto row = [&](size_t k) {
        return static_cast<double>(p[k]) * eye[0] + static_cast<double>(p[4 + k]) * eye[1] +
               static_cast<double>(p[8 + k]) * eye[2] + static_cast<double>(p[12 + k]);
    };
    const double w = row(3);
    if (!(w > 0)) return false;
    px = {(row(0) / w + 1) / 2 * sample.width, (1 - row(1) / w) / 2 * sample.height};
    return true;
}

}  // namespace

bool project(const Sample &sample, const std::array<double, 3> &world, std::array<double, 2> &px, double &depth_m)
{
    const std::array<double, 3> eye = to_eye(sample.camera, world);
    depth_m = -eye[2];
    return project_eye(sample, eye, px);
}

Labeller::Labeller(scenes::Library &library, scenes::SceneRenderer &scene, const Wanted &wanted)
    : scene_(scene), wanted_(wanted), skeletons_(library, keypoint_set(wanted.keypoint_set))
{
    const contexts::Offscreen &context = scene.offscreen();
    colour_mask_ = reinterpret_cast<decltype(colour_mask_)>(context.get_proc_address()(context.user(), "glColorMask"));
    if (!colour_mask_) throw scenes::Failure("this OpenGL context lacks glColorMask");
}

// The scenery fills the depth buffer first, unless individuals are drawn without it.
void Labeller::read_numbers(std::vector<uint32_t> &numbers, const uint8_t *drawn)
{
    namespace gl = scenes::gl;
    const scenes::Gl &calls = scene_.gl();
    uint64_t count = 0;
    check(clq_view_get_triangle_count(scene_.view(), &count));
    clq_visibility_def def = clq_visibility_def_init();
    def.drawn = drawn;
    const contexts::Offscreen &context = scene_.offscreen();
    numbers.assign(static_cast<size_t>(context.width()) * static_cast<size_t>(context.height()), 0);
    for (const bool upper : {false, true}) {
        if (upper && count < 1u << 24) break;
        def.upper_bits = upper;
        calls.ClearColor(0, 0, 0, 0);
        calls.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
        if (!drawn) {
            colour_mask_(0, 0, 0, 0);
            scene_.draw_environment();
            colour_mask_(1, 1, 1, 1);
        }
        check(clq_renderer_draw_visibility(scene_.renderer(), scene_.view(), &def, nullptr));
        std::vector<uint8_t> rgb;
        context.read_rgb(rgb);
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] |=
                (rgb[3 * i] | static_cast<uint32_t>(rgb[3 * i + 1]) << 8 | static_cast<uint32_t>(rgb[3 * i + 2]) << 16)
                << (upper ? 24 : 0);
    }
    flip(numbers, context.width(), context.height(), 1);
}

Sample Labeller::label(int frame, double time_s)
{
    Sample out;
    out.frame = frame, out.time_s = time_s;
    out.width = scene_.offscreen().width(), out.height = scene_.offscreen().height();
    out.rgb = wanted_.colours ? scene_.picture(time_s) : std::vector<uint8_t>();
    if (!wanted_.colours) scene_.update(time_s);
    out.camera = scene_.camera_at(time_s);
    read_numbers(numbers_, nullptr);
    take_channels(out);
    take_people(out);
    if (wanted_.silhouettes) measure_silhouettes(out);
    if (wanted_.flow) {
        out.forward = flow_to(time_s + wanted_.step_s, out);
        out.backward = flow_to(time_s - wanted_.step_s, out);
        scene_.place(time_s);
    }
    return out;
}

void Labeller::take_channels(Sample &out)
{
    const size_t count = numbers_.size();
    clq_pixels pixels = clq_pixels_init();
    pixels.width_px = static_cast<uint32_t>(out.width), pixels.height_px = static_cast<uint32_t>(out.height);
    pixels.numbers = numbers_.data();
    std::vector<uint32_t> zones(wanted_.zones ? count : 0), parts(count);
    individuals_.resize(count), out.actor.resize(count);
    if (wanted_.depth || wanted_.keypoints) out.depth_m.resize(count);
    if (wanted_.normals) out.normal.resize(3 * count);
    if (wanted_.positions) out.position.resize(3 * count);
    clq_pixel_channels channels = clq_pixel_channels_init();
    const auto of = [](auto &values) { return values.empty() ? nullptr : values.data(); };
    channels.individuals = individuals_.data(), channels.actors = out.actor.data(), channels.parts = parts.data();
    channels.zones = of(zones), channels.depth_m = of(out.depth_m), channels.normals = of(out.normal);
    channels.positions = of(out.position);
    check(clq_view_get_pixels(scene_.view(), &pixels, &channels));
    const auto one_up = [](uint32_t index) { return static_cast<uint16_t>(index == CLQ_NONE ? 0 : index + 1); };
    for (const uint32_t zone : zones) out.zone.push_back(one_up(zone));
    for (const uint32_t part : parts) out.part.push_back(one_up(part));
    flip(individuals_, out.width, out.height, 1), flip(out.actor, out.width, out.height, 1);
    flip(out.part, out.width, out.height, 1);
    if (!out.zone.empty()) flip(out.zone, out.width, out.height, 1);
    if (!out.depth_m.empty()) flip(out.depth_m, out.width, out.height, 1);
    if (!out.normal.empty()) flip(out.normal, out.width, out.height, 3);
    if (!out.position.empty()) flip(out.position, out.width, out.height, 3);
}

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
        take_box(i, drawn, out, person);
        if (wanted_.keypoints) take_keypoints(drawn, out, person);
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

void Labeller::take_box(uint32_t index, const clq_drawn_actor &drawn, const Sample &sample, Person &out)
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
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(scene_.scene().crowd(), drawn.actor, &info));
    const double scale = std::fabs(static_cast<double>(info.root.scale));
    for (size_t k = 0; k < 3; ++k) out.size_m[k] = scale * (high[k] - low[k]);
    out.centre =
        from_eye(sample.camera, in_eye({(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}));
    for (size_t k = 0; k < 4; ++k) out.rotation_xyzw[k] = static_cast<double>(info.root.orientation_xyzw[k]);
}

Keypoint Labeller::keypoint_at(const clq_drawn_actor &drawn, const Skeletons::Place &place, double radius_m,
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
    // A joint lies within the body: the person's own surface may be in front of it by as much as the limb is thick.
    const bool shown =
        sample.actor[at] == drawn.actor.index1 && static_cast<double>(sample.depth_m[at]) > depth_m - radius_m;
    out.seen = shown ? Seen::visible : Seen::hidden;
    return out;
}

void Labeller::take_keypoints(const clq_drawn_actor &drawn, const Sample &sample, Person &out)
{
    const Skeletons::Skeleton &skeleton = skeletons_.of(drawn.tmpl);
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(scene_.scene().crowd(), drawn.actor, &info));
    const double head_m = skeleton.head_m * std::fabs(static_cast<double>(info.root.scale));
    for (const Skeletons::Place &place : skeleton.places)
        out.keypoints.push_back(keypoint_at(drawn, place, 1.2 * head_m, sample));
    out.head = keypoint_at(drawn, skeleton.head, 1.5 * head_m, sample);
}

void Labeller::measure_silhouettes(Sample &out)
{
    std::vector<Box> boxes(person_of_.size());
    for (size_t i = 0; i < person_of_.size(); ++i) {
        if (person_of_[i] == SIZE_MAX) continue;
        const Box &whole = out.people[person_of_[i]].whole;
        boxes[i] = {std::max(0.0, whole.x0), std::max(0.0, whole.y0), std::min<double>(out.width, whole.x1),
                    std::min<double>(out.height, whole.y1)};
    }
    const std::vector<std::vector<uint32_t>> groups = groups_apart(boxes);
    silhouette_pictures_ = groups.size();
    std::vector<uint32_t> numbers;
    for (const std::vector<uint32_t> &group : groups) {
        std::vector<uint8_t> drawn(person_of_.size(), 0);
        for (const uint32_t one : group) drawn[one] = 1;
        read_numbers(numbers, drawn.data());
        for (const uint32_t one : group) {
            const Box &box = boxes[one];
            const auto within = [](double value, int most) {
                return static_cast<size_t>(std::clamp(value, 0.0, static_cast<double>(most)));
            };
            size_t count = 0;
            for (size_t y = within(std::floor(box.y0) - 1, out.height); y < within(std::ceil(box.y1) + 1, out.height);
                 ++y)
                for (size_t x = within(std::floor(box.x0) - 1, out.width); x < within(std::ceil(box.x1) + 1, out.width);
                     ++x)  // rows of numbers are from the bottom up
                    count +=
                        numbers[(static_cast<size_t>(out.height) - 1 - y) * static_cast<size_t>(out.width) + x] != 0;
            Person &person = out.people[person_of_[one]];
            person.whole_px = count;
        }
    }
}

std::vector<float> Labeller::flow_to(double time_s, const Sample &sample)
{
    scene_.place(time_s);
    clq_pixels pixels = clq_pixels_init();
    pixels.width_px = static_cast<uint32_t>(sample.width), pixels.height_px = static_cast<uint32_t>(sample.height);
    pixels.numbers = numbers_.data();
    clq_flow_def def = clq_flow_def_init();
    def.time_s = time_s, def.camera = scene_.camera_at(time_s);
    std::vector<float> flow(2 * numbers_.size());
    check(clq_view_get_flow(scene_.view(), &pixels, &def, flow.data()));
    flip(flow, sample.width, sample.height, 2);
    for (size_t i = 1; i < flow.size(); i += 2) flow[i] = -flow[i];
    return flow;
}

}  // namespace labels
