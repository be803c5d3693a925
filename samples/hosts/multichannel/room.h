// The whole simulator: one crowd, one update a frame, a wall of three channels that three threads draw, and the same
// wall as one wide picture for comparison.
#pragma once

#include "samples/hosts/multichannel/channel.h"
#include "samples/hosts/multichannel/wall.h"

namespace multichannel
{

// apart: a window for each screen, with a frustum of its own. spanning: one surface behind all screens, of which each
// channel draws its columns; GL then rounds alike in all of them.
enum class Surfaces : uint8_t { apart, spanning };

class Room
{
public:
    Room(int channel_width, int channel_height, Surfaces surfaces = Surfaces::apart);

    // Updates the crowd to this time and draws all channels.
    void show(double time_s);

    const std::vector<uint8_t> &picture(int column) const { return *pictures_.at(static_cast<size_t>(column)); }
    const std::vector<uint8_t> &wide() const { return *pictures_.back(); }
    std::vector<uint8_t> side_by_side() const;  // the channels, as wide as wide()

    const Channel &channel(int column) const { return *channels_.at(static_cast<size_t>(column)); }
    const Channel &wide_channel() const { return *channels_.back(); }
    const People &people() const { return people_; }

private:
    static constexpr size_t view_count = Wall::columns + 1;

    scenes::Library library_;
    People people_;
    Forum forum_;
    Wall wall_;
    const Surfaces surfaces_;
    std::array<std::unique_ptr<Channel>, view_count> channels_;  // the last one is the wide picture
    std::array<const std::vector<uint8_t> *, view_count> pictures_ = {};
};

}  // namespace multichannel
