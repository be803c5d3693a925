#include "samples/labels/variation/choice.h"

#include <cmath>

#include "samples/labels/variation/chance.h"

namespace labels
{
Choice choose(const Rules &rules, uint64_t seed, uint32_t sample, double time_s)
{
    Choice out;
    out.seed = seed, out.sample = sample;
    out.scene_seed = static_cast<uint32_t>(chance_bits(seed, sample, "scene") >> 32);
    const auto number = [&](const Span &span, std::string_view purpose) {
        return span.first + (span.last - span.first) * chance(seed, sample, purpose);
    };
    const auto whole = [&](const Span &span, std::string_view purpose) {
        return span.first + std::floor((span.last - span.first + 1) * chance(seed, sample, purpose));
    };
    const auto take = [&](const std::optional<Span> &span, std::string_view purpose, std::optional<double> &to) {
        if (span) to = number(*span, purpose);
    };
    out.time_s = rules.time_s ? number(*rules.time_s, "time_s") : time_s;
    if (rules.count) out.count = static_cast<uint32_t>(whole(*rules.count, "people.count"));
    for (const auto &[name, share] : rules.classes)
        out.classes.emplace_back(name, number(share, "people.classes." + name));
    if (!rules.colours.empty())
        out.colours = rules.colours[static_cast<size_t>(static_cast<double>(rules.colours.size()) *
                                                        chance(seed, sample, "people.colours"))];
    take(rules.hour, "light.hour", out.hour);
    take(rules.sun, "light.sun", out.sun);
    take(rules.sky, "light.sky", out.sky);
    take(rules.visibility_m, "haze.visibility_m", out.visibility_m);
    take(rules.read_noise, "sensor.read_noise", out.read_noise);
    take(rules.shot_noise, "sensor.shot_noise", out.shot_noise);
    if (rules.jpeg_quality) out.jpeg_quality = static_cast<int>(whole(*rules.jpeg_quality, "sensor.jpeg_quality"));
    return out;
}

Json choice_json(const Choice &choice)
{
    Json out = {
        {"seed", choice.seed}, {"sample", choice.sample}, {"scene_seed", choice.scene_seed}, {"time_s", choice.time_s}};
    const auto add = [&](const char *section, const char *key, const auto &value) {
        if (value) out[section][key] = *value;
    };
    add("people", "count", choice.count);
    for (const auto &[name, share] : choice.classes) out["people"]["classes"][name] = share;
    if (!choice.colours.empty()) {
        const size_t slash = choice.colours.rfind('/');
        out["people"]["colours"] = slash == std::string::npos ? choice.colours : choice.colours.substr(slash + 1);
    }
    add("light", "hour", choice.hour), add("light", "sun", choice.sun), add("light", "sky", choice.sky);
    add("haze", "visibility_m", choice.visibility_m);
    add("sensor", "read_noise", choice.read_noise), add("sensor", "shot_noise", choice.shot_noise);
    add("sensor", "jpeg_quality", choice.jpeg_quality);
    return out;
}

}  // namespace labels
