// What one individual is told to do, as data: clips, fades, layers, a treadmill, its face, a flight, what it carries,
// and a host's own mechanism. The window of `claque view` edits a role, and a scenario has roles in [[people]]; both
// give it to a Performer (performer.h), so both show the same.
#pragma once

#include <claque/claque.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "samples/scenes/roles/mechanism_file.h"

namespace scenes::roles
{

struct Clip {
    std::string name;  // empty: the rest pose
    double start_s = 0;
    float speed = 1, phase_s = 0;

    bool operator==(const Clip &o) const
    {
        return std::tie(name, start_s, speed, phase_s) == std::tie(o.name, o.start_s, o.speed, o.phase_s);
    }
};

struct Fade {
    Clip to;
    double at_s = 0;
    float length_s = 0.3f;
    int curve = CLQ_CURVE_SMOOTH;

    bool operator==(const Fade &o) const
    {
        return std::tie(to, at_s, length_s, curve) == std::tie(o.to, o.at_s, o.length_s, o.curve);
    }
};

struct Layer {
    Clip clip;
    std::string joint;      // with all below it; empty: the whole body
    bool inverted = false;  // all but those
    bool adds = false;
    float weight = 1;

    bool operator==(const Layer &o) const
    {
        return std::tie(clip, joint, inverted, adds, weight) == std::tie(o.clip, o.joint, o.inverted, o.adds, o.weight);
    }
};

struct Motion {
    Clip base;
    std::vector<Fade> fades;  // the last three
    std::vector<Layer> layers;
    std::optional<double> treadmill_m_s;

    bool operator==(const Motion &o) const
    {
        return std::tie(base, fades, layers, treadmill_m_s) == std::tie(o.base, o.fades, o.layers, o.treadmill_m_s);
    }
};

struct Face {
    bool looks = false, blinks = false;
    std::optional<std::array<double, 3>> target;  // of the gaze, in the world; none: it wanders
    double target_at_s = 0;
    bool expresses = false;
    std::string expression;  // empty: by chance
    double expression_at_s = 0;
    std::string phrase;  // empty: silent
    double phrase_at_s = 0;

    bool operator==(const Face &o) const
    {
        return std::tie(looks, blinks, target, target_at_s, expresses, expression, expression_at_s, phrase,
                        phrase_at_s) == std::tie(o.looks, o.blinks, o.target, o.target_at_s, o.expresses, o.expression,
                                                 o.expression_at_s, o.phrase, o.phrase_at_s);
    }
};

struct Flight {
    std::vector<double> corners;  // x, y, z in the world; fewer than two corners: no flight
    double speed_m_s = 6;

    bool flies() const { return corners.size() >= 6; }
    bool operator==(const Flight &o) const { return std::tie(corners, speed_m_s) == std::tie(o.corners, o.speed_m_s); }
};

struct Carried {
    std::string joint, object;

    bool operator==(const Carried &o) const { return std::tie(joint, object) == std::tie(o.joint, o.object); }
};

struct Role {
    Motion motion;
    Face face;
    Flight flight;
    std::vector<Carried> load;
    MechanismFile mechanism;            // a shared object (mechanism.h)
    std::map<std::string, float> dofs;  // held by hand

    bool operator==(const Role &o) const
    {
        return std::tie(motion, face, flight, load, mechanism, dofs) ==
               std::tie(o.motion, o.face, o.flight, o.load, o.mechanism, o.dofs);
    }
    bool operator!=(const Role &o) const { return !(*this == o); }
};

constexpr size_t most_fades = 3, most_layers = 4;

}  // namespace scenes::roles
