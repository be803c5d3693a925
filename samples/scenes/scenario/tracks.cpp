// [tracks]: a file of where people walked. Its keys are the options of `claque play`.
#include "samples/scenes/scenario/tracks.h"

#include <cstdlib>

#include "samples/scenes/scenario/sections.h"

namespace scenes
{

std::string read_unit(const std::string &unit, double &metres)
{
    metres = unit == "m" ? 1 : unit == "cm" ? 0.01 : unit == "mm" ? 0.001 : unit == "ft" ? 0.3048 : 0;
    if (metres > 0) return {};
    char *end = nullptr;
    metres = std::strtod(unit.c_str(), &end);
    if (!unit.empty() && *end == '\0' && metres > 0 && metres <= 1e6) return {};
    return "'" + unit + "' is no unit: m, cm, mm, ft, or the metres in one";
}

void read_tracks(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    TomlTable tracks = all.table("tracks", "[tracks]");
    TrackFile made;
    made.at = tracks.place();
    made.path = file_of(tracks, "file", files);
    if (tracks.has("columns")) {
        made.columns = tracks.text("columns");
        if (made.columns.empty()) tracks.refuse("has columns without names", "columns");
        made.reading.format = CLQ_TRAJECTORY_TABLE;
    }
    if (tracks.has("rate_hz")) made.reading.rate_hz = tracks.number("rate_hz", {1e-6, 1e6});
    if (tracks.has("unit")) {
        const std::string wrong = read_unit(tracks.text("unit"), made.reading.metres_per_unit);
        if (!wrong.empty()) tracks.refuse("has a unit that is not known: " + wrong, "unit");
    }
    if (tracks.has("up")) {
        const std::string up = tracks.text("up");
        if (up != "y" && up != "z") tracks.refuse("has up = '" + up + "', which is neither y nor z", "up");
        made.reading.up = up == "y" ? CLQ_UP_Y : CLQ_UP_Z;
    }
    if (tracks.has("max_speed_m_s")) made.reading.max_speed_m_s = tracks.number("max_speed_m_s", {0.1, 1e6});
    if (tracks.has("vehicles")) made.reading.vehicles = tracks.flag("vehicles");
    if (tracks.has("origin_m")) made.origin = tracks.pair("origin_m", {-1e9, 1e9});
    tracks.done();
    scenario.tracks = std::move(made);
}

}  // namespace scenes
