// Some three hundred people round an eye in the centre: rows that watch it, and three rings of walkers, which cross
// from one screen to the next.
#pragma once

#include <array>
#include <vector>

#include "samples/scenes/library.h"

namespace multichannel
{

class People
{
public:
    explicit People(scenes::Library &library);

    clq_crowd *crowd() const { return crowd_.get(); }
    const std::array<clq_template *, 4> &templates() const { return templates_; }
    const std::vector<clq_actor> &actors() const { return actors_; }
    const std::vector<clq_transform> &places() const { return places_; }

    void place(double time_s);  // the walkers, before clq_crowd_update

private:
    struct Walker {
        size_t person;
        double radius_m, start_rad, speed_mps;
    };
    void stand_rows();
    void walk_rings();
    size_t enter(const clq_transform &place, const char *clip);

    scenes::Own<clq_crowd> crowd_;
    std::array<clq_template *, 4> templates_;
    std::vector<clq_actor> actors_;
    std::vector<clq_transform> places_;
    std::vector<Walker> walkers_;
};

}  // namespace multichannel
