#include "samples/cli/portraits.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/posed_template.h"
#include "samples/scenes/template_names.h"

namespace cli
{

using scenes::check;
namespace gl = scenes::gl;

namespace
{

constexpr double fov_deg = 20, half_fov = fov_deg / 2 * 0.017453292519943295;
constexpr double person_m = 1.75;
constexpr double beside_m = 0.10, above_m = 0.12, below_m = 0.16;  // of backdrop round a person

}  // namespace

Portraits::Portraits(scenes::Library &library, const LoadedCharacter &loaded, uint64_t seed)
    : library_(library), loaded_(loaded), seed_(seed), sky_(1, scenes::Sky::Land::studio)
{
    measure();
    build_surroundings();
}

Portraits::~Portraits()
{
    // Textures are freed with their owner, which needs their context current.
    if (offscreen_) offscreen_->make_current();
}

// Prefers a clip that is named for standing, then the start of the first clip, then the modelled pose.
clq_play Portraits::pose() const
{
    clq_play play = {};
    play.clip = scenes::standing_clip(loaded_.tmpl.get());
    if (play.clip == CLQ_NONE && info_of(loaded_.tmpl.get()).clip_count > 0) play.clip = 0;
    return play;
}

void Portraits::measure()
{
    scenes::PosedTemplate posed(library_, loaded_.tmpl.get());
    posed.pose(pose().clip, 0);
    scenes::PoseBox box = posed.box();
    if (box.is_none()) box = {};
    const double longest = std::max({box.size(0), box.size(1), box.size(2)});
    extents_.scale = longest > 0 && std::isfinite(longest) ? person_m / longest : 1;
    const auto middle = [&](size_t axis) { return (box.low[axis] + box.high[axis]) / 2 * extents_.scale; };
    const auto half = [&](size_t axis) { return box.size(axis) / 2 * extents_.scale; };
    const double turned[] = {turn_z_ * middle(0) + turn_x_ * middle(2), middle(1),
                             turn_z_ * middle(2) - turn_x_ * middle(0)};
    const double reach[] = {turn_z_ * half(0) + turn_x_ * half(2), half(1), turn_z_ * half(2) + turn_x_ * half(0)};
    for (int axis = 0; axis < 3; ++axis) {
        extents_.first[axis] = turned[axis] - reach[axis];
        extents_.last[axis] = turned[axis] + reach[axis];
    }
}

double Portraits::aspect() const
{
    return (extents_.last[0] - extents_.first[0] + 2 * (beside_m + room_beside_m_)) / visible_m();
}

double Portraits::visible_m() const { return extents_.last[1] - extents_.first[1] + above_m + room_above_m_ + below_m; }

// A floor that fades into the backdrop.
void Portraits::build_surroundings()
{
    constexpr scenes::Rgb near = {0.60f, 0.59f, 0.57f}, far = scenes::Sky::backdrop;
    constexpr float ahead = 1.2f;  // centre of the floor, towards the eye
    constexpr float radii[] = {2.0f, 2.6f, 3.3f, 4.1f, 5.0f, 40}, shares[] = {0, 0.2f, 0.5f, 0.8f, 1, 1};
    constexpr uint32_t sides = 48, rings = 6;
    const float y = static_cast<float>(extents_.first[1]);
    const uint32_t middle = ground_.add({0, y, ahead}, {0, 1, 0}, 0, 0, near);
    for (uint32_t ring = 0; ring < rings; ++ring)
        for (uint32_t i = 0; i < sides; ++i) {
            const float angle = 6.28318531f * static_cast<float>(i) / sides, k = shares[ring];
            ground_.add({radii[ring] * std::cos(angle), y, ahead - radii[ring] * std::sin(angle)}, {0, 1, 0}, 0, 0,
                        {near.r + (far.r - near.r) * k, near.g + (far.g - near.g) * k, near.b + (far.b - near.b) * k});
        }
    for (uint32_t i = 0; i < sides; ++i) {
        const uint32_t next = (i + 1) % sides;
        ground_.triangle(middle, middle + 1 + i, middle + 1 + next);
        for (uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const uint32_t inner = middle + 1 + ring * sides, outer = inner + sides;
            ground_.triangle(inner + i, outer + i, outer + next);
            ground_.triangle(inner + i, outer + next, inner + next);
        }
    }
}

void Portraits::resize(int width, int height)
{
    renderer_.reset();
    shadows_.reset();
    width_ = width;
    height_ = height;
    std::string why_not;
    offscreen_ = contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why_not);
    if (!offscreen_) throw scenes::Failure("no OpenGL context: " + why_not);
    if (!scenes::load(gl_, offscreen_->get_proc_address(), offscreen_->user(), why_not))
        throw scenes::Failure("this OpenGL context lacks " + why_not);
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = offscreen_->get_proc_address();
    def.user = offscreen_->user();
    clq_renderer *made = nullptr;
    check(clq_renderer_create(library_.context(), &def, &made));
    renderer_.reset(made);
    check(clq_renderer_prepare(made, loaded_.tmpl.get()));
    shadows_ = std::make_unique<scenes::Shadows>();
    const auto middle = [this](int axis) { return (extents_.first[axis] + extents_.last[axis]) / 2; };
    const auto half = [this](int axis) { return (extents_.last[axis] - extents_.first[axis]) / 2; };
    // Leaves out spread arms, whose shadow is negligible.
    const double wide = std::min(half(0), std::max(half(2), 0.22)) * 1.15 + 0.10, deep = half(2) * 1.15 + 0.10;
    shadows_->ring(static_cast<float>(middle(0)), static_cast<float>(extents_.first[1]),
                   static_cast<float>(middle(2)) - 0.02f, static_cast<float>(wide), static_cast<float>(deep));
    shadows_->prepare(gl_);
}

