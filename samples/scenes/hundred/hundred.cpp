// The scene `hundred_actors` of S0 6.1: a hundred dragons over a lake. Their positions relative to the camera's
// frustum follow S0's Table 2, and each dragon follows its Table 3. The library's counts are printed beside the
// paper's cost model.
#include "samples/scenes/hundred/dragon.h"
#include "samples/scenes/hundred/dragon_mechanisms.h"
#include "samples/scenes/hundred/dragon_paths.h"
#include "samples/scenes/hundred/lake.h"
#include "samples/scenes/hundred/paint.h"
#include "samples/scenes/light.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/scene_crowd.h"
#include "samples/scenes/sky.h"

namespace scenes
{
namespace
{

constexpr Daylight morning = {
    {0.45f, 0.62f, 0.64f}, {0.78f, 0.72f, 0.62f}, {0.38f, 0.40f, 0.44f}, {0.14f, 0.17f, 0.18f}};
constexpr uint32_t actors_of_table_2 = 100;

const CrowdOptions &checked(const CrowdOptions &crowd_options)
{
    if (crowd_options.count != actors_of_table_2)
        throw Failure("hundred_actors has the 100 actors of S0's Table 2, and " + std::to_string(crowd_options.count) +
                      " were requested; parade takes any number");
    return crowd_options;
}

class Hundred final : public Scene
{
public:
    Hundred(Library &library, const CrowdOptions &crowd_options)
        : scene_crowd_(library, checked(crowd_options)),
          dragon_(hundred::dragon_of(library)),
          spheres_(hundred::spheres_of(library.context(), dragon_)),
          spots_(hundred::find_spots(spheres_, crowd_options.seed)),
          sky_(crowd_options.seed, Sky::Land::hills)
    {
        for (uint64_t number = 0; number < spots_.size(); ++number) enter(crowd_options.seed, number);
        const hundred::DragonPaths ways(crowd());
        const hundred::DragonMechanisms manners(crowd(), dragon_);
        for (uint64_t number = 0; number < spots_.size(); ++number) {
            const clq_actor actor = scene_crowd_.actors()[number];
            ways.send(actor, spots_[number].way, crowd_options.seed * actors_of_table_2 + number);
            manners.attach(actor, crowd_options.seed * actors_of_table_2 + number);
        }
        hundred::fill_lake(water_, rocks_, spots_, spheres_, crowd_options.seed);
        hundred::draw_plan(plan_, spots_, spheres_);
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return {dragon_}; }

    // overview: the camera of Table 2. close: from outside, a view of that camera's frustum and the dragons in it.
    clq_camera camera(Shot shot, double aspect, double) const override
    {
        if (shot == Shot::close) return look({-40, 170, 95}, {0, 8, -72}, 52, aspect, 2, 6000);
        return hundred::Frustum::camera(aspect);
    }

    void place(double) override {}
    void prepare(const Gl &) override {}

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, morning, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::texture_2d);
        g.Enable(gl::cull_face);
        water_.draw(g);
        rocks_.draw(g);
        sky_.draw(g, eye);
        g.Enable(gl::cull_face);
        const hundred::Point own = hundred::Frustum::eye();
        if (eye.position[0] == own.x && eye.position[1] == own.y && eye.position[2] == own.z) return;
        g.Disable(gl::cull_face);
        g.Disable(gl::lighting);
        g.Enable(gl::blend);
        g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
        plan_.draw(g);
        g.Disable(gl::blend);
        g.Enable(gl::lighting);
        g.Enable(gl::cull_face);
    }

private:
    void enter(uint64_t seed, uint64_t number)
    {
        clq_play play = {};
        play.speed = static_cast<float>(random_between(seed, number, Purpose::speed, 0.85, 1.15));
        play.phase_s = static_cast<float>(random_between(seed, number, Purpose::phase, 0, 60));
        const uint32_t house = static_cast<uint32_t>(random_unit(seed, number, Purpose::tone) * hundred::house_count);
        scene_crowd_.enter({dragon_, spots_[number].place, play}, number, hundred::palette_of(house));
    }

    SceneCrowd scene_crowd_;
    clq_template *dragon_;
    hundred::Spheres spheres_;
    std::vector<hundred::Spot> spots_;
    Sky sky_;
    Geometry water_, rocks_, plan_;
};

}  // namespace

std::unique_ptr<Scene> make_hundred_actors(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return std::make_unique<Hundred>(library, crowd_options);
}

}  // namespace scenes
