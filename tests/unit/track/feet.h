// Watches the soles of a person on a track, from its skinned mesh alone: how far a foot that carries weight slides over
// the ground.
#pragma once

#include <vector>

#include "lib/pose/pose.h"
#include "lib/track/track.h"

namespace claque::test
{

// The vertices that follow each foot and its toes.
class Soles
{
public:
    explicit Soles(const track::Locomotion &locomotion);

    struct Posed {
        std::vector<glm::dvec3> points[2];  // model space
    };
    // Every foot in the pose of a track at a time; without `held` as the clips alone have it.
    const Posed &at(const track::Track &track, double time_s, bool held = true);
    const model::Template &tmpl() const { return *locomotion_->tmpl; }

private:
    const track::Locomotion *locomotion_;
    pose::Workspace work_;
    std::vector<uint32_t> vertices_[2];
    Posed posed_;
};

// The sole of a foot at a time, metres in the world.
struct SolesInWorld {
    std::vector<glm::dvec3> points;
    double ground = 0;
};
SolesInWorld soles_at(Soles &soles, const track::Track &track, int foot, double time_s, bool held);

struct FootDrift {
    std::vector<double> each;  // metres, one for each time that a foot carried weight
    double mean() const;
    double at_share(double share) const;  // such as the 95th percentile
    double max() const { return at_share(1); }
    void add(const FootDrift &other) { each.insert(each.end(), other.each.begin(), other.each.end()); }
};

// Steps through the track. While the track says that a foot stands, the vertices of its sole within 12 mm of the ground
// are compared from step to step; the drift is the largest distance that they get from where they touched it.
FootDrift drift_of(Soles &soles, const track::Track &track, double step_s, bool held = true);

// Feet that the track does not hold. The track might say of none that it stands: the law above would then hold of
// nothing.
struct Swings {
    double seconds = 0, moving_s = 0;  // looked at; of them, faster than 0.3 m/s
    double flying_s = 0;               // of those, without any foot that stands
    double deepest_m = 0;              // below the ground, of any swinging foot
    void add(const Swings &other);
};
Swings swings_of(Soles &soles, const track::Track &track, double step_s);

// The largest height of the lower sole over the ground while the track says that a foot stands, metres.
double lift_of(Soles &soles, const track::Track &track, double step_s);

}  // namespace claque::test