clq_camera Portraits::camera() const
{
    const double low = extents_.first[1] - below_m, high = extents_.last[1] + above_m + room_above_m_;
    const double wide = extents_.last[0] - extents_.first[0] + 2 * (beside_m + room_beside_m_);
    const double shape = static_cast<double>(width_) / height_;
    const double seen = std::max(high - low, wide / shape), tangent = std::sin(half_fov) / std::cos(half_fov);
    const double away = seen / 2 / tangent + extents_.last[2];
    const double x = (extents_.first[0] + extents_.last[0]) / 2, y = (low + high) / 2;
    const double eye[3] = {x, y + 0.12 * away, extents_.last[2] + away * 0.992}, target[3] = {x, y, 0};
    return scenes::look(eye, target, fov_deg, shape, away * 0.05, away * 12 + 60);
}

// The scale that selects the wanted level at the camera's distance.
float Portraits::lod_scale(const clq_camera &seen) const
{
    if (level_ == 0) return 0;
    clq_level_info level = clq_level_info_init(), next = level;
    check(clq_template_get_level(loaded_.tmpl.get(), level_, &level));
    double wanted = 2 * static_cast<double>(level.lod_min_m);
    if (level_ + 1 < info_of(loaded_.tmpl.get()).level_count) {
        check(clq_template_get_level(loaded_.tmpl.get(), level_ + 1, &next));
        wanted = (static_cast<double>(level.lod_min_m) + static_cast<double>(next.lod_min_m)) / 2;
    }
    const double away = std::hypot(seen.eye[0], seen.eye[1], seen.eye[2]);
    return static_cast<float>(wanted / away * extents_.scale);
}

const std::vector<uint8_t> &Portraits::picture(uint32_t person)
{
    return picture(
        person, [](clq_crowd *, clq_actor) {}, 0);
}

const std::vector<uint8_t> &Portraits::picture(uint32_t person, const Command &command, double time_s)
{
    scenes::CrowdOptions crowd_options;
    const clq_camera seen = camera();
    crowd_options.count = 1;
    crowd_options.seed = seed_;
    crowd_options.lod_scale = lod_scale(seen);
    scenes::SceneCrowd cast(library_, crowd_options);
    const clq_transform place = scenes::stand(0, 0, 0, turn_x_, turn_z_, static_cast<float>(extents_.scale));
    cast.enter({loaded_.tmpl.get(), place, pose()}, person, {});
    command(cast.crowd(), cast.actors()[0]);
    clq_view *made = nullptr;
    check(clq_view_create(cast.crowd(), &made));
    const scenes::Own<clq_view> view(made);
    check(clq_view_set_camera(made, &seen));
    check(clq_view_set_height(made, 0));  // the camera's narrow angle must not raise the detail
    check(clq_crowd_update(cast.crowd(), time_s, &made, 1));
    clq_actor_info shown = clq_actor_info_init();
    check(clq_actor_get_info(cast.crowd(), cast.actors()[0], &shown));
    if (shown.level != level_)
        throw scenes::Failure("level " + std::to_string(level_) + " was requested, and level " +
                              std::to_string(shown.level) + " was");
    const scenes::Eye eye = scenes::eye_of(seen);
    gl_.Viewport(0, 0, width_, height_);
    gl_.DepthMask(1);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    scenes::set_lights(gl_, light_, eye);
    gl_.Disable(gl::lighting);
    ground_.draw(gl_);
    sky_.draw(gl_, eye);
    gl_.Disable(gl::lighting);
    shadows_->draw(gl_);
    gl_.Enable(gl::lighting);
    check(clq_renderer_draw(renderer_.get(), made, nullptr));
    offscreen_->read_rgb(rgb_);
    return rgb_;
}

}  // namespace cli
