// Retargeting: makes clips of one skeleton usable on another, whose joints are bound by name. Start-up only.
//
// If the skeletons agree, channels are copied with their key times, steps and splines. Otherwise the motion is
// transferred: a joint rotates from its rest in model space as the source's does, and the topmost joint follows the
// source's path, scaled by the ratio of leg lengths and lowered so that the feet touch the ground. Markers go with
// their clips; of a cut clip, those within the kept range.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lib/model/rig.h"

namespace claque::retarget
{

// How a target joint relates to the source's rest pose.
enum class RestAlignment : uint8_t {
    // The joint keeps its own rest: characters with the same rest pose move alike.
    keep = 0,
    // The joint is rotated so that its bone points where the source's does: T-poses against A-poses.
    align = 1
};

struct JointPair {
    std::string source, target;
    RestAlignment rest = RestAlignment::keep;
};

// A target joint without a counterpart in the source, which follows a bound joint: cloth on a thigh.
struct Follower {
    std::string joint, leader;  // of the target
    double share = 1;           // of the leader's rotation from rest, in the space of the follower's parent; [0, 1]

    // A joint may have several entries. It then follows, smoothly, the leader that rotates it furthest. A leader that
    // moves away from the joint's side rotates it by 0.3 of its share.
};

// The pose of the clips' skeleton that corresponds to the character's rest pose.
enum class SourceRest : uint8_t {
    automatic = 0,  // source_rest.h
    file = 1,
    frame = 2,     // a key of the first clip
    bones = 3,     // the pose of a clip in which the bones point most as the character's do; limbs are aligned
    character = 4  // local rotations are copied
};

// A joint and the part of a human body that it is, as VRM names them: leftUpperLeg.
using HumanBone = std::pair<std::string, uint32_t>;

// automatic: channels if the skeletons agree and whole clips are wanted without closing.
enum class Mode : uint8_t { automatic = 0, channels = 1, motion = 2 };

// The horizontal travel of the topmost joint.
enum class RootTravel : uint8_t {
    in_place = 0,  // without the straight displacement from its first position to its last
    keep = 1       // as in the source, from the joint's own rest position on
};

struct Options {
    std::vector<JointPair> joints;    // empty: joints with equal names, or equal parts of a human body
    std::vector<Follower> followers;  // for transferred motion
    std::vector<std::string> clips;   // of the source; empty: all
    std::string prefix;               // of the names of added clips
    Mode mode = Mode::automatic;
    SourceRest rest = SourceRest::automatic;
    uint32_t rest_frame = 0;
    std::vector<HumanBone> target_bones, source_bones;  // of files that say them; empty: the names tell
    // The members below are for transferred motion.
    RootTravel travel = RootTravel::in_place;
    double rate_hz = 30;                                                  // rate of the keys
    double start_s = 0, end_s = std::numeric_limits<double>::infinity();  // the range to take, from the clip's start
    double close_s = 0;  // how long before its end a clip begins to blend into its first pose; 0: it does not
};

struct Report {
    Mode mode = Mode::channels;
    uint32_t clip_count = 0;
    uint32_t joint_count = 0;     // count of bound joints
    std::vector<uint32_t> clips;  // indices in the source; they are the last clips of the target, in order
    std::vector<std::pair<uint32_t, uint32_t>> joints;  // bound joints: source, target
    std::vector<std::string>
        warnings;  // joints that are not bound, choices that are not certain, poses that look wrong
};

// Adds clips to the target. If it throws the target is unchanged; base::Error with CLQ_ARGUMENT (nothing matches, a
// clip name is unknown, a number is out of range), CLQ_LIMIT. `before` is called last before the target changes: what
// it throws ends the call.
using Before = std::function<void(Report &)>;
Report add_clips(model::Rig &target, const model::Rig &source, const Options &options, const Before &before = {});

}  // namespace claque::retarget
