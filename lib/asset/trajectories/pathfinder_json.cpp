// Pathfinder's JSON: people by id, each with positions by time. Read as it comes, without a document in memory.
#include <cmath>

#include <nlohmann/json.hpp>

#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint32_t deepest_json = 128;

// Levels: 1 the file, 2 a person, 3 a time, 4 the position.
class PathfinderHandler : public nlohmann::json_sax<nlohmann::json>
{
public:
    explicit PathfinderHandler(Reading &reading) : reading_(reading) {}

    bool null() override { return scalar("null"); }
    bool boolean(bool) override { return scalar("true or false"); }
    bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t &) override { return number(value); }
    bool string(string_t &) override { return scalar("a text"); }
    bool binary(binary_t &) override { return true; }

    bool start_object(size_t) override
    {
        deeper();
        if (depth_ == 3) begin_entry();
        if (depth_ == 4) in_position_ = position_next_;
        return true;
    }
    bool end_object() override
    {
        if (depth_ == 4) in_position_ = false;
        if (depth_ == 3 && person_ && !in_array_) end_entry();
        --depth_;
        return true;
    }
    bool start_array(size_t) override
    {
        scalar("an array");
        deeper(), ++in_array_;
        return true;
    }
    bool end_array() override
    {
        --depth_, --in_array_;
        return true;
    }
    bool key(string_t &text) override
    {
        if (in_array_) return true;
        if (depth_ == 1) person_ = true, id_ = text;
        if (depth_ == 2) time_ = text;
        if (depth_ == 3) position_next_ = text == "position";
        if (depth_ == 4) axis_ = text == "x" ? 0 : text == "y" ? 1 : text == "z" ? 2 : -1;
        return true;
    }
    bool parse_error(size_t at, const std::string &, const nlohmann::detail::exception &error) override
    {
        fail(CLQ_FORMAT, "the JSON is broken at byte %zu: %.200s", at, error.what());
    }

private:
    void deeper()
    {
        if (++depth_ > deepest_json) fail(CLQ_LIMIT, "the JSON is nested more than %u deep", deepest_json);
    }

    // Something other than an object where an object is wanted.
    bool scalar(const char *what)
    {
        if (!in_array_ && depth_ < 3)
            fail(CLQ_FORMAT, "the JSON has %s instead of %s", what,
                 depth_ == 0   ? "an object of people"
                 : depth_ == 1 ? "the times of a person"
                               : "an entry for a time");
        return true;
    }

    bool number(double value)
    {
        if (in_position_ && depth_ == 4 && !in_array_ && axis_ >= 0) place_[axis_] = value;
        return scalar("a number");
    }

    void begin_entry()
    {
        for (double &axis : place_) axis = NAN;
        place_[2] = 0;
        position_next_ = false;
    }

    void end_entry()
    {
        Rows &rows = reading_.rows;
        const uint32_t entry = static_cast<uint32_t>(++rows.read);
        Row row;
        row.line = entry, row.heading_rad = NAN;
        if (!read_number(time_, row.time))
            fail(CLQ_FORMAT, "entry %u, person %s: the time %s is no number", entry, in_quotes(id_).c_str(),
                 in_quotes(time_).c_str());
        row.person = rows.ids.number_of(id_);
        if (std::isnan(place_[0]) || std::isnan(place_[1])) return rows.missing.add(entry);
        row.x = place_[0], row.y = place_[1], row.z = place_[2];
        rows.add(row);
    }

    Reading &reading_;
    uint32_t depth_ = 0, in_array_ = 0;
    bool person_ = false, position_next_ = false, in_position_ = false;
    int axis_ = -1;
    std::string id_, time_;
    double place_[3] = {};
};

}  // namespace

void read_pathfinder_json(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    reading.place = "entry";
    PathfinderHandler handler(reading);
    const std::string_view text = input.text();
    (void)nlohmann::json::sax_parse(text.begin(), text.end(), &handler);
}

}  // namespace claque::asset
