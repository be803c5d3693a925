// A theatre and its audience: the odeon has three classes of Roman society on a bright day (S1 7, S2 5.3).
#include <optional>

#include "samples/scenes/light.h"
#include "samples/scenes/odeon/audience.h"
#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/contact_shadows.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/odeon/orchestra.h"
#include "samples/scenes/scenario/scenario.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/social_classes.h"
#include "samples/scenes/stone.h"

namespace scenes
{
namespace
{

constexpr Rgb plain_paving = {0.86f, 0.82f, 0.74f};

class Odeon final : public Scene, public SocialClasses
{
public:
    Odeon(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
        : seed_(crowd_options.seed),
          theatre_(*scenario.theatre),
          light_(scenario.light.value_or(Daylight())),
          audience_(library, theatre_, crowd_options),
          shadows_(audience_.seats(), audience_.sitters()),
          sky_(crowd_options.seed, Sky::Land::hills),
          orchestra_(theatre_, crowd_options.seed)
    {
        build_cavea(stone_, theatre_, seed_);
        build_stage(stone_, theatre_);
        const float reach = static_cast<float>(theatre_.rows.back().radius_m + theatre_.rows.back().depth_m);
        ground_.disc(0, 0, 0, reach + 8, 96, scenario.paving.value_or(plain_paving));
    }

    clq_crowd *crowd() const override { return audience_.crowd(); }
    std::vector<clq_actor> actors() const override { return audience_.actors(); }
    std::string class_of(size_t who) const override
    {
        return theatre_.classes[audience_.sitters()[who].social_class].name;
    }
    std::vector<clq_template *> templates() const override { return audience_.templates(); }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        return shot == Shot::close ? few_rows(aspect) : house(aspect);
    }

    void place(double time_s) override { audience_.act(time_s); }

    void prepare(const Gl &gl) override
    {
        flagstones_.emplace(gl, flagstones(seed_), true);
        plaster_.emplace(gl, plaster(seed_), true);
        orchestra_.prepare(gl);
        shadows_.prepare(gl);
    }

    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        sky_.draw(g, eye);
        set_lights(g, light_, eye);
        g.Enable(gl::cull_face);
        flagstones_->use();
        ground_.draw(g);
        orchestra_.draw(g);
        plaster_->use();
        stone_.draw(g);
        shadows_.draw(g);
    }

private:
    // From above the stage, before its wall: the whole house.
    clq_camera house(double aspect) const
    {
        const SeatRow &last = theatre_.rows.back();
        const double back = theatre_.stage.front_z_m + theatre_.stage.depth_m;
        return look({-2.4, last.seat_y_m + 3.4, back - 0.8}, {0.3, last.seat_y_m * 0.465, last.radius_m * -0.41}, 62,
                    aspect, 1.5, 900);
    }

    // Close above the rows before a walkway, where two classes meet; before the middle row if there is no walkway.
    clq_camera few_rows(double aspect) const
    {
        size_t number = theatre_.rows.size() / 2;
        if (!theatre_.walkways.empty())
            for (size_t i = 0; i < theatre_.rows.size(); ++i)
                if (theatre_.rows[i].radius_m < theatre_.walkways.front().inner_m) number = i;
        const SeatRow &row = theatre_.rows[number];
        const double before = row.radius_m - 3.37, behind = row.radius_m + 1.5;
        return look({-0.235 * before, row.seat_y_m + 1.85, -0.972 * before},
                    {-0.294 * behind, row.seat_y_m + 0.85, -0.956 * behind}, 49, aspect, 0.2, 600);
    }

    uint64_t seed_;
    Theatre theatre_;
    Daylight light_;
    Audience audience_;
    ContactShadows shadows_;
    Sky sky_;
    Orchestra orchestra_;
    Geometry ground_ = Geometry(flagstone_metres), stone_ = Geometry(plaster_metres);
    std::optional<Texture> flagstones_, plaster_;
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
