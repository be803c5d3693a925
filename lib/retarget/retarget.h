// Clips of one skeleton for another: joints are bound by name, whatever else the two rigs have. Start-up only.
//
// Where the skeletons agree at rest, channels are copied as they are: key times, steps and splines stay. Where they do
// not, the motion is transferred: a joint turns from its rest in model space as the source's does, and the topmost
// joint goes the source's way, scaled by the ratio of the legs and set down so that the feet stand on the ground.
// Markers go with their clips; of those that are cut, the ones in what is taken.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lib/model/rig.h"

namespace claque::retarget
{

// What answers the source's rest pose.
enum class RestAlignment : uint8_t {
    keep = 0,  // the joint's own rest: whoever stands the same way at rest stands the same way in motion
    align = 1  // the joint turned so that its bone points where the source's does: T-poses against A-poses
};

struct JointPair {
    std::string source, target;
    RestAlignment rest = RestAlignment::keep;
};

// A joint that nothing of the source answers, and that gives way to one that is bound: cloth to a thigh.
struct Follower {
    std::string joint, leader;  // of the target
    double share = 1;           // of the leader's turn from its rest, as the joint's parent sees it; [0, 1]
    // A joint with several lines goes with whichever leader turns it farthest, smoothly; a leader that turns away from the
    // side on which the joint lies turns it by 0.3 of its share.
};

// automatic: channels, where the skeletons agree and whole clips are wanted, unclosed.
enum class Mode : uint8_t { automatic = 0, channels = 1, motion = 2 };

// Of the topmost joint over the ground.
enum class RootTravel : uint8_t {
    in_place = 0,  // without the straight way from its first place to its last
    keep = 1       // as the source goes, from the joint's own rest place on
};

struct Options {
    std::vector<JointPair> joints;    // empty: joints of equal names
    std::vector<Follower> followers;  // of motion that is transferred
    std::vector<std::string> clips;   // of the source; empty: all
    std::string prefix;               // of the names of what is added
    Mode mode = Mode::automatic;
    // The rest is for motion that is transferred.
    RootTravel travel = RootTravel::in_place;
    double rate_hz = 30;                                                  // of keys
    double start_s = 0, end_s = std::numeric_limits<double>::infinity();  // what is taken, from the clip's start on
    double close_s = 0;  // so long before its end a clip begins to turn into its first pose; 0: it does not
};

struct Report {
    Mode mode = Mode::channels;
    uint32_t clip_count = 0;
    uint32_t joint_count = 0;                           // that are bound
    std::vector<uint32_t> clips;                        // of the source: the last of the target's, in their order
    std::vector<std::pair<uint32_t, uint32_t>> joints;  // bound ones: of the source, of the target
    std::vector<std::string> warnings;                  // what was not bound, by name and number
};

// Adds clips to the target; leaves it as it was when it throws base::Error: CLQ_ARGUMENT (nothing matches, names that
// are wanted and not there, numbers out of range), CLQ_LIMIT.
Report add_clips(model::Rig &target, const model::Rig &source, const Options &options);

}  // namespace claque::retarget
