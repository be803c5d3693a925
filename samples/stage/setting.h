// What people who decide stand in: the ground that they walk on, and scenery that is drawn without them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "samples/scenes/light.h"
#include "samples/scenes/scenario/scenario.h"

namespace staged
{

// What can be walked on, and what is in the way. Metres, y up.
struct Floor {
    std::vector<double> vertices;     // three numbers each
    std::vector<uint32_t> triangles;  // counter-clockwise seen from where people could stand on them
    struct Obstacle {
        scenes::Outline outline;
        double low_m, high_m;
    };
    std::vector<Obstacle> obstacles;
    // Only those who have a goal there walk on them (clq_byway).
    struct Byway {
        scenes::Outline outline;
        double low_m, high_m;
        uint32_t group;
    };
    std::vector<Byway> byways;
};

class Setting
{
public:
    virtual ~Setting() = default;

    virtual void add_floor(Floor &out) const = 0;
    virtual clq_camera camera(scenes::Shot shot, double aspect) const = 0;
    virtual scenes::Daylight light() const = 0;
    // The height of the plane on which shadows fall; none: it is not level.
    virtual std::optional<double> shadows_at_m() const { return 0; }
    // Where feet stand, if people walk on steps as on a ramp: clq_walkers_def.ground and ground_user.
    struct Stone {
        clq_height_function height = nullptr;
        void *user = nullptr;
    };
    virtual Stone stone() const { return {}; }
    // Of the ground, at x and z.
    virtual double height_m(double, double) const { return 0; }
    // Says on what ground shadows fall, where it is no plane.
    virtual void lay_shadows(clq_shadow_def &) const {}
    // As those of scenes::Scene.
    virtual void prepare(const scenes::Gl &gl) = 0;
    virtual void set_light(const scenes::Gl &gl, const scenes::Eye &eye) const = 0;
    virtual void draw(const scenes::Gl &gl, const scenes::Eye &eye) const = 0;
};

// As Scene::take_shadows.
bool take_shadows_of(const Setting &setting, clq_shadow_def &def);

// The setting that a scenario has. Throws Failure.
std::unique_ptr<Setting> make_setting(scenes::Library &library, const scenes::Scenario &scenario, uint64_t seed);

// Of a scenario with [town].
std::unique_ptr<Setting> make_town_setting(const scenes::Scenario &scenario);
std::unique_ptr<Setting> make_area_setting(scenes::Library &library, const scenes::Scenario &scenario, uint64_t seed);
std::unique_ptr<Setting> make_theatre_setting(scenes::Library &library, const scenes::Scenario &scenario,
                                              uint64_t seed);

}  // namespace staged
