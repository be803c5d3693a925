// A theatre and its audience: the odeon has three classes of Roman society on a bright day (S1 7, S2 5.3).
#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/odeon/contact_shadows.h"
#include "samples/scenes/odeon/theatre_building.h"
#include "samples/scenes/social_classes.h"

namespace scenes
{
namespace
{

class Odeon final : public Scene, public SocialClasses
{
public:
    Odeon(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
        : building_(scenario, crowd_options.seed),
          audience_(library, building_.theatre(), crowd_options),
          shadows_(audience_.seats(), audience_.sitters())
    {
    }

    clq_crowd *crowd() const override { return audience_.crowd(); }
    std::vector<clq_actor> actors() const override { return audience_.actors(); }
    std::string class_of(size_t person) const override
    {
        return building_.theatre().classes[audience_.sitters()[person].social_class].name;
    }
    std::vector<clq_template *> templates() const override { return audience_.templates(); }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        return shot == Shot::close ? few_rows(aspect) : building_.overview(aspect);
    }

    void place(double time_s) override { audience_.act(time_s); }

    void prepare(const Gl &gl) override
    {
        building_.prepare(gl);
        shadows_.prepare(gl);
    }

    void cull_by(double share) override { cull_share_ = static_cast<float>(share); }
    void set_light(const Gl &g, const Eye &eye) const override { building_.set_light(g, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        const Frustum cull(eye, cull_share_);
        building_.draw(g, eye, &cull);
        shadows_.draw(g, eye, &cull);
    }

private:
    // Close above the rows before a walkway, where two classes meet; before the middle row if there is no walkway.
    clq_camera few_rows(double aspect) const
    {
        const Theatre &theatre = building_.theatre();
        size_t number = theatre.rows.size() / 2;
        if (!theatre.walkways.empty())
            for (size_t i = 0; i < theatre.rows.size(); ++i)
                if (theatre.rows[i].radius_m < theatre.walkways.front().inner_m) number = i;
        const SeatRow &row = theatre.rows[number];
        const double before = row.radius_m - 3.37, behind = row.radius_m + 1.5;
        return look({-0.235 * before, row.seat_y_m + 1.85, -0.972 * before},
                    {-0.294 * behind, row.seat_y_m + 0.85, -0.956 * behind}, 49, aspect, 0.2, 600);
    }

    TheatreBuilding building_;
    Audience audience_;
    ContactShadows shadows_;
    float cull_share_ = 1;
};

}  // namespace

std::unique_ptr<Scene> make_theatre(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    return std::make_unique<Odeon>(library, crowd_options, scenario);
}

std::unique_ptr<Scene> make_odeon(Library &library, const CrowdOptions &crowd_options, const Character &)
{
    return make_scenario(library, crowd_options, odeon_scenario());
}

}  // namespace scenes
