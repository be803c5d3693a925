// A field full of people: S3's test scene (section 5). Two templates with three levels of detail, five clips and four
// textures (two for each template); each individual has a clip, a phase and colours of its own. The scene
// `ten_thousand` is the same field with four templates in chains of levels, with ten thousand in view at once.
#include <array>
#include <cmath>
#include <optional>

#include "samples/scenes/light_map.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/sky.h"

namespace scenes
{
namespace
{

constexpr double spacing_m = 1.2, jitter_m = 0.28, ground_m = 600;
constexpr float height_m = 1.75f, shadow_width_m = 0.95f;
constexpr std::array<const char *, 5> clips = {"applaud", "cheer", "stand_laugh", "stand_wave", "stand"};

constexpr uint32_t cells = 28;  // of the ground, across

// Coordinate of the line between cells, in metres from the centre.
double line_m(uint32_t i)
{
    const double t = 2.0 * i / cells - 1;
    return ground_m * (0.25 * t + 0.75 * t * t * t);
}

// The last line before the people in rows of `side` and their shadows.
uint32_t first_worn(uint32_t side)
{
    constexpr double shadow_m = 4;
    uint32_t i = cells / 2 - 1;
    while (i > 0 && -line_m(i) < side * spacing_m / 2 + shadow_m) --i;
    return i;
}

enum class View { among, whole };  // of the overview: some of the people, or all

std::vector<clq_template *> in_levels(Library &library, const std::vector<const char *> &names,
                                      const std::vector<uint32_t> &levels)
{
    std::vector<clq_template *> made;
    for (const char *name : names) made.push_back(library.builtin(name, levels));
    return made;
}

class Multitude final : public Scene
{
public:
    Multitude(Library &library, const CrowdOptions &crowd_options, std::vector<clq_template *> templates, View view)
        : seed_(crowd_options.seed),
          side_(static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<double>(crowd_options.count))))),
          templates_(std::move(templates)),
          view_(view),
          scene_crowd_(library, crowd_options),
          sky_(crowd_options.seed, Sky::Land::hills),
          painted_(static_cast<float>(line_m(first_worn(side_))), static_cast<float>(-line_m(first_worn(side_))))
    {
        for (uint32_t person = 0; person < crowd_options.count; ++person) enter(person);
        lay_ground();
        shadows_.cast(scene_crowd_.places(), light_.to_sun, height_m, shadow_width_m);
        if (view_ == View::whole) painted_.paint(shadows_);
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return templates_; }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const double half = side_ * spacing_m / 2;
        if (shot == Shot::close) return look({1.5, 2.1, half + 5}, {0, 1.1, half - 2}, 40, aspect, 0.3, 900);
        if (view_ == View::whole)
            return look({0, 0.9 * half + 4, 2.7 * half + 6}, {0, 0, 0.1 * half}, 40, aspect, 1, 900);
        return look({0, 0.55 * half + 4, 1.7 * half + 6}, {0, 0, 0.2 * half}, 48, aspect, 1, 900);
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        paints_people_ = false;
        def = shadows_in(light_);
        return true;
    }

    void place(double) override {}
    void prepare(const Gl &gl) override
    {
        shadows_.prepare(gl);
        if (view_ == View::whole) shade_.emplace(gl, painted_.image(), true, Texture::Filter::nearest);
    }

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::texture_2d);
        ground_.draw(g);
        const bool in_texture = paints_people_ && shade_ && afar(eye);
        if (in_texture) shade_->use();
        worn_.draw(g);
        sky_.draw(g, eye, ground_m);
        if (paints_people_ && !in_texture) shadows_.draw(g);
    }

