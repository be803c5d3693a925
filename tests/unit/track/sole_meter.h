// The soles of a person on a track as the contact meter (contacts.h) sees them.
#pragma once

#include <functional>

#include "lib/track/track.h"
#include "tests/unit/track/contacts.h"

namespace claque::test
{

// The height of the ground, metres in the world.
using Ground = std::function<double(double x, double z)>;

// Steps through a track at 100 Hz and skins the soles of the finest level: the vertices that follow a foot and its toes
// and are at most 35 mm above the lowest of them in the template's rest pose.
class SoleMeter
{
public:
    // `scale`: metres per model unit of the people that are watched
    explicit SoleMeter(const track::Locomotion &locomotion, double scale = 1);
    // Without `held` the feet are where the clips alone have them.
    Contacts watch(const track::Track &track, const Ground &ground = {}, bool held = true) const;
    // The piece that shows a time.
    using Shown = std::function<const track::Track &(double time_s)>;
    Contacts watch(const Shown &shown, double start_s, double end_s, const Ground &ground = {}, bool held = true) const;

private:
    struct Sole {
        std::vector<uint32_t> vertices;
        std::vector<Part> parts;
    };
    const track::Locomotion *locomotion_;
    Sole soles_[2];
};

}  // namespace claque::test
