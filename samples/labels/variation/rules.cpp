#include "samples/labels/variation/rules.h"

#include <cmath>

#include "samples/io/files.h"
#include "samples/scenes/odeon/toml_table.h"

namespace labels
{
namespace
{

using scenes::Failure;
using scenes::Limits;
using scenes::show;
using scenes::TomlTable;

// One section of the file. A value is a number, or [first, last] for all between.
class Section
{
public:
    Section(TomlTable table, std::string name, Rules &rules)
        : table_(std::move(table)), name_(std::move(name)), rules_(rules)
    {
    }

    bool take(const char *key, Limits limits, Span &out)
    {
        if (!table_.has(key)) return false;
        const std::vector<double> values = table_.numbers(key, limits);
        if (values.empty() || values.size() > 2)
            table_.refuse("has '" + std::string(key) + "' of " + std::to_string(values.size()) +
                              " numbers; it needs one, or [first, last]",
                          key);
        if (values.back() < values.front())
            table_.refuse("has '" + std::string(key) + "' = [" + show(values[0]) + ", " + show(values[1]) +
                              "], whose last is below its first",
                          key);
        out = {values.front(), values.back()};
        rules_.places[name_.empty() ? key : name_ + "." + key] = table_.place(key);
        return true;
    }
    void take(const char *key, Limits limits, std::optional<Span> &out)
    {
        Span span;
        if (take(key, limits, span)) out = span;
    }
    // Whole numbers.
    void take_whole(const char *key, Limits limits, std::optional<Span> &out)
    {
        take(key, limits, out);
        if (out && (out->first != std::floor(out->first) || out->last != std::floor(out->last)))
            table_.refuse("has '" + std::string(key) + "' that is no whole number", key);
    }
    TomlTable &table() { return table_; }

private:
    TomlTable table_;
    std::string name_;
    Rules &rules_;
};

void read_people(TomlTable &all, const scenes::ScenarioFiles &files, Rules &rules)
{
    Section people(all.table("people", "[people]"), "people", rules);
    people.take_whole("count", {1, 1e6}, rules.count);
    if (people.table().has("classes")) {
        Section classes(people.table().table("classes", "[people.classes]"), "people.classes", rules);
        for (const std::string &name : classes.table().names()) {
            Span share;
            classes.take(name.c_str(), {0, 1}, share);
            rules.classes.emplace_back(name, share);
        }
        rules.places["people.classes"] = people.table().place("classes");
    }
    if (people.table().has("colours")) {
        for (const std::string &name : people.table().texts("colours")) {
            const std::string path = name.empty() || name.front() == '/' ? name : files.folder + name;
            const std::string wrong = files.find(path);
            if (!wrong.empty())
                people.table().refuse("names a file in 'colours' that cannot be read: " + wrong, "colours");
            rules.colours.push_back(path), rules.files.push_back(path);
        }
        rules.places["people.colours"] = people.table().place("colours");
    }
    people.table().done();
}

void read_camera(TomlTable &all, Rules &rules)
{
    Section camera(all.table("camera", "[camera]"), "camera", rules);
    CameraRules &made = rules.camera.emplace();
    camera.take("height_m", {0, 1000}, made.height_m);
    camera.take("distance_m", {0.3, 1000}, made.distance_m);
    camera.take("heading_deg", {-360, 720}, made.heading_deg);
    camera.take("pitch_deg", {-80, 80}, made.pitch_deg);
    camera.take("fov_deg", {5, 120}, made.fov_deg);
    if (camera.table().has("faces_m")) made.faces_m = camera.table().number("faces_m", {0, 1000});
    camera.table().done();
    rules.places["camera"] = all.place("camera");
}

void read_light(TomlTable &all, Rules &rules)
{
    Section light(all.table("light", "[light]"), "light", rules);
    light.take("hour", {5.5, 18.5}, rules.hour);
    light.take("sun", {0, 3}, rules.sun);
    light.take("sky", {0, 3}, rules.sky);
    light.table().done();
}

void read_sensor(TomlTable &all, Rules &rules)
{
    Section sensor(all.table("sensor", "[sensor]"), "sensor", rules);
    sensor.take("read_noise", {0, 64}, rules.read_noise);
    sensor.take("shot_noise", {0, 64}, rules.shot_noise);
    sensor.take_whole("jpeg_quality", {1, 100}, rules.jpeg_quality);
    sensor.table().done();
}

}  // namespace

Rules read_rules(const std::string &text, const std::string &where, const scenes::ScenarioFiles &files)
{
    const toml::table table = scenes::parse_toml(text, where);
    Rules rules;
    Section all(TomlTable(table, where, "the file of rules"), "", rules);
    all.take("time_s", {0, 1e6}, rules.time_s);
    if (all.table().has("people")) read_people(all.table(), files, rules);
    if (all.table().has("camera")) read_camera(all.table(), rules);
    if (all.table().has("light")) read_light(all.table(), rules);
    if (all.table().has("haze")) {
        Section haze(all.table().table("haze", "[haze]"), "haze", rules);
        haze.take("visibility_m", {5, 1e6}, rules.visibility_m);
        haze.table().done();
    }
    if (all.table().has("sensor")) read_sensor(all.table(), rules);
    all.table().done();
    return rules;
}

Rules load_rules(const std::string &path)
{
    std::string text;
    const std::string wrong = io::read_whole(path, text);
    if (!wrong.empty()) throw Failure(wrong);
    return read_rules(text, path, scenes::files_beside(path));
}

}  // namespace labels
