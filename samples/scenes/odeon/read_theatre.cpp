// Reads a theatre from its description (S1 2: seats on circular layers with a radius and an angle of their own).
#include "samples/scenes/odeon/theatre.h"
#include "samples/scenes/odeon/toml_table.h"
#include "samples/scenes/odeon/validate_theatre.h"

namespace scenes
{
namespace
{

constexpr Limits radius_m = {1, 200}, height_limits_m = {-50, 100}, turn_deg = {-180, 180}, fraction = {0, 1};
constexpr Limits row_number = {1, 100}, people = {0, 100000};

void refuse_old_key(TomlTable &table, const char *old_key, const char *key)
{
    if (table.has(old_key)) table.refuse("has '" + std::string(old_key) + "', which is now '" + key + "'", old_key);
}

void read_rows(TomlTable rows, Theatre &theatre)
{
    const uint32_t count = rows.whole("count", row_number);
    const double depth = rows.number("depth_m", {0.7, 3}), rise = rows.number("rise_m", {0.40, 0.46});
    SeatRow row;
    row.radius_m = rows.number("radius_m", radius_m);
    row.depth_m = depth;
    row.seat_y_m = rows.number("seat_y_m", height_limits_m);
    const auto [first, last] = rows.pair("sweep_deg", turn_deg);
    if (!(first < last))
        rows.refuse("has a sweep from " + show(first) + " to " + show(last) + " degrees, which is descending",
                    "sweep_deg");
    row.first_deg = first;
    row.last_deg = last;
    refuse_old_key(rows, "who", "class");
    if (rows.has("class")) row.social_class = rows.text("class");
    rows.done();
    if (theatre.rows.size() + count > row_number.last)
        rows.refuse("would make row " + show(double(theatre.rows.size() + count)) + "; the limit is " +
                    show(row_number.last));
    for (uint32_t i = 0; i < count; ++i) {
        row.step_y_m = row.seat_y_m - rise;
        theatre.rows.push_back(row);
        row.radius_m += depth;
        row.seat_y_m += rise;
    }
}

void read_gangways(TomlTable gangways, Theatre &theatre)
{
    Gangway gangway;
    gangway.width_m = gangways.number("width_m", {0.4, 10});
    const auto [first, last] = gangways.pair("rows", {1, double(theatre.rows.size())});
    if (!(first <= last) || first != double(size_t(first)) || last != double(size_t(last)))
        gangways.refuse(
            "goes from row " + show(first) + " to row " + show(last) + "; it needs two whole numbers, the lower first",
            "rows");
    gangway.first_row = static_cast<size_t>(first) - 1;
    gangway.last_row = static_cast<size_t>(last) - 1;
    for (const double at : gangways.numbers("at_deg", turn_deg)) {
        gangway.at_deg = at;
        theatre.gangways.push_back(gangway);
    }
    gangways.done();
}

clq_hsb_range read_range(TomlTable dye)
{
    const auto hue = dye.pair("hue", {0, 360}), saturation = dye.pair("saturation", fraction),
               brightness = dye.pair("brightness", fraction);
    if (saturation[0] > saturation[1]) dye.refuse("has its saturation in the wrong order", "saturation");
    if (brightness[0] > brightness[1]) dye.refuse("has its brightness in the wrong order", "brightness");
    dye.done();
    return {static_cast<float>(hue[0]),        static_cast<float>(hue[1]),        static_cast<float>(saturation[0]),
            static_cast<float>(saturation[1]), static_cast<float>(brightness[0]), static_cast<float>(brightness[1])};
}

void read_class(TomlTable described_class, Theatre &theatre)
{
    SocialClass made;
    made.name = described_class.text("name");
    refuse_old_key(described_class, "figure", "character");
    made.character = described_class.text("character");
    made.count = described_class.whole("count", people);
    if (described_class.has("palette"))
        for (auto &[zone, dye] : described_class.table("palette", "class '" + made.name + "'")
                                     .named_tables("palette entry of class '" + made.name + "' for"))
            made.palette.push_back({zone, read_range(dye)});
    described_class.done();
    for (const SocialClass &other : theatre.classes)
        if (other.name == made.name) described_class.refuse("is a second class '" + made.name + "'", "name");
    const char *const characters[] = {"citizen", "patrician", "decurion", "plebeian"};
    for (const char *character : characters)
        if (made.character == character) {
            theatre.classes.push_back(std::move(made));
            return;
        }
    described_class.refuse("has the character '" + made.character +
                               "', which is not built in; there are: citizen, patrician, decurion, plebeian",
                           "character");
}

void read_stage(TomlTable stage, Theatre &theatre)
{
    theatre.stage.front_z_m = stage.number("front_z_m", {0, 200});
    theatre.stage.depth_m = stage.number("depth_m", {0.5, 50});
    theatre.stage.half_width_m = stage.number("half_width_m", {1, 200});
    theatre.stage.floor_y_m = stage.number("floor_y_m", {0, 5});
    theatre.stage.wall_height_m = stage.number("wall_height_m", {0, 60});
    stage.done();
}

void read_audience(TomlTable &all, Theatre &theatre)
{
    if (!all.has("audience")) all.refuse("has no audience: it needs [audience] and at least one [[audience.classes]]");
    TomlTable audience = all.table("audience", "[audience]");
    theatre.facing_noise_deg = audience.number("facing_noise_deg", {0, 20});
    for (TomlTable &one : audience.tables("classes", "[[audience.classes]]")) read_class(one, theatre);
    if (theatre.classes.empty()) audience.refuse("has no classes: it needs at least one [[audience.classes]]");
    audience.done();
}

}  // namespace

Theatre read_theatre(const std::string &text, const std::string &where)
{
    const toml::table table = parse_toml(text, where);
    TomlTable all(table, where, "the theatre");
    Theatre theatre;
    theatre.name = all.text("name");
    TomlTable orchestra = all.table("orchestra", "[orchestra]"), seats = all.table("seats", "[seats]");
    theatre.orchestra_radius_m = orchestra.number("radius_m", radius_m);
    orchestra.done();
    theatre.seat_width_m = seats.number("width_m", {0.64, 2});
    seats.done();
    for (TomlTable &rows : all.tables("rows", "[[rows]]")) read_rows(rows, theatre);
    if (theatre.rows.empty()) all.refuse("has no seats: it needs at least one [[rows]]");
    for (TomlTable &one : all.tables("walkways", "[[walkways]]")) {
        theatre.walkways.push_back(
            {one.number("inner_m", radius_m), one.number("outer_m", radius_m), one.number("y_m", height_limits_m)});
        one.done();
    }
    for (TomlTable &one : all.tables("gangways", "[[gangways]]")) read_gangways(one, theatre);
    read_stage(all.table("stage", "[stage]"), theatre);
    read_audience(all, theatre);
    all.done();
    validate(theatre, where);
    return theatre;
}

}  // namespace scenes
