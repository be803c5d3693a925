// The control mechanisms of a dragon, on top of its clip (S0 5.3): it looks about, rears and curls, moves ears,
// whiskers and crest, and roars. Together they write all 80 degrees of freedom.
#pragma once

#include "samples/scenes/check.h"

namespace scenes::hundred
{

class DragonMechanisms
{
public:
    // The crowd must already have an actor of the template.
    DragonMechanisms(clq_crowd *crowd, const clq_template *dragon);
    void attach(clq_actor actor, uint64_t number) const;

private:
    void add_gaze(const clq_template *dragon);
    void add_bearing(const clq_template *dragon);
    void add_face(const clq_template *dragon);
    void add_roar(const clq_template *dragon);
    clq_mechanism add(const clq_mechanism_def &def) const;

    clq_crowd *crowd_;
    clq_mechanism gaze_ = {}, bearing_ = {}, face_ = {}, roar_ = {};
};

}  // namespace scenes::hundred
