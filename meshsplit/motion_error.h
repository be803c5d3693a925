// How far clips as sampled are from their channels: measured in poses, and bounded for whatever degrees of freedom and
// blends do on top.
#pragma once

#include "lib/pose/pose.h"

#include <vector>

namespace claque::meshsplit
{

struct MotionError {
    double metres = 0, radians = 0;

    bool within(const MotionError &most) const { return metres <= most.metres && radians <= most.radians; }
    void merge(const MotionError &other);
};

class MotionMeter
{
public:
    // Levels, and motion as far as it goes, of `tmpl`.
    explicit MotionMeter(const model::Template &tmpl);

    // Half the size of the character at rest, from its middle.
    double rest_size() const;

    // The largest error of a clip at some moments; stops at the first moment that is not within `most`.
    MotionError measure(uint32_t clip, const std::vector<double> &times, const MotionError &most);
    // Where single tracks are off by more, in their own frames: [channel_count], 1 where so.
    std::vector<uint8_t> outliers(uint32_t clip, const std::vector<double> &times, const MotionError &most);

    // What is measured from begin() on counts for bound() once it is accepted.
    void begin();
    void accept();
    // In all that was accepted: how far any vertex can be away in any pose made of such clips, with
    // degrees of freedom anywhere. Each joint's own error times all that hangs on it.
    double bound() const;

private:
    struct Local {
        double shift = 0, turn = 0, growth = 0;  // errors
        double offset = 0, scale = 0;            // largest distance from its parent, largest factor
    };
    struct Ball {
        uint32_t node;
        glm::dvec3 centre;
        double radius;
    };

    MotionError at(uint32_t clip, double time_s);
    void take_locals();
    static Local difference(const math::Trs &exact, const math::Trs &sampled);

    const model::Template &tmpl_;
    pose::Workspace exact_, sampled_;
    std::vector<Ball> balls_;           // what hangs on nodes, in their frames
    std::vector<double> morph_metres_;  // per weight: the most that it moves a vertex, before poses
    std::vector<math::Affine> exact_globals_, sampled_globals_;
    struct Worst {
        std::vector<Local> nodes;
        double morphs = 0;  // in metres, of all weights
        void merge(const Worst &other);
    };
    Worst now_, measured_, accepted_;
    const std::vector<float> dofs_;  // all at zero
    double morphs_ = 0;              // error of morph weights at the last moment, in metres
};

}  // namespace claque::meshsplit
