// Walkable areas for `claque bench readers`.
#include <claque/trajectories.h>

#include <cmath>

#include "samples/cli/reader_parts.h"

namespace cli
{
namespace area_readers
{
namespace
{

std::string at(uint32_t x, uint32_t y) { return digits(x) + " " + digits(y); }

// A triangle with a corner at (x, y).
std::string corners(uint32_t x, uint32_t y) { return "(" + at(x, y) + "," + at(x + 1, y) + "," + at(x, y + 1) + ")"; }

std::string wkt_polygons(uint32_t count)
{
    return repeated(
        "MULTIPOLYGON(", count, [](uint32_t i) { return (i ? ",(" : "(") + corners(2 * i, 0) + ")"; }, ")");
}

std::string wkt_points(uint32_t count)
{
    return repeated(
        "POLYGON((0 0", std::max(count, 3u) - 1, [](uint32_t i) { return "," + at(i + 1, (i + 1) * (i + 1)); }, "))");
}

std::string wkt_holes(uint32_t count)
{
    const uint32_t side = static_cast<uint32_t>(std::sqrt(double(count))) + 2;
    const std::string end = digits(3 * side);
    return repeated(
        "POLYGON((0 0," + end + " 0," + end + " " + end + ",0 " + end + ")", count,
        [=](uint32_t i) { return "," + corners(1 + 3 * (i % side), 1 + 3 * (i / side)); }, ")");
}

std::string wkt_collections(uint32_t count)
{
    return repeated("", count, [](uint32_t) { return std::string("GEOMETRYCOLLECTION("); }) + "POLYGON(" +
           corners(0, 0) + ")" + std::string(count, ')');
}

std::string vertex(uint32_t x, uint32_t y) { return "<vertex px=\"" + digits(x) + "\" py=\"" + digits(y) + "\"/>"; }

std::string room(uint32_t i)
{
    return "<subroom><polygon>" + vertex(2 * i, 0) + vertex(2 * i + 1, 0) + vertex(2 * i, 1) + vertex(2 * i, 0) +
           "</polygon></subroom>";
}

std::string geo_rooms(uint32_t count) { return repeated("<geometry>", count, room, "</geometry>"); }

std::string geo_walls(uint32_t count)
{
    return repeated(
        "<geometry><subroom>", count,
        [](uint32_t i) { return "<polygon>" + vertex(i, 0) + vertex(i, 1) + "</polygon>"; }, "</subroom></geometry>");
}

std::string nav_nodes(uint32_t count)
{
    const std::string vertices = repeated(
        "", count, [](uint32_t i) { return at(2 * i, 0) + "\n" + at(2 * i + 1, 0) + "\n" + at(2 * i, 1) + "\n"; });
    return repeated(digits(3 * count) + "\n" + vertices + "0\n0\nwalk\n" + digits(count) + "\n", count, [](uint32_t i) {
        return at(2 * i, 0) + "\n3 " + at(3 * i, 3 * i + 1) + " " + digits(3 * i + 2) + "\n0 0 0\n0\n0\n";
    });
}

std::string nav_obstacles(uint32_t count)
{
    return "3\n0 0\n1 0\n0 1\n0\n" + digits(count) + "\n" +
           repeated("", count, [](uint32_t) { return std::string("0 1 0 0\n"); }) +
           "walk\n1\n0 0\n3 0 1 2\n0 0 0\n0\n0\n";
}

std::string vadere_obstacles(uint32_t count)
{
    const uint32_t side = static_cast<uint32_t>(std::sqrt(double(count))) + 2;
    const std::string size = digits(3 * side);
    return repeated(
        "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": " + size +
            ", \"height\": " + size + "}}, \"obstacles\": [",
        count,
        [=](uint32_t i) {
            return std::string(i ? ", " : "") +
                   "{\"shape\": {\"type\": \"RECTANGLE\", \"x\": " + digits(1 + 3 * (i % side)) +
                   ", \"y\": " + digits(1 + 3 * (i / side)) + ", \"width\": 1, \"height\": 1}}";
        },
        "]}}}");
}

Reading read_area(scenes::Library &library, const std::string &bytes)
{
    return timed([&] {
        clq_area *made = nullptr;
        const clq_status status = clq_area_load_memory(library.context(), bytes.data(), bytes.size(), nullptr, &made);
        clq_area_destroy(made);
        return outcome_of(status);
    });
}

}  // namespace
}  // namespace area_readers

std::vector<ReaderElement> reader_elements_of_areas()
{
    using namespace area_readers;
    return {{"area", "polygons of WKT", most_elements, wkt_polygons, read_area},
            {"area", "points of a polygon", 10000, wkt_points, read_area},
            {"area", "holes of a polygon", 3000, wkt_holes, read_area},
            {"area", "collections in each other", 128, wkt_collections, read_area},
            {"area", "rooms of JuPedSim", most_elements, geo_rooms, read_area},
            {"area", "walls of JuPedSim", most_elements, geo_walls, read_area},
            {"area", "nodes of Menge", most_elements, nav_nodes, read_area},
            {"area", "obstacles of Menge", most_elements, nav_obstacles, read_area},
            {"area", "obstacles of Vadere", 2400, vadere_obstacles, read_area}};
}

}  // namespace cli
