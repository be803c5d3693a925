// The stone of a theatre, without the people that [theatre] alone would seat in it.
#include <optional>

#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/floor.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/odeon/orchestra.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/stone.h"
#include "samples/stage/setting.h"

namespace staged
{

using namespace scenes;

namespace
{

constexpr Rgb paving_of_theatres = {0.86f, 0.82f, 0.74f};

class TheatreSetting final : public Setting
{
public:
    TheatreSetting(const Scenario &scenario, uint64_t seed)
        : seed_(seed),
          theatre_(*scenario.theatre),
          light_(scenario.light.value_or(Daylight())),
          sky_(seed, Sky::Land::hills),
          orchestra_(theatre_, seed)
    {
        build_cavea(stone_, theatre_, seed);
        build_stage(stone_, theatre_);
        const float reach = static_cast<float>(theatre_.rows.back().radius_m + theatre_.rows.back().depth_m);
        ground_.disc(0, 0, 0, reach + 8, 96, scenario.paving.value_or(paving_of_theatres));
    }

    // What people walk on, and no seats.
    void add_floor(staged::Floor &out) const override
    {
        const scenes::Floor floor = floor_of(theatre_);
        const auto first = static_cast<uint32_t>(out.vertices.size() / 3);
        out.vertices.insert(out.vertices.end(), floor.vertices.begin(), floor.vertices.end());
        for (const uint32_t index : floor.triangles) out.triangles.push_back(first + index);
    }

    clq_camera camera(Shot shot, double aspect) const override
    {
        const SeatRow &last = theatre_.rows.back(), &middle = theatre_.rows[theatre_.rows.size() / 2];
        if (shot == Shot::close)
            return look({-2.5, middle.seat_y_m + 1.9, -middle.radius_m + 3.5},
                        {-4.0, middle.seat_y_m + 0.9, -middle.radius_m - 1.5}, 50, aspect, 0.2, 600);
        const double back = theatre_.stage.front_z_m + theatre_.stage.depth_m;
        return look({-2.4, last.seat_y_m + 3.4, back - 0.8}, {0.3, last.seat_y_m * 0.465, last.radius_m * -0.41}, 62,
                    aspect, 1.5, 900);
    }

    Daylight light() const override { return light_; }
    std::optional<double> shadows_at_m() const override { return std::nullopt; }

    void prepare(const Gl &gl) override
    {
        flagstones_.emplace(gl, flagstones(seed_), true);
        plaster_.emplace(gl, plaster(seed_), true);
        orchestra_.prepare(gl);
    }

    void draw(const Gl &g, const Eye &eye) const override
    {
        sky_.draw(g, eye);
        set_lights(g, light_, eye);
        g.Enable(gl::cull_face);
        flagstones_->use();
        ground_.draw(g);
        orchestra_.draw(g);
        plaster_->use();
        stone_.draw(g);
    }

private:
    uint64_t seed_;
    Theatre theatre_;
    Daylight light_;
    Sky sky_;
    Orchestra orchestra_;
    Geometry ground_ = Geometry(flagstone_metres), stone_ = Geometry(plaster_metres);
    std::optional<Texture> flagstones_, plaster_;
};

}  // namespace

std::unique_ptr<Setting> make_theatre_setting(Library &, const Scenario &scenario, uint64_t seed)
{
    return std::make_unique<TheatreSetting>(scenario, seed);
}

}  // namespace staged
