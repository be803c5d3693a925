// Omnibuses with people in them, each a group (S0 4.3: "a vehicle with several occupants"), and people on the square.
#pragma once

#include "samples/scenes/scene_crowd.h"
#include "samples/scenes/town/omnibus.h"
#include "samples/scenes/town/town.h"

namespace scenes::town
{

class Passengers
{
public:
    // Fills omnibuses first, with 14 seats each and no more than fit on the route, then the square.
    Passengers(Library &library, const CrowdOptions &crowd_options, const Town &town);

    clq_crowd *crowd() const { return scene_crowd_.crowd(); }
    std::vector<clq_template *> templates() const { return figures_; }
    const SceneCrowd &cast() const { return scene_crowd_; }

    // Drives them to their positions at this time.
    void drive(double time_s);
    const std::vector<VehiclePose> &poses() const { return poses_; }
    const std::vector<clq_group> &groups() const { return groups_; }  // one for each omnibus
    const VehiclePath &path() const { return path_; }
    // The people who stand on the square, for their shadows.
    const std::vector<clq_transform> &standing() const { return standing_; }
    size_t seated() const { return seated_; }

    static constexpr double metres_a_second = 5.0, spacing_m = 36.0;

private:
    void board(uint32_t people);
    void gather(const Town &town, uint32_t people);
    clq_play play(clq_template *tmpl, const char *const *clips, size_t count, size_t number) const;

    uint64_t seed_;
    VehiclePath path_;
    SceneCrowd scene_crowd_;
    std::vector<clq_template *> figures_;
    std::vector<clq_group> groups_;
    std::vector<VehiclePose> poses_;
    std::vector<clq_transform> standing_;
    size_t seated_ = 0;
    double first_m_ = 0;  // along the route, at time 0: after 2 s the first omnibus passes the square
};

}  // namespace scenes::town
