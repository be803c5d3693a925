// The square of the town and the streets round it.
#include "samples/scenes/town/walkable.h"
#include "samples/stage/setting.h"

namespace staged
{
namespace
{

using namespace scenes;

class TownSetting final : public Setting
{
public:
    explicit TownSetting(const ScenarioTown &described)
        : town_(described.seed, described.market_day ? town::Trade::market_day : town::Trade::ordinary),
          streets_m_(described.streets_m)
    {
    }

    void add_floor(Floor &out) const override
    {
        town::Walkable found = town::walkable_square(town_, streets_m_);
        out.vertices = std::move(found.vertices), out.triangles = std::move(found.triangles);
        for (town::Walkable::Prism &one : found.obstacles)
            out.obstacles.push_back({std::move(one.outline), one.low_m, one.high_m});
        // Booths of one group are far from each other: the way out of one never leads through another.
        uint32_t number = 0;
        for (town::Walkable::Prism &one : found.booths)
            out.byways.push_back({std::move(one.outline), one.low_m, one.high_m, number++ % 8});
    }

    // close: among the stalls. overview: over the square from the south.
    clq_camera camera(Shot shot, double aspect) const override
    {
        const town::SquarePlan square = town::square_plan(town_.plan());
        const auto at = [&](double u, double v, double above) {
            const town::Point p = town_.plan().at(u, v);
            return std::array<double, 3>{p.x, town_.height(p.x, p.z) + above, p.z};
        };
        const bool is_close = shot == Shot::close;
        const std::array<double, 3> eye = is_close ? at(square.fountain_u + 4.5, square.fountain_v - 4.5, 2.1)
                                                   : at(square.fountain_u + 6, square.fountain_v + 50, 36);
        const std::array<double, 3> target = is_close ? at(square.fountain_u + 20, square.fountain_v - 3.5, 1.1)
                                                      : at(square.fountain_u, square.fountain_v - 4, 0);
        return look({eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}, is_close ? 55 : 46, aspect,
                    is_close ? 0.2 : 2, 5500);
    }

    Daylight light() const override { return town::Town::light(); }
    double height_m(double x, double z) const override { return town_.height(x, z); }

    void lay_shadows(clq_shadow_def &def) const override
    {
        def.ground = CLQ_SHADOW_GROUND_HOST;
        def.height = [](void *user, const double point[3]) {
            return static_cast<const TownSetting *>(user)->height_m(point[0], point[2]);
        };
        def.user = const_cast<TownSetting *>(this);  // only read
        def.lift = 0.03f;
    }

    void prepare(const Gl &gl) override { town_.prepare(gl); }

    void set_light(const Gl &gl, const Eye &eye) const override { town_.set_light(gl, eye); }
    void draw(const Gl &gl, const Eye &eye) const override
    {
        const Frustum cull(eye, 1);
        town_.draw(gl, eye, &cull);
    }

private:
    town::Town town_;
    double streets_m_;
};

}  // namespace

std::unique_ptr<Setting> make_town_setting(const Scenario &scenario)
{
    return std::make_unique<TownSetting>(*scenario.town);
}

}  // namespace staged
