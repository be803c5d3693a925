// Key-poses (S3 3): poses of a clip at a uniform rate, whose vertices all individuals of one template and level share.
// Which key-poses an individual shows is a function of its clip's time alone; which are kept does not change the
// picture.
#pragma once

#include <vector>

#include "lib/base/held_bytes.h"
#include "lib/model/template.h"

namespace claque::animcache
{

// How an individual gets its vertices.
enum class KeyPoseMode : uint8_t {
    individual = 0,    // the pose of its tick, in its own caches (S1 4)
    intermittent = 1,  // the key-pose nearest to its tick (S3 3)
    interpolated = 2,  // the two key-poses around its tick, vertices blended linearly (S3 4)
    skinned = 3        // the pose of each update's own time, skinned anew
};

inline bool shows_key_poses(KeyPoseMode mode)
{
    return mode == KeyPoseMode::intermittent || mode == KeyPoseMode::interpolated;
}

constexpr uint32_t max_key_pose_bands = 4;

// Applies from `distance` to the nearest eye on, world units; nearer than the first band: individual.
struct KeyPoseBand {
    float distance = 0;
    KeyPoseMode mode = KeyPoseMode::individual;
};

struct KeyPoseSettings {
    KeyPoseBand bands[max_key_pose_bands];  // distances ascend
    uint32_t band_count = 0;
    float rate_hz = 15;                           // key-poses a second of each clip (S3 6)
    uint32_t max_kept = 256;                      // of each template and level (S3 5)
    uint64_t budget_bytes = uint64_t(256) << 20;  // of all of them

    KeyPoseMode mode_at(float distance) const;
    bool any() const;           // whether individuals may show key-poses
    bool interpolates() const;  // and whether they may interpolate them
};

// What one individual shows in one update. `first` and `second` are numbers of key-poses of its template; they are
// equal if it shows one. The pointers are valid until the next update.
struct KeyPoseSelection {
    KeyPoseMode mode = KeyPoseMode::individual;
    uint32_t tmpl = 0, store = 0;  // of KeyPoses
    uint32_t first = 0, second = 0;
    double time_s[2] = {0, 0};                  // of both, on the clip's axis
    float blend = 0;                            // [0, 1]: from the first to the second
    const float *kept[2] = {nullptr, nullptr};  // their vertices, if they are kept

    bool served() const { return kept[0] && kept[1]; }
};

// The key-poses of a template's clips: `intervals` + 1 of each, from its start to its end. For a clip that ends as it
// begins, the last one is the first.
class KeyPoseTable
{
public:
    // Intervals of all clips together, besides one for each clip. Where clips last longer, the rate is lower.
    static constexpr uint32_t max_intervals = 1 << 17;

    // At start-up: allocates. Throws std::bad_alloc.
    KeyPoseTable(std::pmr::memory_resource *memory, const model::Template &tmpl, float rate_hz);

    // Fills all members except `tmpl`, `store` and `kept`. `clip` of the template, `time_s` on its axis.
    KeyPoseSelection select(KeyPoseMode mode, uint32_t clip, double time_s) const;

    struct SampleTime {
        uint32_t clip = model::none;
        double time_s = 0;  // on the clip's axis
    };
    uint32_t count() const { return static_cast<uint32_t>(sample_times_.size()); }
    uint64_t bytes() const { return base::held_bytes(rows_, sample_times_); }
    const SampleTime &at(uint32_t pose) const { return sample_times_[pose]; }

private:
    struct Row {
        uint32_t first = 0, intervals = 0;
        bool closed = false;
        double start_s = 0, duration_s = 0;
    };

    model::Array<Row> rows_;
    model::Array<SampleTime> sample_times_;  // by key-pose
};

}  // namespace claque::animcache
