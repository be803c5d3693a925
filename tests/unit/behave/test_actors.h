// Actors with a spine, a neck, eyes, lids and a mouth, and mechanisms for them.
#pragma once

#include <memory>
#include <vector>

#include "lib/behave/behave.h"

namespace claque::behave::testing_support
{

enum Dof : uint32_t {
    spine_yaw,
    spine_pitch,
    neck_yaw,
    neck_pitch,
    left_yaw,
    left_pitch,
    right_yaw,
    right_pitch,
    left_lid,
    right_lid,
    smile,
    frown,
    open_mouth,
    dof_count
};

// The active nodes of the template's levels.
enum Skeleton : uint32_t { whole, without_eyes, without_neck, without_spine };

class TestActors
{
public:
    explicit TestActors(uint32_t actors = 1, uint64_t crowd_seed = 7);

    // Attaches it to every actor.
    uint32_t add(crowd::MechanismKind kind, float priority = 0);
    uint32_t add(crowd::Mechanism mechanism, float priority = 0);
    void use(uint32_t actor, uint32_t mechanism, float priority = 0, float phase_s = 0, double start_s = 0);

    // The degrees of freedom at a time.
    const std::vector<float> &at(double time_s, uint32_t actor = 0, float distance_m = 0, Skeleton skeleton = whole);
    float at(double time_s, Dof dof) { return at(time_s)[dof]; }
    const model::Dof &dof(uint32_t i) const { return tmpl->rig.dofs[i]; }

    std::unique_ptr<model::Template> tmpl;
    crowd::Crowd crowd;
    std::vector<crowd::Id> ids;
    Counts counts;

private:
    std::vector<float> dofs_;
};

crowd::Gaze gaze();              // of all parts; turns in 0.4 s, without wandering
crowd::Expression expression();  // smile, frown, and a face at rest
crowd::Blink blink();
crowd::Phrase phrase(float pause_s);  // o, rest, half open; 1.2 s long

// The largest change of any degree of freedom from one millisecond to the next, as a rate.
float steepest(TestActors &test_actors, double from_s, double to_s);

}  // namespace claque::behave::testing_support
