// A picture in upright tiles, whose borders follow what the tiles of the last picture cost. People are taller than
// wide, so fewer of them stand on an upright border than on a level one. Where the borders are changes no pixel.
#pragma once

#include <vector>

namespace processes
{

// Columns [x0, x1) of the picture.
struct Tile {
    int x0, x1;
};

class TileBorders
{
public:
    // At most one tile for each column of pixels.
    TileBorders(int width_px, int count);

    const std::vector<Tile> &tiles() const { return tiles_; }
    // What each of them cost, in any unit. Moves the borders so that tiles cost the same if the cost is even within
    // each of the present ones.
    void follow(const std::vector<double> &costs);

private:
    int width_px_;
    std::vector<Tile> tiles_;
};

}  // namespace processes