private:
    // From that distance all shadows are a few pixels, most of them behind people, who stand still. Ten thousand
    // blended triangles would take as long as half of the people.
    bool afar(const Eye &eye) const { return view_ == View::whole && eye.position[2] > side_ * spacing_m; }
    void enter(uint32_t person)
    {
        clq_template *tmpl = templates_[static_cast<size_t>(random_unit(seed_, person, Purpose::seat) *
                                                            static_cast<double>(templates_.size()))];
        const double middle = (side_ - 1) / 2.0;
        const double x =
            (person % side_ - middle) * spacing_m + random_between(seed_, person, Purpose::place_x, -1, 1) * jitter_m;
        const double z =
            (middle - person / side_) * spacing_m + random_between(seed_, person, Purpose::place_z, -1, 1) * jitter_m;
        const double turn = random_between(seed_, person, Purpose::heading, -0.5, 0.5);
        clq_play play = {};
        play.clip = clq_template_find_clip(tmpl, clips[random_bits(seed_, person, Purpose::clip) % clips.size()]);
        play.speed = 1;
        clq_clip_info info = clq_clip_info_init();
        check(clq_template_get_clip(tmpl, play.clip, &info));
        play.phase_s = static_cast<float>(random_unit(seed_, person, Purpose::phase) * info.duration_s);
        const float size = static_cast<float>(random_between(seed_, person, Purpose::size, 0.94, 1.06));
        scene_crowd_.enter({tmpl, stand(x, 0, z, std::sin(turn), std::cos(turn), size), play});
    }

    // Grass, worn under the people; cells grow outwards. Cells with people or their shadows are apart from the others.
    void lay_ground()
    {
        const double worn = side_ * spacing_m / 2;
        const uint32_t first = first_worn(side_);
        for (uint32_t row = 0; row <= cells; ++row)
            for (uint32_t column = 0; column <= cells; ++column) {
                const double x = line_m(column), z = line_m(row);
                const double out = std::max(std::abs(x), std::abs(z)) - worn;
                const float grass = static_cast<float>(out < -4 ? 0.0 : out > 6 ? 1.0 : (out + 4) / 10);
                const float tone =
                    static_cast<float>(random_between(seed_, row * (cells + 1) + column, Purpose::tone, 0.9, 1.08));
                const Rgb colour = {0.52f - 0.16f * grass, 0.47f - 0.02f * grass, 0.34f - 0.10f * grass};
                const Vec3 at = {static_cast<float>(x), 0, static_cast<float>(z)};
                for (Geometry *part : {&ground_, &worn_})
                    part->add(at, {0, 1, 0}, painted_.coordinate(at.x), painted_.coordinate(at.z), colour * tone);
            }
        for (uint32_t row = 0; row < cells; ++row)
            for (uint32_t column = 0; column < cells; ++column) {
                const uint32_t a = row * (cells + 1) + column, below = a + cells + 1;
                const auto is_worn = [&](uint32_t i) { return i >= first && i < cells - first; };
                Geometry &part = is_worn(row) && is_worn(column) ? worn_ : ground_;
                part.triangle(a, below, below + 1);
                part.triangle(a, below + 1, a + 1);
            }
    }

    uint64_t seed_;
    uint32_t side_;                          // people in each row
    std::vector<clq_template *> templates_;  // owned by the library
    View view_;
    SceneCrowd scene_crowd_;
    Daylight light_;
    Sky sky_;
    LightMap painted_;
    std::optional<Texture> shade_;  // of painted_
    Geometry ground_, worn_;
    Shadows shadows_;
    bool paints_people_ = true;
};

}  // namespace

std::unique_ptr<Scene> make_multitude(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Multitude>(library, crowd_options,
                                       in_levels(library, {"decurion", "patrician"}, multitude_levels), View::among);
}

// As from twice the distance: levels begin where twice their root mean square error is two pixels, not one.
std::unique_ptr<Scene> make_ten_thousand(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    const std::vector<const char *> all = {"citizen", "patrician", "decurion", "plebeian"};
    CrowdOptions coarse = crowd_options;
    coarse.lod_scale *= 2;
    return std::make_unique<Multitude>(library, coarse, in_levels(library, all, {}), View::whole);
}

}  // namespace scenes
