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

}  // namespace

Labeller::Labeller(scenes::Library &library, scenes::SceneRenderer &scene, const Wanted &wanted)
    : scene_(scene), wanted_(wanted), skeletons_(library, *wanted.keypoint_set)
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
            scene_.begin_picture();
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
    Sample out = begin(frame, time_s);
    finish(out);
    return out;
}

std::optional<Sample> Labeller::label_if(int frame, double time_s, const std::function<bool(const Sample &)> &wanted)
{
    Sample out = begin(frame, time_s);
    if (!wanted(out)) return std::nullopt;
    finish(out);
    return out;
}

Sample Labeller::begin(int frame, double time_s)
{
    Sample out;
    out.frame = frame, out.time_s = time_s;
    out.width = scene_.offscreen().width(), out.height = scene_.offscreen().height();
    out.rgb = wanted_.colours ? scene_.picture(time_s) : std::vector<uint8_t>();
    if (!wanted_.colours) scene_.update(time_s);
    wanted_.drawn();
    if (wanted_.scene_depth) scene_.offscreen().read_depth(out.scene_depth);
    out.camera = scene_.camera_at(time_s);
    read_numbers(numbers_, nullptr);
    take_channels(out);
    take_people(out);
    return out;
}

void Labeller::finish(Sample &out)
{
    if (wanted_.silhouettes) measure_silhouettes(out);
    if (!wanted_.flow) return;
    out.forward = flow_to(out.time_s + wanted_.step_s, out);
    out.backward = flow_to(out.time_s - wanted_.step_s, out);
    scene_.place(out.time_s);
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
