// The stone of a theatre, without the people that [theatre] alone would seat in it.
#include <claque/navigation.h>

#include "samples/scenes/odeon/floor.h"
#include "samples/scenes/odeon/stair_stone.h"
#include "samples/scenes/odeon/theatre_building.h"
#include "samples/stage/setting.h"

namespace staged
{

using namespace scenes;

namespace
{

// Rows of one group are far from each other.
uint32_t group_of(const scenes::Floor::Strip &strip) { return static_cast<uint32_t>(strip.row) % CLQ_BYWAY_GROUPS; }

class TheatreSetting final : public Setting
{
public:
    TheatreSetting(const Scenario &scenario, uint64_t seed) : building_(scenario, seed), stairs_(building_.theatre()) {}

    // What people walk on, and no seats.
    void add_floor(staged::Floor &out) const override
    {
        const scenes::Floor floor = floor_of(building_.theatre());
        const auto first = static_cast<uint32_t>(out.vertices.size() / 3);
        out.vertices.insert(out.vertices.end(), floor.vertices.begin(), floor.vertices.end());
        for (const uint32_t index : floor.triangles) out.triangles.push_back(first + index);
        for (const scenes::Floor::Strip &strip : floor.strips)
            out.byways.push_back({strip.outline, strip.low_m, strip.high_m, group_of(strip)});
    }

    Stone stone() const override
    {
        const auto height = [](void *user, const double point[3]) {
            return static_cast<const StairStone *>(user)->height_m(point);
        };
        return {height, const_cast<StairStone *>(&stairs_)};
    }

    clq_camera camera(Shot shot, double aspect) const override
    {
        if (shot != Shot::close) return building_.overview(aspect);
        const std::vector<SeatRow> &rows = building_.theatre().rows;
        const SeatRow &middle = rows[rows.size() / 2];
        return look({-2.5, middle.seat_y_m + 1.9, -middle.radius_m + 3.5},
                    {-4.0, middle.seat_y_m + 0.9, -middle.radius_m - 1.5}, 50, aspect, 0.2, 600);
    }

    Daylight light() const override { return building_.light(); }
    std::optional<double> shadows_at_m() const override { return std::nullopt; }

    void prepare(const Gl &gl) override { building_.prepare(gl); }
    void set_light(const Gl &gl, const Eye &eye) const override { building_.set_light(gl, eye); }
    void draw(const Gl &gl, const Eye &eye) const override
    {
        const Frustum cull(eye);
        building_.draw(gl, eye, &cull);
    }

private:
    TheatreBuilding building_;
    StairStone stairs_;
};

}  // namespace

std::unique_ptr<Setting> make_theatre_setting(Library &, const Scenario &scenario, uint64_t seed)
{
    return std::make_unique<TheatreSetting>(scenario, seed);
}

}  // namespace staged
