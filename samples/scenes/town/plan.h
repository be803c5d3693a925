// The plan of a small town in the country: streets, blocks, fields and a stream as strips of a grid in coordinates of
// its own (u to the east, v to the south), and the smooth map that bends this grid into the land. A strip of the plan
// becomes a curved street, a winding stream or a row of fields in the land.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenes::town
{

struct Point {
    double x, z;
};

// Between two lines of the grid. `group`: the number of the street or the block; fields have numbers of their own.
struct Strip {
    enum class Use : uint8_t { open, street, bank, water } use;
    double first, last;
    int group;
    double middle() const { return (first + last) / 2; }
};

// The cover of a cell of the grid.
enum class Cover : uint8_t { street, crossing, square, garden, park, field, wood, road, bank, water, embankment };

// In plan coordinates: its axis runs along u or along v.
struct Street {
    enum class Direction : uint8_t { east, south } direction;
    double at, half_width, first, last;
};

struct Block {
    double u0, u1, v0, v1;
    enum class Kind : uint8_t { houses, square, park, yards } kind;
};

class Plan
{
public:
    explicit Plan(uint64_t seed);

    Point at(double u, double v) const;
    // The images of the east and south directions under the map: of unit length.
    Point east(double u, double v) const;
    Point south(double u, double v) const;

    const std::vector<Strip> &strips_u() const { return u_; }
    const std::vector<Strip> &strips_v() const { return v_; }
    std::vector<double> lines_u() const;
    std::vector<double> lines_v() const;
    Cover cover(size_t column, size_t row) const;
    uint64_t parcel(size_t column, size_t row) const;  // the same number for cells of one field or garden

    const std::vector<Street> &streets() const { return streets_; }
    const std::vector<Block> &blocks() const { return blocks_; }
    const Block &square() const;
    double stream_u() const { return stream_u_; }
    double from_stream(double u) const { return u - stream_u_; }

    static constexpr int streets_each_way = 4;
    // the streets that continue into the country, of v and of u
    static constexpr int high_street = 1, south_street = 2;
    static constexpr double reach_m = 2700, yard_m = 40, water_half_m = 4.5, bank_m = 5;
    const std::vector<double> &streets_u() const { return street_u_; }
    const std::vector<double> &streets_v() const { return street_v_; }
    static double half_u(int street) { return street == south_street ? 5.0 : 4.2; }
    static double half_v(int street) { return street == high_street ? 5.0 : 4.2; }

private:
    void lay_streets();
    void lay_columns();
    void lay_rows();
    void lay_blocks();
    bool in_town(const Strip &strip) const;

    uint64_t seed_;
    double phases_[6];
    double stream_u_ = 0;
    std::vector<double> street_u_, street_v_;
    std::vector<Strip> u_, v_;
    std::vector<Street> streets_;
    std::vector<Block> blocks_;
};

}  // namespace scenes::town
