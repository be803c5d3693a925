// Floating car data of SUMO: time steps with people, vehicles and containers in any order.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/asset/trajectories/xml.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

// Sets ids of vehicles apart from those of people.
constexpr std::string_view vehicle_mark = "vehicle ";

class FcdReader : public XmlHandler
{
public:
    FcdReader(const TrajectoryOptions &options, Reading &reading) : options_(options), reading_(reading) {}

    void begin(std::string_view name, const char *const *attributes, uint32_t depth, uint32_t line) override
    {
        if (depth == 1 && name != "fcd-export")
            fail(CLQ_FORMAT, "line %u: the root element is <%.60s>: <fcd-export> of SUMO is wanted", line,
                 std::string(name).c_str());
        if (depth == 2 && name == "timestep") begin_step(attributes, line);
        if (depth >= 3 && in_step_ && (name == "person" || name == "vehicle")) {
            const bool vehicle = name == "vehicle";
            add(attributes, vehicle, line);
            if (vehicle && vehicle_depth_ == 0) vehicle_depth_ = depth;
        }
    }

    void end(std::string_view, uint32_t depth) override
    {
        if (depth == vehicle_depth_) vehicle_depth_ = 0;
        if (depth == 2) end_step();
    }

    void comment(std::string_view text) override
    {
        for (const char *geographic : {"fcd-output.geo value=\"t", "fcd-output.geo value=\"1"})
            if (contains(text, geographic))
                fail(CLQ_UNSUPPORTED, "the file has geographic degrees: write it without --fcd-output.geo");
    }

private:
    struct Vehicle {
        double x, y, speed;
        bool operator<(const Vehicle &other) const
        {
            return std::tie(x, y, speed) < std::tie(other.x, other.y, other.speed);
        }
    };

    void begin_step(const char *const *attributes, uint32_t line)
    {
        time_ = demanded(attributes, "time", "a timestep", line);
        in_step_ = true;
    }

    static double demanded(const char *const *attributes, const char *name, const std::string &what, uint32_t line)
    {
        const char *text = attribute(attributes, name);
        double value = 0;
        if (!text) fail(CLQ_FORMAT, "line %u: %s has no %s", line, what.c_str(), name);
        if (!read_number(trimmed(text), value))
            fail(CLQ_FORMAT, "line %u: %s has the %s %s instead of a number", line, what.c_str(), name,
                 in_quotes(text).c_str());
        return value;
    }

    static double number_or(const char *const *attributes, const char *name, double otherwise)
    {
        const char *text = attribute(attributes, name);
        double value = 0;
        return text && read_number(trimmed(text), value) ? value : otherwise;
    }

    void add(const char *const *attributes, bool vehicle, uint32_t line)
    {
        const char *id = attribute(attributes, "id");
        if (!id) fail(CLQ_FORMAT, "line %u: a %s has no id", line, vehicle ? "vehicle" : "person");
        const std::string what = (vehicle ? "vehicle " : "person ") + in_quotes(id);
        Row row;
        row.time = time_, row.line = line;
        row.x = demanded(attributes, "x", what, line), row.y = demanded(attributes, "y", what, line);
        row.z = number_or(attributes, "z", 0);
        const double speed = number_or(attributes, "speed", NAN), angle = number_or(attributes, "angle", NAN);
        if (vehicle) {
            if (std::isfinite(row.x + row.y + speed)) vehicles_.push_back({row.x, row.y, speed});
            if (!options_.vehicles) return;
        }
        // From north, clockwise. People who wait have the angle 0, whatever their direction.
        const bool waits = !vehicle && angle == 0 && speed < 0.1;
        row.heading_rad = waits ? NAN : heading_of_degrees(90 - std::fmod(angle, 360.0));
        row.flags = vehicle ? CLQ_TRAJECTORY_VEHICLE : vehicle_depth_ ? CLQ_TRAJECTORY_RIDES : 0;
        ++reading_.rows.read;
        row.person = reading_.rows.ids.number_of((vehicle ? std::string(vehicle_mark) : "") + id);
        const size_t before = reading_.rows.all.size();
        reading_.rows.add(row);
        if (!vehicle && reading_.rows.all.size() > before) speeds_.push_back({before, speed});
    }

    // SUMO up to 1.15 writes a person who rides beside the vehicle, with its place and speed.
    void end_step()
    {
        std::sort(vehicles_.begin(), vehicles_.end());
        for (const auto &[at, speed] : speeds_) {
            Row &row = reading_.rows.all[at];
            if (std::binary_search(vehicles_.begin(), vehicles_.end(), Vehicle{row.x, row.y, speed}))
                row.flags = CLQ_TRAJECTORY_RIDES;
        }
        vehicles_.clear(), speeds_.clear();
        in_step_ = false;
    }

    const TrajectoryOptions &options_;
    Reading &reading_;
    double time_ = 0;
    bool in_step_ = false;
    uint32_t vehicle_depth_ = 0;  // of the element that people are inside of; 0: none
    std::vector<Vehicle> vehicles_;
    std::vector<std::pair<size_t, double>> speeds_;  // of people's rows of this step
};

}  // namespace

void read_sumo(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading)
{
    FcdReader reader(options, reading);
    read_xml(input.bytes, input.size, reading.budget, reader);
    std::vector<bool> known(reading.rows.ids.count());
    for (const Row &row : reading.rows.all) {
        if (!(row.flags & CLQ_TRAJECTORY_VEHICLE) || known[row.person]) continue;
        known[row.person] = true;
        reading.rows.ids.shorten(row.person, vehicle_mark.size());
    }
}

}  // namespace claque::asset
