#include "samples/view/designer/line_up.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/light.h"
#include "samples/scenes/posed_template.h"
#include "samples/scenes/random.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/studio_ground.h"

namespace view
{
namespace
{

constexpr double person_m = 1.75, across_m = 0.85, deep_m = 1.1, gap_m = 0.7;
constexpr double fov_deg = 30, half_fov = fov_deg / 2 * 0.017453292519943295;

class LineUp final : public scenes::Scene, public Countable
{
public:
    LineUp(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
           const std::vector<scenes::Character> &characters)
        : seed_(crowd_options.seed),
          characters_(characters),
          crowd_(library, crowd_options),
          sky_(crowd_options.seed, scenes::Sky::Land::studio)
    {
        for (const scenes::Character &one : characters_) {
            scenes::PosedTemplate posed(library, one.tmpl);
            const scenes::PoseBox box = scenes::standing_box(posed, one.first_clip, one.one_clip);
            scales_.push_back(box.size(1) > 0 ? person_m / box.size(1) : 1);
            grounds_.push_back(box.is_none() ? 0 : box.low[1] * scales_.back());
        }
        set_count(crowd_options.count);
    }

    clq_crowd *crowd() const override { return crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return actors_; }
    std::vector<clq_template *> templates() const override
    {
        std::vector<clq_template *> all;
        for (const scenes::Character &one : characters_) all.push_back(one.tmpl);
        return all;
    }

    clq_camera camera(scenes::Shot shot, double aspect, double) const override
    {
        const bool close = shot == scenes::Shot::close;
        const double half = std::tan(half_fov), wide = close ? std::min(width_m_, 2.4) : width_m_;
        const double back = close ? 0 : (rows_ - 1) * deep_m, high = person_m + (close ? 0.15 : 0.35);
        const double pitch = back > 0 ? 0.30 : 0.08;
        const double tall = high * std::cos(pitch) + back * std::sin(pitch);
        const double distance = std::max(tall / 2 / half, wide / 2 / (half * aspect)) * 1.08 + back / 2;
        const double target[3] = {0, person_m / 2, -back / 2};
        return scenes::look({0, target[1] + distance * std::sin(pitch), target[2] + distance * std::cos(pitch)}, target,
                            fov_deg, aspect, distance * 0.02, distance * 40 + 100);
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        paints_people_ = false;
        def = scenes::shadows_in(light_);
        def.ground = CLQ_SHADOW_GROUND_PLANE;
        return true;
    }
    void place(double) override {}
    void prepare(const scenes::Gl &gl) override { shadows_.prepare(gl); }
    void set_light(const scenes::Gl &g, const scenes::Eye &eye) const override { scenes::set_lights(g, light_, eye); }
    void draw_environment(const scenes::Gl &g, const scenes::Eye &eye) const override
    {
        g.Disable(scenes::gl::lighting);
        ground_.draw(g);
        sky_.draw(g, eye);
        if (!paints_people_) return;
        shadows_.cast(places_, light_.to_sun, static_cast<float>(person_m), 0.9f);
        shadows_.draw(g);
    }

    void set_count(uint32_t count) override
    {
        const size_t wanted = std::max(1u, count);
        while (actors_.size() > wanted) {
            scenes::check(clq_actor_destroy(crowd(), actors_.back()));
            actors_.pop_back();
        }
        while (actors_.size() < wanted) enter();
        stand_up();
        scenes::check(
            clq_crowd_set_transforms(crowd(), actors_.data(), places_.data(), static_cast<uint32_t>(actors_.size())));
        lay_ground();
    }

private:
    void enter()
    {
        const size_t person = actors_.size();
        const scenes::Character &character = characters_[person % characters_.size()];
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = character.tmpl;
        def.play = standing(character.tmpl, person);
        def.seed = person;
        def.texture_set = CLQ_RANDOM;
        clq_actor actor = {};
        scenes::check(clq_actor_create(crowd(), &def, &actor));
        actors_.push_back(actor);
        scenes::check(clq_actor_randomise_colours(crowd(), actor, nullptr, 0));
    }

