// The audience: individuals on their seats in the colours of their class, each with its programme.
#pragma once

#include "samples/scenes/odeon/programme.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/scene_crowd.h"

namespace scenes
{

// The members that programmes need, one for each sitter; the lengths of their clips are not set yet.
std::vector<Member> members_of(const Theatre &theatre, const std::vector<Seat> &seats,
                               const std::vector<Sitter> &sitters, uint64_t seed);

class Audience
{
public:
    Audience(Library &library, const Theatre &theatre, const CrowdOptions &crowd_options);

    // Lets all individuals play what their programmes have at this time.
    void act(double time_s);

    clq_crowd *crowd() const { return scene_crowd_.crowd(); }
    const std::vector<clq_actor> &actors() const { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const;
    const std::vector<clq_transform> &places() const { return scene_crowd_.places(); }
    const std::vector<Seat> &seats() const { return seats_; }
    const std::vector<Sitter> &sitters() const { return sitters_; }
    const std::vector<Member> &members() const { return members_; }

private:
    struct Figure {
        std::string name;
        clq_template *tmpl = nullptr;  // owned by the library
        std::array<uint32_t, act_count> clips;
        std::array<double, act_count> duration_s;
    };
    size_t figure(Library &library, const std::string &name, Lod lod);

    std::vector<Seat> seats_;
    std::vector<Sitter> sitters_;
    std::vector<Member> members_;
    std::vector<Figure> figures_;
    std::vector<size_t> figure_of_;  // of each class
    std::vector<Playing> playing_;
    SceneCrowd scene_crowd_;
};

}  // namespace scenes
