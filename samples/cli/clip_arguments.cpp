#include "samples/cli/clip_arguments.h"

#include "samples/cli/characters.h"
#include "samples/cli/files.h"
#include "samples/cli/joint_map.h"

namespace cli
{
namespace
{

JointMap map_of(const ClipArguments &a)
{
    JointMap map = a.map.empty() ? JointMap() : read_joint_map(text_of(a.map), a.map);
    if (a.unit_m > 0) map.unit_m = a.unit_m;
    if (a.start_s >= 0) map.start_s = a.start_s;
    if (a.end_s >= 0) map.end_s = a.end_s;
    if (a.close_s >= 0) map.close_s = a.close_s;
    if (a.rate_hz > 0) map.rate_hz = a.rate_hz;
    if (!a.travel.empty()) travel_named(a.travel, map.travel);
    return map;
}

}  // namespace

CLI::Option *add_clip_files(CLI::App &command, ClipArguments &a)
{
    CLI::Option *files =
        command
            .add_option("--clips", a.files,
                        "Add the clips of this file, bound by joint name: glTF, GLB, VRM Animation, BVH, "
                        "or the name of a built-in character (may repeat)")
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
    command
        .add_option("--map", a.map,
                    "Map (TOML) that binds joints of the clips to joints of the character and says how clips are read")
        ->type_name("FILE");
    return files;
}

void add_clip_options(CLI::App &command, ClipArguments &a)
{
    CLI::Option *files = add_clip_files(command, a);
    command.get_option("--map")->needs(files);
    command.add_option("--vary", a.vary, "Vary the clips of a built-in person until it has this many, such as 150")
        ->check(CLI::Range(23, 2000));
    command.add_option("--unit", a.unit_m, "Metres of one unit in BVH files (default 1, or what the map says)")
        ->check(CLI::Range(1e-6, 1e6));
    command.add_option("--from", a.start_s, "Seconds to skip at the beginning of each clip")
        ->check(CLI::Range(0.0, 1e6))
        ->needs(files);
    command.add_option("--to", a.end_s, "End of each clip, in seconds")->check(CLI::Range(0.0, 1e6))->needs(files);
    command.add_option("--close", a.close_s, "Seconds before a clip's end over which it blends into its first pose")
        ->check(CLI::Range(0.0, 1e6))
        ->needs(files);
    command.add_option("--rate", a.rate_hz, "Keys a second of retargeted clips (default 30)")
        ->check(CLI::Range(1.0, 1000.0))
        ->needs(files);
    command
        .add_option("--root-travel", a.travel,
                    "Whether the topmost joint keeps the clips' travel (keep) or stays in place (in-place)")
        ->check(CLI::IsMember({"in-place", "keep"}))
        ->needs(files);
}

uint32_t add_clips(scenes::Library &library, clq_asset *asset, const ClipArguments &a)
{
    if (a.files.empty()) return 0;
    const JointMap map = map_of(a);
    std::vector<clq_joint_pair> pairs;
    for (const JointMap::Joint &joint : map.joints)
        pairs.push_back({joint.source.c_str(), joint.target.c_str(), joint.rest});
    std::vector<clq_follower> followers;
    for (const auto &[joint, leader] : map.followers)
        followers.push_back({joint.c_str(), leader.c_str(), static_cast<float>(map.follow_share)});
    for (const auto &[joint, leader] : map.followers_too)
        followers.push_back({joint.c_str(), leader.c_str(), static_cast<float>(map.follow_too_share)});
    std::vector<const char *> clips;
    for (const std::string &name : map.clips) clips.push_back(name.c_str());
    clq_clips_def def = clq_clips_def_init();
    def.joints = pairs.data();
    def.joint_count = static_cast<uint32_t>(pairs.size());
    def.followers = followers.data();
    def.follower_count = static_cast<uint32_t>(followers.size());
    def.clips = clips.data();
    def.clip_count = static_cast<uint32_t>(clips.size());
    def.prefix = map.prefix.c_str();
    def.rest = map.rest;
    def.rest_frame = map.rest_frame;
    def.travel = map.travel;
    def.rate_hz = static_cast<float>(map.rate_hz);
    def.start_s = static_cast<float>(map.start_s);
    def.end_s = static_cast<float>(map.end_s);
    def.close_s = static_cast<float>(map.close_s);
    const clq_asset_info before = info_of(asset);
    ClipArguments source_arguments;
    source_arguments.unit_m = map.unit_m;
    for (const std::string &file : a.files) {
        const scenes::Own<clq_asset> source = load_asset(library, file, in_own_size({}, file), source_arguments);
        scenes::check(clq_asset_add_clips(library.context(), asset, source.get(), &def, nullptr), file);
    }
    return before.clip_count;
}

}  // namespace cli
