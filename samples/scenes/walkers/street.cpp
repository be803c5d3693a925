#include "samples/scenes/walkers/street.h"

#include "samples/scenes/light.h"
#include "samples/scenes/random.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/walkers/cast.h"

namespace scenes::walkers
{

namespace
{

constexpr uint32_t abreast = 20;
constexpr double between_m = 0.9, row_m = 0.7, first_row_m = 3, length_s = 60, middle_s = 30;

class Street final : public Scene
{
public:
    Street(Library &library, const CrowdOptions &crowd_options, bool on_tracks)
        : citizen_(walkers::cast(library, class_of("citizen"), crowd_options.lod)),
          scene_crowd_(library, crowd_options),
          sky_(crowd_options.seed, Sky::Land::hills)
    {
        for (uint32_t person = 0; person < crowd_options.count; ++person) enter(person, crowd_options.seed, on_tracks);
        const float reach = static_cast<float>(first_row_m + row_m * crowd_options.count / abreast + 50);
        ground_.quad({Vec3{-reach, 0, reach}, Vec3{reach, 0, reach}, Vec3{reach, 0, -reach}, Vec3{-reach, 0, -reach}},
                     {0.6f, 0.58f, 0.54f});
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return {citizen_.tmpl}; }
    clq_camera camera(Shot, double aspect, double) const override
    {
        return look({0, 6, 6}, {0, 0.5, -20}, 60, aspect, 0.2, 2000);
    }
    void place(double) override {}
    void prepare(const Gl &) override {}
    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::texture_2d);
        ground_.draw(g);
        sky_.draw(g, eye);
    }

private:
    // At `middle_s` everybody is where those in place are.
    void enter(uint32_t person, uint64_t seed, bool on_tracks)
    {
        const double x = (person % abreast - (abreast - 1) * 0.5) * between_m;
        const double z = -first_row_m - row_m * (person / abreast);
        const double speed = random_between(seed, person, Purpose::speed, 1.0, 1.2);
        clq_play play = clq_play_init();
        play.clip = find_clip(citizen_.tmpl, {"walk"});
        play.phase_s = static_cast<float>(random_unit(seed, person, Purpose::phase));
        scene_crowd_.enter({citizen_.tmpl, stand(x, 0, z, 0, 1, 1), play});
        if (!on_tracks) return;
        std::vector<clq_track_point> points;
        for (double t = 0; t <= length_s; t += 1) {
            clq_track_point point = {};
            point.time_s = t, point.heading_rad = 0;
            point.position[0] = x, point.position[2] = z + speed * (t - middle_s);
            points.push_back(point);
        }
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
        def.seed = random_bits(seed, person, Purpose::act);
        clq_track *made = nullptr;
        check(clq_track_create(citizen_.locomotion.get(), &def, &made));
        const OwnTrack track(made);
        check(clq_actor_follow_track(scene_crowd_.crowd(), scene_crowd_.actors().back(), made, 0));
    }

    Member citizen_;
    SceneCrowd scene_crowd_;
    Daylight light_;
    Sky sky_;
    Geometry ground_;
};

}  // namespace

std::unique_ptr<Scene> make_street(Library &library, const CrowdOptions &crowd_options, bool on_tracks)
{
    return std::make_unique<Street>(library, crowd_options, on_tracks);
}

}  // namespace scenes::walkers
