#include "tests/visibility/people.h"

#include <cmath>

#include "samples/scenes/gl.h"
#include "tests/gl/support/absent.h"

namespace visibility_test
{

using scenes::check;

void People::SetUp()
{
    std::string why_not;
    context_ = contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why_not);
    if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = context_->get_proc_address(), def.user = context_->user();
    clq_renderer *made = nullptr;
    check(clq_renderer_create(library_.context(), &def, &made));
    renderer_.reset(made);
}

void People::TearDown()
{
    renderer_.reset();
    crowd_.reset();
}

void People::place(uint64_t seed, size_t count)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.period_near_s = def.period_far_s = 0;
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library_.context(), &def, &crowd));
    crowd_.reset(crowd);
    check(clq_view_create(crowd, &view_));
    actors_.clear();
    std::mt19937_64 random(seed);
    const auto between = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random() % 1000001) / 1000000;
    };
    const char *const names[] = {"citizen", "patrician", "decurion", "plebeian", "owl"};
    for (size_t i = 0; i < count; ++i) {
        const std::string name = names[random() % 5];
        // The owl consists of rigid parts with levels of their own.
        clq_template *tmpl = name == "owl" ? library_.builtin(name) : library_.builtin(name, {400, 120, 40});
        check(clq_renderer_prepare(renderer_.get(), tmpl));
        clq_template_info info = clq_template_info_init();
        check(clq_template_get_info(tmpl, &info));
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = tmpl;
        actor_def.seed = random();
        actor_def.play.clip = static_cast<uint32_t>(random() % info.clip_count);
        actor_def.play.phase_s = static_cast<float>(between(0, 3));
        actor_def.transform.position[0] = between(-1.5, 1.5), actor_def.transform.position[2] = between(-3, 0.5);
        if (name == "owl") actor_def.transform.position[1] = between(0.5, 1.6);
        const double turn = between(0, 6.28);
        actor_def.transform.orientation_xyzw[1] = static_cast<float>(std::sin(turn / 2));
        actor_def.transform.orientation_xyzw[3] = static_cast<float>(std::cos(turn / 2));
        actor_def.transform.scale = static_cast<float>(between(0.8, 1.2)) * (i % 4 == 3 ? -1.0f : 1.0f);
        clq_actor actor = {};
        check(clq_actor_create(crowd, &actor_def, &actor));
        check(clq_actor_randomise_colours(crowd, actor, nullptr, 0));
        actors_.push_back(actor);
    }
    clq_look_at_def look = clq_look_at_def_init();
    // Never among them: rays know no near plane.
    const double away = between(3.6, 14), angle = between(0, 6.28);
    look.eye[0] = away * std::sin(angle), look.eye[1] = between(0.2, 3), look.eye[2] = -1 + away * std::cos(angle);
    look.target[1] = between(0.6, 1.4), look.target[2] = -1;
    look.fov_y_rad = static_cast<float>(between(0.15, 1));
    look.z_near = 0.05f, look.z_far = 60;
    check(clq_camera_look_at(&look, &camera_));
    check(clq_view_set_camera(view_, &camera_));
    check(clq_view_set_height(view_, static_cast<float>(height)));
}

void People::update(double time_s) { check(clq_crowd_update(crowd_.get(), time_s, &view_, 1)); }

const std::vector<uint32_t> &People::draw(const clq_visibility_def &def)
{
    namespace gl = scenes::gl;
    scenes::Gl calls;
    std::string missing;
    EXPECT_TRUE(load(calls, context_->get_proc_address(), context_->user(), missing)) << missing;
    calls.ClearColor(0, 0, 0, 0);
    calls.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    check(clq_renderer_draw_visibility(renderer_.get(), view_, &def, nullptr));
    std::vector<uint8_t> rgb;
    context_->read_rgb(rgb);
    numbers_.resize(static_cast<size_t>(width) * height);
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x) {
            const uint8_t *from = &rgb[3 * ((height - 1 - y) * width + x)];
            numbers_[y * width + x] =
                from[0] | static_cast<uint32_t>(from[1]) << 8 | static_cast<uint32_t>(from[2]) << 16;
        }
    first_number_ = def.first_number;
    return numbers_;
}

clq_pixels People::pixels() const
{
    clq_pixels out = clq_pixels_init();
    out.width_px = width, out.height_px = height, out.first_number = first_number_, out.numbers = numbers_.data();
    return out;
}

Channels People::channels() const
{
    Channels out;
    clq_pixel_channels channels = clq_pixel_channels_init();
    const auto room = [](auto &of, size_t per_pixel) {
        of.resize(per_pixel * width * height);
        return of.data();
    };
    channels.individuals = room(out.individuals, 1), channels.actors = room(out.actors, 1);
    channels.parts = room(out.parts, 1), channels.zones = room(out.zones, 1);
    channels.triangles = room(out.triangles, 1), channels.barycentric = room(out.barycentric, 3);
    channels.depth_m = room(out.depth_m, 1), channels.positions = room(out.positions, 3);
    channels.normals = room(out.normals, 3);
    const clq_pixels given = pixels();
    check(clq_view_get_pixels(view_, &given, &channels));
    return out;
}

}  // namespace visibility_test
