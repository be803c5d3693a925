#include "lib/asset/trajectories/rows.h"

#include <algorithm>
#include <cmath>

#include "lib/math/trig.h"

namespace claque::asset
{

namespace
{

// In the file's units: 1e9 are 10 000 km in centimetres.
bool is_possible(double value) { return std::fabs(value) <= 1e9; }

}  // namespace

void Rows::add(const Row &row)
{
    if (!is_possible(row.x) || !is_possible(row.y) || !is_possible(row.z) || !is_possible(row.time))
        return impossible.add(row.line);
    if (all.size() == all.capacity()) {
        const size_t more = std::max<size_t>(all.capacity() / 2, 256);
        budget_->charge(more * sizeof(Row), "the rows");
        all.reserve(all.capacity() + more);
    }
    all.push_back(row);
}

float heading_of_degrees(double degrees)
{
    double turn = std::fmod(degrees, 360.0);
    if (turn > 180) turn -= 360;
    if (turn <= -180) turn += 360;
    return static_cast<float>(turn * (math::pi / 180));
}

}  // namespace claque::asset
