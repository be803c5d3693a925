// The topography of a Vadere scenario: a rectangle, and obstacles in it.
#include <algorithm>
#include <cmath>

#include "lib/asset/areas/area_readers.h"
#include "lib/asset/json_view.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

double metres(const JsonView &value)
{
    const double number = value.number();
    if (!(std::fabs(number) <= 1e9)) fail(CLQ_FORMAT, "%s is %g: at most 1e9 is wanted", value.path().c_str(), number);
    return number;
}

Ring rectangle(const JsonView &shape, double inset)
{
    const double x = metres(shape["x"]) + inset, y = metres(shape["y"]) + inset;
    const double width = metres(shape["width"]) - 2 * inset, height = metres(shape["height"]) - 2 * inset;
    if (!(width > 0 && height > 0)) fail(CLQ_FORMAT, "%s encloses nothing", shape.path().c_str());
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Ring outline(const JsonView &shape)
{
    const std::string &type = shape["type"].text();
    if (type == "RECTANGLE") return rectangle(shape, 0);
    if (type != "POLYGON")
        fail(CLQ_UNSUPPORTED, "%s is a %.40s: POLYGON and RECTANGLE are read", shape.path().c_str(), type.c_str());
    Ring out;
    const JsonView points = shape["points"];
    for (size_t i = 0; i < points.count(); ++i) out.push_back({metres(points.at(i)["x"]), metres(points.at(i)["y"])});
    return out;
}

}  // namespace

void read_vadere_scenario(const uint8_t *bytes, size_t size, AreaBuilder &out)
{
    const JsonDocument document(bytes, size, 8 * (uint64_t(1) << 20) + 40 * uint64_t(size));
    const JsonView topography = document.root()["scenario"]["topography"];
    if (!topography.exists()) fail(CLQ_FORMAT, "the JSON has no scenario.topography: it is not a scenario of Vadere");
    const JsonView attributes = topography["attributes"];
    const bool bounded = attributes["bounded"].boolean_or(true);
    const JsonView width = attributes["boundingBoxWidth"];
    std::vector<Ring> rings{rectangle(attributes["bounds"], bounded && width.exists() ? metres(width) : 0)};
    const JsonView obstacles = topography["obstacles"];
    for (size_t i = 0; i < obstacles.count(); ++i) rings.push_back(outline(obstacles.at(i)["shape"]));
    AreaBuilder whole;
    try {
        whole.add_polygon(rings);
        out = std::move(whole);
    } catch (const base::Error &error) {
        if (error.status() != CLQ_FORMAT) throw;
        // Obstacles may touch and overlap. The ground below them is then filled, too.
        out.add_polygon({rings[0]});
        for (size_t i = 1; i < rings.size(); ++i)
            for (size_t k = 0; k < rings[i].size(); ++k) {
                const uint32_t from = out.add_point(rings[i][k]);
                out.add_wall(from, out.add_point(rings[i][(k + 1) % rings[i].size()]));
            }
        out.warn("obstacles overlap: they are walls, and the ground goes on below them");
    }
}

}  // namespace claque::asset
