// The steps of an individual that a program moves: only its place in each frame is known. They follow the way, as on
// tracks (claque/track.h), so feet stay where they stand whatever the program's clock is.
#pragma once

namespace osg_plugin
{

class Steps
{
public:
    // `phase` [0, 1): of the cycle, at the beginning.
    explicit Steps(double phase) : cycles_(phase) {}

    // Once a frame. way_m: since the last one. time_passed: whether anything at all has moved since then. While nothing
    // does, the program's clock stands still, and the individual stays in its step.
    void move(double way_m, double stride_m, bool time_passed);

    bool walks() const { return walks_; }
    // The phase of the cycle, [0, 1).
    double phase() const;

private:
    double cycles_;
    int still_ = 0;  // frames in which others moved
    bool walks_ = false;
};

}  // namespace osg_plugin
