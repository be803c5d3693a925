// Measures the deviation of resampled clips from their channels in poses, and bounds it for any degrees of freedom and
// blends on top.
#pragma once

#include <vector>

#include "lib/pose/pose.h"

namespace claque::meshsplit
{

struct MotionError {
    double metres = 0, radians = 0;

    bool within(const MotionError &maximum) const { return metres <= maximum.metres && radians <= maximum.radians; }
    void merge(const MotionError &other);
};

class MotionMeter
{
public:
    // Uses the levels and the present motion of `tmpl`.
    explicit MotionMeter(const model::Template &tmpl);

    // Returns the radius of the character at rest.
    double rest_size() const;

    // Returns the largest error of a clip at some times. It stops at the first time whose error is not within `most`.
    MotionError measure(uint32_t clip, const std::vector<double> &times, const MotionError &maximum);
    // Returns [channel_count], 1 for channels whose own error, in their node's frame, is larger than `most`.
    std::vector<uint8_t> outliers(uint32_t clip, const std::vector<double> &times, const MotionError &maximum);

    // Measurements after begin() count for bound() once they are accepted.
    void begin();
    void accept();
    // Returns a bound of the deviation of any vertex, over all accepted clips, in any pose blended from them, with any
    // degrees of freedom: each joint's own error times the extent of what it moves.
    double bound() const;

    // Local transforms that were evaluated so far, and those of one pose of a clip.
    uint64_t evaluated() const { return evaluated_; }
    uint64_t pose_transforms(uint32_t clip) const;
    void count(uint64_t transforms) { evaluated_ += transforms; }
    // What accept() knows of the clip's nodes also holds at times that were not measured.
    void accept_reach_of(uint32_t clip);

private:
    struct Local {
        double shift = 0, turn = 0, growth = 0;  // errors
        double offset = 0, scale = 0;            // largest distance from its parent, largest scale
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
    std::vector<Ball> balls_;           // bounding balls of what nodes move, in their frames
    std::vector<double> morph_metres_;  // per weight: the largest displacement of a vertex, before posing
    std::vector<math::Affine> exact_globals_, sampled_globals_;
    struct Worst {
        std::vector<Local> nodes;
        double morphs = 0;  // in metres, of all weights
        void merge(const Worst &other);
    };
    Worst now_, measured_, accepted_;
    const std::vector<float> dofs_;  // all zero
    double morphs_ = 0;              // error of morph weights at the last time, in metres
    uint64_t evaluated_ = 0;
};

}  // namespace claque::meshsplit
