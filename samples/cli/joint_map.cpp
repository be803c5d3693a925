#include "samples/cli/joint_map.h"

#include <algorithm>

#include "samples/scenes/odeon/toml_table.h"

namespace cli
{
namespace
{

constexpr scenes::Limits seconds_key = {0, 1e6};

// "file", "bones", "character" or "frame:12".
void read_rest(scenes::TomlTable &all, JointMap &map)
{
    const std::string text = all.text("rest"), frame = "frame:";
    const std::string digits = text.rfind(frame, 0) == 0 ? text.substr(frame.size()) : "";
    if (text == "file") map.rest = CLQ_SOURCE_REST_FILE;
    else if (text == "bones") map.rest = CLQ_SOURCE_REST_BONES;
    else if (text == "character") map.rest = CLQ_SOURCE_REST_CHARACTER;
    else if (!digits.empty() && digits.size() < 10 && digits.find_first_not_of("0123456789") == std::string::npos) {
        map.rest = CLQ_SOURCE_REST_FRAME;
        map.rest_frame = static_cast<uint32_t>(std::stoul(digits));
    } else all.refuse("has the rest '" + text + "'; allowed are: file, bones, character, frame:0", "rest");
}

void read_options(scenes::TomlTable &all, JointMap &map)
{
    if (all.has("unit_m")) map.unit_m = all.number("unit_m", {1e-6, 1e6});
    if (all.has("prefix")) map.prefix = all.text("prefix");
    if (all.has("clips")) map.clips = all.texts("clips");
    if (all.has("rate_hz")) map.rate_hz = all.number("rate_hz", {1, 1000});
    if (all.has("start_s")) map.start_s = all.number("start_s", seconds_key);
    if (all.has("end_s")) map.end_s = all.number("end_s", seconds_key);
    if (all.has("close_s")) map.close_s = all.number("close_s", seconds_key);
    if (all.has("rest")) read_rest(all, map);
    if (all.has("travel") && !travel_named(all.text("travel"), map.travel))
        all.refuse("has the travel '" + all.text("travel") + "'; allowed are: in-place, keep", "travel");
}

}  // namespace

bool travel_named(const std::string &name, clq_root_travel &out)
{
    if (name != "in-place" && name != "keep") return false;
    out = name == "keep" ? CLQ_ROOT_TRAVEL_KEEP : CLQ_ROOT_TRAVEL_IN_PLACE;
    return true;
}

JointMap read_joint_map(const std::string &text, const std::string &where)
{
    const toml::table table = scenes::parse_toml(text, where);
    scenes::TomlTable all(table, where, "the map");
    JointMap map;
    read_options(all, map);
    if (all.has("joints"))
        for (const auto &[source, target] : all.table("joints", "[joints]").named_texts())
            map.joints.push_back({source, target, CLQ_REST_KEEP});
    if (all.has("align"))
        for (const std::string &name : all.texts("align")) {
            const auto joint = std::find_if(map.joints.begin(), map.joints.end(),
                                            [&](const JointMap::Joint &j) { return j.target == name; });
            if (joint == map.joints.end())
                all.refuse("aligns '" + name + "', which no line of [joints] binds", "align");
            joint->rest = CLQ_REST_ALIGN;
        }
    if (all.has("follow")) map.followers = all.table("follow", "[follow]").named_texts();
    if (all.has("follow_too")) map.followers_too = all.table("follow_too", "[follow_too]").named_texts();
    if (all.has("follow_too_share")) map.follow_too_share = all.number("follow_too_share", {0, 1});
    if (all.has("follow_share")) map.follow_share = all.number("follow_share", {0, 1});
    all.done();
    return map;
}

}  // namespace cli
