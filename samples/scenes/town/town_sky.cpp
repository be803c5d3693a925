// The scene `town_sky`, S0's application (7.1, 7.2): thousands of flying actors of 13 articulations and 19 degrees of
// freedom over a small town, with their behaviour running and about a fifth of them in view.
#include <array>

#include "samples/scenes/scene.h"
#include "samples/scenes/town/flyers.h"
#include "samples/scenes/town/town.h"

namespace scenes
{
namespace
{

class TownSky final : public Scene
{
public:
    TownSky(Library &library, const CrowdOptions &crowd_options)
        : town_(crowd_options.seed),
          eye_(over(town_)),
          flyers_(library, crowd_options, {eye_[0], eye_[1] - 62, eye_[2]})
    {
    }

    clq_crowd *crowd() const override { return flyers_.cast().crowd(); }
    std::vector<clq_actor> actors() const override { return flyers_.cast().actors(); }
    std::vector<clq_template *> templates() const override { return flyers_.templates(); }

    // overview: among them, high over the fields before the town. close: beside one of them on its path.
    clq_camera camera(Shot shot, double aspect, double time_s) const override
    {
        if (shot == Shot::close) {
            double body[16];
            const uint32_t node = clq_template_find_node(templates()[0], "body");
            check(clq_actor_get_node(crowd(), actors()[0], node, time_s, body));
            // Ahead of its face and to its left: in flight its body points ahead with the head.
            double eye[3], target[3];
            for (int k = 0; k < 3; ++k) {
                target[k] = body[12 + k];
                eye[k] = target[k] + 3.0 * body[4 + k] + 2.4 * body[k];
            }
            eye[1] += 0.9;
            return look(eye, target, 46, aspect, 0.3, 5500);
        }
        const town::Point middle = town_.plan().at(0, 0);
        const double target[3] = {middle.x, town_.height(middle.x, middle.z) + 20, middle.z};
        const double eye[3] = {eye_[0], eye_[1], eye_[2]};
        return look(eye, target, 58, aspect, 1, 5500);
    }

    void place(double) override {}
    void prepare(const Gl &gl) override { town_.prepare(gl); }
    void set_light(const Gl &g, const Eye &eye) const override { town_.set_light(g, eye); }
    void draw_environment(const Gl &gl, const Eye &eye) const override
    {
        const Frustum cull(eye, cull_share_);
        town_.draw(gl, eye, &cull);
    }
    bool hides_people() const override { return true; }
    void cull_by(double share) override { cull_share_ = static_cast<float>(share); }

private:
    static std::array<double, 3> over(const town::Town &town)
    {
        const town::Point p = town.plan().at(60, 250);
        return {p.x, town.height(p.x, p.z) + 62, p.z};
    }

    town::Town town_;
    std::array<double, 3> eye_;
    town::Flyers flyers_;
    float cull_share_ = 1;
};

}  // namespace

std::unique_ptr<Scene> make_town_sky(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    CrowdOptions coarse = crowd_options;
    coarse.lod_scale *= 1.5f;  // a flyer's limbs become one piece where it is a dozen pixels high
    return std::make_unique<TownSky>(library, coarse);
}

}  // namespace scenes
