// A paved area with walls round it, on a plain: the walkable area of a file, or a rectangle.
#include <algorithm>
#include <cmath>

#include "samples/scenes/shadows.h"
#include "samples/scenes/walkers/plain.h"
#include "samples/stage/setting.h"

namespace staged
{
namespace
{

using namespace scenes;

struct DestroyArea {
    void operator()(clq_area *p) const { clq_area_destroy(p); }
};

// A rectangle that faces up.
void add_rectangle(Floor &out, const Outline &corners)
{
    const auto first = static_cast<uint32_t>(out.vertices.size() / 3);
    for (size_t i = 0; i < corners.size(); i += 2)
        out.vertices.insert(out.vertices.end(), {corners[i], 0, corners[i + 1]});
    for (uint32_t i = 2; i < corners.size() / 2; ++i)
        out.triangles.insert(out.triangles.end(), {first, first + i - 1, first + i});
}

class AreaSetting final : public Setting
{
public:
    AreaSetting(Library &library, const Scenario &scenario, uint64_t seed)
        : library_(library), stage_(*scenario.stage), plain_(seed, scenario.light.value_or(Daylight()))
    {
        find_plan();
        walkers::Options options;
        options.paving = scenario.paving, options.around = scenario.around;
        if (stage_.ground) options.area = stage_.ground->area, options.walls_m = stage_.ground->walls_m;
        asked_at(stage_.ground ? stage_.ground->area_at : "",
                 [&] { walkers::lay(library, options, plan_, plain_.ground()); });
    }

    void add_floor(Floor &out) const override
    {
        if (!stage_.ground->area.empty()) add_area(out);
        else add_rectangle(out, stage_.ground->rectangle);
    }

    clq_camera camera(Shot shot, double aspect) const override
    {
        if (shot != Shot::close) return walkers::overview_of(plan_, aspect);
        const double x = plan_.middle_x, z = plan_.middle_z + plan_.half_z;
        return look({x, 1.62, z}, {x, 1.2, z - 6}, 50, aspect, 0.2, walkers::far_of(plan_));
    }

    Daylight light() const override { return plain_.light(); }

    void prepare(const Gl &gl) override { plain_.prepare(gl); }

    void set_light(const Gl &g, const Eye &eye) const override { plain_.set_light(g, eye); }
    void draw(const Gl &g, const Eye &eye) const override { plain_.draw(g, eye); }

private:
    void add_area(Floor &out) const
    {
        clq_area *made = nullptr;
        asked_at(stage_.ground->area_at,
                 [&] { check(clq_area_load(library_.context(), stage_.ground->area.c_str(), &made)); });
        const std::unique_ptr<clq_area, DestroyArea> area(made);
        clq_area_info info = clq_area_info_init();
        check(clq_area_get_info(made, &info));
        for (uint32_t i = 0; i < info.point_count; ++i) {
            const double *p = info.points_m + 3 * size_t(i);
            out.vertices.insert(out.vertices.end(), {p[0], p[2], -p[1]});
        }
        out.triangles.assign(info.triangles, info.triangles + 3 * size_t(info.triangle_count));
    }

    // Round everything that the scenario places.
    void find_plan()
    {
        double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
        const auto hold = [&](double x, double z) {
            low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
            low[1] = std::min(low[1], z), high[1] = std::max(high[1], z);
        };
        if (stage_.ground) {
            Floor floor;
            add_floor(floor);
            for (size_t i = 0; i < floor.vertices.size(); i += 3) hold(floor.vertices[i], floor.vertices[i + 2]);
        } else {
            for (const Place &place : stage_.places) hold(place.position[0], place.position[2]);
            for (const ScenarioAgents &agents : stage_.agents)
                for (size_t i = 0; i < agents.outline.size(); i += 2) hold(agents.outline[i], agents.outline[i + 1]);
        }
        if (!(low[0] <= high[0])) hold(-5, -5), hold(5, 5);
        plan_.half_x = std::max(1.0, (high[0] - low[0]) / 2), plan_.middle_x = (high[0] + low[0]) / 2;
        plan_.half_z = std::max(1.0, (high[1] - low[1]) / 2), plan_.middle_z = (high[1] + low[1]) / 2;
    }

    Library &library_;
    Staging stage_;
    walkers::Plan plan_;
    walkers::Plain plain_;
};

}  // namespace

std::unique_ptr<Setting> make_area_setting(Library &library, const Scenario &scenario, uint64_t seed)
{
    return std::make_unique<AreaSetting>(library, scenario, seed);
}

}  // namespace staged