    clq_play standing(const clq_template *tmpl, size_t person) const
    {
        clq_play play = {};
        const char *const names[] = {"stand", "stand_look", "stand_shift"};
        play.clip = clq_template_find_clip(tmpl, names[person / characters_.size() % 3]);
        if (play.clip == CLQ_NONE) play.clip = clq_template_find_clip(tmpl, "idle");
        clq_template_info info = clq_template_info_init();
        scenes::check(clq_template_get_info(tmpl, &info));
        if (play.clip == CLQ_NONE && info.clip_count > 0) play.clip = static_cast<uint32_t>(person % info.clip_count);
        play.speed = static_cast<float>(scenes::random_between(seed_, person, scenes::Purpose::speed, 0.9, 1.1));
        clq_clip_info clip = clq_clip_info_init();
        if (play.clip != CLQ_NONE && clq_template_get_clip(tmpl, play.clip, &clip) == CLQ_OK)
            play.phase_s =
                static_cast<float>(scenes::random_unit(seed_, person, scenes::Purpose::phase)) * clip.duration_s;
        return play;
    }

    void stand_up()
    {
        const size_t blocks = std::min(characters_.size(), actors_.size());
        const size_t most = (actors_.size() + blocks - 1) / blocks;  // of one block
        const auto columns =
            static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(most) * 2 / static_cast<double>(blocks))));
        rows_ = static_cast<int>((most + columns - 1) / columns);
        const double block_m = static_cast<double>(columns - 1) * across_m;
        const double step_m = block_m + across_m + gap_m;
        width_m_ = static_cast<double>(blocks - 1) * step_m + block_m + across_m;
        places_.clear();
        for (size_t person = 0; person < actors_.size(); ++person) {
            const size_t block = person % characters_.size(), at = person / characters_.size();
            const size_t column = at % columns, row = at / columns;
            const double stagger = (row % 2 == 1 ? 0.15 : -0.15) * (rows_ > 1 ? across_m : 0);
            const double x = -width_m_ / 2 + across_m / 2 + static_cast<double>(block) * step_m +
                             static_cast<double>(column) * across_m + stagger;
            places_.push_back(scenes::stand(x, std::fabs(grounds_[block]) < 0.15 ? 0 : -grounds_[block],
                                            -static_cast<double>(row) * deep_m, 0, 1,
                                            static_cast<float>(scales_[block])));
        }
    }

    void lay_ground()
    {
        const double reach = 3 + 1.2 * (width_m_ + rows_ * deep_m);
        ground_.clear();
        scenes::lay_studio_ground(ground_, 0, 0, 0, 40 * reach, 4 * reach);
    }

    uint64_t seed_;
    std::vector<scenes::Character> characters_;
    // Metres in a unit of each, so that it is as tall as a person, and the metres of its lowest point.
    std::vector<double> scales_, grounds_;
    scenes::SceneCrowd crowd_;
    std::vector<clq_actor> actors_;
    std::vector<clq_transform> places_;
    int rows_ = 1;
    double width_m_ = 1;
    scenes::Daylight light_;
    scenes::Sky sky_;
    scenes::Geometry ground_;
    mutable scenes::Shadows shadows_;
    bool paints_people_ = true;
};

}  // namespace

std::unique_ptr<scenes::Scene> make_line_up(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                            const std::vector<scenes::Character> &characters)
{
    return std::make_unique<LineUp>(library, crowd_options, characters);
}

scenes::Character builtin_person(scenes::Library &library, const std::string &name, scenes::Lod lod)
{
    scenes::Character character;
    character.tmpl = lod == scenes::Lod::on ? library.builtin(name, {}) : library.builtin(name);
    return character;
}

}  // namespace view
