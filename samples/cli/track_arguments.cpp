#include "samples/cli/track_arguments.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "samples/cli/files.h"
#include "samples/cli/scene_about.h"
#include "samples/scenes/scenario/tracks.h"
#include "samples/scenes/walkers/cast.h"
#include "samples/scenes/walkers/record_file.h"

namespace cli
{

namespace
{

double metres_of(const std::string &unit)
{
    double metres = 0;
    if (!unit.empty()) scenes::read_unit(unit, metres);
    return metres;
}

std::string check_unit(const std::string &text)
{
    double metres = 0;
    return scenes::read_unit(text, metres);
}

}  // namespace

void add_reading_options(CLI::App &command, TrackArguments &a)
{
    command.add_option("--columns", a.columns, "Columns of a table: id, frame or time, x, y, z, heading, with commas")
        ->type_name("NAMES");
    command.add_option("--rate", a.rate_hz, "Frame numbers in a second, where the file does not say it")
        ->check(CLI::Range(1e-6, 1e6));
    command.add_option("--unit", a.unit, "Unit of the coordinates, where the file does not say it")
        ->type_name("m|cm|mm|ft|METRES")
        ->check(CLI::Validator(check_unit, ""));
    command.add_option("--up", a.up, "The coordinate that points up, where a table has three")
        ->check(CLI::IsMember({"y", "z"}));
    command.add_option("--max-speed", a.max_speed_m_s, "A person that is faster, in m/s, becomes another person there")
        ->check(CLI::Range(0.1, 1e6))
        ->capture_default_str();
    command.add_flag("--vehicles", a.vehicles,
                     "SUMO: vehicles too, as boxes, and the people that ride in them, in seats");
}

void add_limb_options(CLI::App &command, scenes::WalkingNodes &limbs, scenes::SocialClass::Clips &gaits)
{
    command
        .add_option_function<std::string>(
            "--legs", [&limbs](const std::string &names) { limbs.legs = names_in(names); },
            "Nodes of the characters of files that walk, with commas: thigh, shin and foot of the left leg, then "
            "of the right; or thigh, shin, foot and toes (default: found by their names)")
        ->type_name("NAMES");
    for (const auto &[option, name] :
         {std::pair("--torso", &limbs.torso), {"--neck", &limbs.neck}, {"--head", &limbs.head}})
        command.add_option(option, *name, "Node of these characters that turns with what they look at")
            ->type_name("NAME");
    command
        .add_option("--walk", gaits.walk, "Clip by which these characters walk (default: one named walk or walking)")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--idle", [&gaits](const std::string &name) { gaits.idles = {name}; },
            "Clip of these characters while they stand (default: those named stand or idle, else the rest pose)")
        ->type_name("NAME");
}

void add_walking_options(CLI::App &command, TrackArguments &a)
{
    command
        .add_option("--characters", a.characters,
                    "Who walks: built-in people and glTF files with clips named walk, run and idle, with commas "
                    "(default citizen,patrician,plebeian,decurion)")
        ->type_name("NAMES");
    add_limb_options(command, a.limbs, a.gaits);
    command.add_option("--ground", a.area, "The walkable area: WKT, JuPedSim, Menge or Vadere (docs/trajectories.md)")
        ->type_name("FILE");
}

clq_trajectories_def reading_of(const TrackArguments &a)
{
    clq_trajectories_def def = clq_trajectories_def_init();
    def.columns = a.columns.empty() ? nullptr : a.columns.c_str();
    if (!a.columns.empty()) def.format = CLQ_TRAJECTORY_TABLE;
    def.rate_hz = a.rate_hz;
    def.metres_per_unit = metres_of(a.unit);
    def.up = a.up == "y" ? CLQ_UP_Y : a.up == "z" ? CLQ_UP_Z : CLQ_UP_OF_FILE;
    def.max_speed_m_s = a.max_speed_m_s;
    def.vehicles = a.vehicles;
    return def;
}

void refuse_walking_options(const CLI::App &command)
{
    for (const char *name : {"--ground", "--legs", "--torso", "--neck", "--head", "--walk", "--idle"})
        if (command.count(name) > 0) throw CLI::ValidationError(name, "is for a file of trajectories");
}

void refuse_track_options(const CLI::App &command)
{
    for (const char *name : {"--columns", "--rate", "--unit", "--up", "--max-speed", "--vehicles", "--characters"})
        if (command.count(name) > 0) throw CLI::ValidationError(name, "is for a file of trajectories");
    refuse_walking_options(command);
}

