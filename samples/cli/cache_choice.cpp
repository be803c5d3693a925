#include "samples/cli/cache_choice.h"

#include <algorithm>

namespace cli
{
namespace
{

constexpr const char *intermittent = "keypose-intermittent", *interpolated = "keypose-interpolated";
constexpr size_t most_digits = 6;

std::string digits_of(const std::string &cache)
{
    const size_t colon = cache.find(':');
    return colon == std::string::npos ? "" : cache.substr(colon + 1);
}

bool is_size(const std::string &digits)
{
    return !digits.empty() && digits.size() <= most_digits &&
           digits.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

const CLI::Validator cache_choice(
    [](const std::string &cache) -> std::string {
        const std::vector<std::string> &plain = cache_names();
        if (std::find(plain.begin(), plain.end(), cache) != plain.end()) return {};
        const std::string name = cache.substr(0, cache.find(':'));
        if ((name == intermittent || name == interpolated) && (name == cache || is_size(digits_of(cache)))) return {};
        return "'" + cache + "' is not one of none, animation, full, " + intermittent + ", " + interpolated +
               "; the last two may name a number of key-poses, as in " + intermittent + ":100";
    },
    "none|animation|full|keypose-intermittent[:N]|keypose-interpolated[:N]");

const std::vector<std::string> &cache_names()
{
    static const std::vector<std::string> names = {"none", "animation", "full"};
    return names;
}

bool shares_key_poses(const std::string &cache) { return cache.rfind("keypose", 0) == 0; }

std::string picture_of(const std::string &cache)
{
    return shares_key_poses(cache) ? cache.substr(0, cache.find(':')) : "";
}

clq_cache_mode cache_named(const std::string &cache)
{
    return cache == "none" ? CLQ_CACHE_NONE : cache == "animation" ? CLQ_CACHE_ANIMATION : CLQ_CACHE_FULL;
}

void take_key_poses(const std::string &cache, clq_key_poses &key_poses)
{
    if (!shares_key_poses(cache)) return;
    key_poses.bands[0].mode = picture_of(cache) == intermittent ? CLQ_KEY_POSE_INTERMITTENT : CLQ_KEY_POSE_INTERPOLATED;
    key_poses.band_count = 1;
    if (const std::string digits = digits_of(cache); !digits.empty())
        key_poses.max_kept = static_cast<uint32_t>(std::stoul(digits));
}

}  // namespace cli
