// A city full of people, without a picture: blocks of houses, people on the pavements round them, a tenth of them
// walking round a block on tracks, and a square of people in view. For `claque bench million`.
#pragma once

#include <memory>
#include <vector>

#include "samples/scenes/check.h"

namespace cli
{

struct CityOptions {
    uint32_t count = 0;    // of people
    uint32_t in_view = 0;  // of these, on the square
    bool grouped = false;  // individuals that stand out of view are in a group for each block
    bool indexed = false;  // with a scene index
};

class CityCrowd
{
public:
    explicit CityCrowd(const CityOptions &options);
    ~CityCrowd();
    CityCrowd(const CityCrowd &) = delete;
    CityCrowd &operator=(const CityCrowd &) = delete;

    void update(double time_s);
    void save(std::vector<uint8_t> &out) const;
    void restore(const std::vector<uint8_t> &bytes);

    double created_s() const { return created_s_; }
    clq_crowd_stats stats() const;
    // All memory that claque holds now beside template and tracks, and that of the tracks.
    uint64_t held_bytes() const;
    uint64_t track_bytes() const { return track_bytes_; }

private:
    struct Hold;
    void make_tracks(uint32_t blocks_each_way);
    void people(const CityOptions &options, uint32_t blocks_each_way);

    std::unique_ptr<Hold> hold_;
    double created_s_ = 0;
    uint64_t before_bytes_ = 0, track_bytes_ = 0;
};

}  // namespace cli