void refuse_reading_options(const CLI::App &command, bool takes_rate)
{
    for (const char *name : {"--columns", "--unit", "--up", "--vehicles", "--ground", "--record", "--rate"}) {
        const CLI::Option *option = command.get_option_no_throw(name);
        if (option && option->count() > 0 && !(takes_rate && std::string(name) == "--rate"))
            throw CLI::ValidationError(name, "is for files of trajectories; FILE is a record");
    }
}

std::vector<std::string> names_in(const std::string &list)
{
    std::vector<std::string> names;
    std::stringstream text(list);
    for (std::string name; std::getline(text, name, ',');)
        if (!name.empty()) names.push_back(name);
    return names;
}

namespace
{

// Early, as characters take time.
void expect_clips(const TrackArguments &a)
{
    if (!a.clips.map.empty()) expect_readable(a.clips.map, io::most_text_bytes);
    for (const std::string &file : a.clips.files)
        if (scenes::is_file(file)) expect_readable(file);
    const std::vector<std::string> names = names_in(a.characters);
    if (!a.clips.files.empty() && std::none_of(names.begin(), names.end(), scenes::is_file))
        throw scenes::Failure("--clips are for characters of files, and none is shown");
}

}  // namespace

scenes::walkers::Options walkers_of(const TrackArguments &a, const scenes::Placement &placed)
{
    expect_clips(a);
    scenes::walkers::Options options;
    options.file = a.file;
    options.reading = reading_of(a);
    options.columns = a.columns;
    for (const std::string &name : names_in(a.characters)) {
        scenes::SocialClass one = scenes::walkers::class_of(name);
        if (scenes::is_file(name)) {
            one.placement = placed, one.limbs = a.limbs, one.clips = a.gaits;
            if (!a.clips.files.empty())
                one.add_clips = [clips = a.clips](scenes::Library &library, clq_asset *asset) {
                    add_clips(library, asset, clips);
                };
        }
        options.characters.push_back(one);
    }
    expect_files(options.characters, placed);
    options.area = a.area;
    options.follow = followed_by(a.camera);
    return options;
}

ShownTimes times_of(const std::string &file, const clq_trajectories_def &reading)
{
    scenes::Library library(1);
    if (scenes::walkers::is_record(file)) {
        const scenes::walkers::RecordFile record(library, file);
        return {record.info.start_s, record.info.end_s};
    }
    clq_trajectories *made = nullptr;
    scenes::check(clq_trajectories_load(library.context(), file.c_str(), &reading, &made));
    clq_trajectories_info info = clq_trajectories_info_init();
    const clq_status status = clq_trajectories_get_info(made, &info);
    clq_trajectories_destroy(made);
    scenes::check(status);
    return {0, info.max_s - info.min_s};
}

bool names_trajectories(const std::string &subject)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    return fs::exists(subject, ignored) && !fs::is_directory(subject, ignored) && !is_character_file(subject);
}

std::shared_ptr<const scenes::Scenario> scenario_of(const TrackArguments &a, const scenes::Placement &placed)
{
    const scenes::walkers::Options options = walkers_of(a, placed);
    auto out = std::make_shared<scenes::Scenario>();
    out->name = std::filesystem::path(a.file).filename().string();
    out->tracks.emplace();
    out->tracks->path = a.file;
    out->tracks->columns = a.columns;
    out->tracks->reading = options.reading;
    out->tracks->reading.columns = nullptr;
    out->characters = options.characters;
    out->area = a.area;
    out->files = {a.file};
    if (!a.area.empty()) out->files.push_back(a.area);
    return out;
}

Json tracks_about(const TrackArguments &a)
{
    Json about = {{"columns", a.columns},
                  {"rate_hz", a.rate_hz},
                  {"unit", a.unit},
                  {"up", a.up},
                  {"max_speed_m_s", a.max_speed_m_s},
                  {"vehicles", a.vehicles},
                  {"characters", Json::array()}};
    for (const std::string &name : names_in(a.characters)) about["characters"].push_back(file_about(name));
    if (!a.limbs.legs.empty()) about["legs"] = a.limbs.legs;
    if (!a.gaits.walk.empty()) about["walk"] = a.gaits.walk;
    if (!a.gaits.idles.empty()) about["idle"] = a.gaits.idles;
    for (const std::string &file : a.clips.files) about["clips"].push_back(file_about(file));
    if (!a.clips.map.empty()) about["map"] = file_about(a.clips.map);
    if (!followed_by(a.camera).empty()) about["follow"] = followed_by(a.camera);
    for (const std::string &name : {a.limbs.torso, a.limbs.neck, a.limbs.head})
        if (!name.empty()) about["limbs"].push_back(name);
    return about;
}

}  // namespace cli
