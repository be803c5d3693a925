// Writes colour maps as TOML.
#include <charconv>

#include "lib/asset/colour_file.h"
#include "lib/base/error.h"
#include "lib/math/hsb.h"

namespace claque::asset
{

namespace
{

constexpr char preface[] =
    "# Colours of people: for each class and zone where its hue (degrees; wraps), saturation and brightness may lie.\n"
    "# palette: several such ranges, with weights. linked_to: the zone whose colour this one follows, `variation` away "
    "at most.\n"
    "# colour_space: \"hsb\", or \"oklab\" for colours that are spread evenly to the eye.\n";

// The shortest digits that read back as the same float.
std::string show(float value)
{
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string pair(const char *key, float first, float last)
{
    return std::string(key) + " = [" + show(first) + ", " + show(last) + "]";
}

// The length of the UTF-8 sequence that begins here; 0 if there is none.
size_t sequence(const unsigned char *at)
{
    const unsigned first = at[0];
    const size_t length = first < 0x80                    ? 1
                          : first >= 0xc2 && first < 0xe0 ? 2
                          : (first & 0xf0) == 0xe0        ? 3
                          : first >= 0xf0 && first < 0xf5 ? 4
                                                          : 0;
    for (size_t i = 1; i < length; ++i)
        if ((at[i] & 0xc0) != 0x80) return 0;
    const unsigned second = length > 1 ? at[1] : 0;
    const bool too_long = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool surrogate = first == 0xed && second >= 0xa0, beyond = first == 0xf4 && second >= 0x90;
    return too_long || surrogate || beyond ? 0 : length;
}

std::string quoted(const char *text)
{
    std::string out = "\"";
    for (const unsigned char *at = reinterpret_cast<const unsigned char *>(text); *at;) {
        const size_t length = sequence(at);
        if (length == 0) base::fail(CLQ_ARGUMENT, "a name of the map is not UTF-8, as TOML files must be");
        constexpr char hex[] = "0123456789abcdef";
        if (*at == '"' || *at == '\\') out += '\\';
        if (*at < 0x20 || *at == 0x7f) out += std::string("\\u00") + hex[*at >> 4] + hex[*at & 15];
        else out.append(reinterpret_cast<const char *>(at), length);
        at += length;
    }
    return out + '"';
}

std::string key(const char *name)
{
    const std::string text = name;
    const char *bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return text.find_first_not_of(bare) == std::string::npos ? text : quoted(name);
}

// True if the range is exactly what reading a hexadecimal colour gives.
bool is_hex(const clq_hsb_range &range, std::string &out)
{
    double rgb[3], hsb[3];
    math::hsb_to_rgb(double(range.hue_min_deg), double(range.saturation_min), double(range.brightness_min), rgb);
    const math::Rgb8 bytes = math::rgb8_of(rgb);
    const double back[3] = {bytes.r / 255.0, bytes.g / 255.0, bytes.b / 255.0};
    math::rgb_to_hsb(back, hsb);
    for (const float hue : {range.hue_min_deg, range.hue_max_deg})
        if (hue != float(hsb[0])) return false;
    for (const float saturation : {range.saturation_min, range.saturation_max})
        if (saturation != float(hsb[1])) return false;
    for (const float brightness : {range.brightness_min, range.brightness_max})
        if (brightness != float(hsb[2])) return false;
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", bytes.r, bytes.g, bytes.b);
    out = text;
    return true;
}

std::string range_text(const clq_hsb_range &r)
{
    std::string hex;
    if (is_hex(r, hex)) return "colour = \"" + hex + "\"";
    return pair("hue", r.hue_min_deg, r.hue_max_deg) + ", " + pair("saturation", r.saturation_min, r.saturation_max) +
           ", " + pair("brightness", r.brightness_min, r.brightness_max);
}

std::string zone_text(const clq_zone_colours &zone)
{
    std::string out;
    const auto say = [&](const std::string &what) { out += (out.empty() ? "" : ", ") + what; };
    if (zone.colour_space == CLQ_COLOUR_SPACE_OKLAB) say("colour_space = \"oklab\"");
    if (zone.linked_to) say("linked_to = " + quoted(zone.linked_to));
    if (zone.variation > 0) say("variation = " + show(zone.variation));
    if (zone.palette_count == 1 && zone.palette[0].weight == 1) say(range_text(zone.palette[0].range));
    else if (zone.palette_count > 0) {
        std::string palette = "palette = [\n";
        for (uint32_t i = 0; i < zone.palette_count; ++i)
            palette +=
                "    { " + range_text(zone.palette[i].range) + ", weight = " + show(zone.palette[i].weight) + " },\n";
        say(palette + "]");
    }
    return key(zone.zone) + " = { " + out + " }\n";
}

}  // namespace

std::string colours_text(const clq_colour_map_def &def)
{
    std::string out = preface;
    for (uint32_t c = 0; c < def.class_count; ++c) {
        const clq_colour_class &colours = def.classes[c];
        out += std::string("\n[[classes]]\nname = ") + quoted(colours.name) + "\n";
        if (colours.tmpl) out += std::string("template = ") + quoted(colours.tmpl) + "\n";
        if (colours.zone_count > 0) out += "\n[classes.zones]\n";
        for (uint32_t z = 0; z < colours.zone_count; ++z) out += zone_text(colours.zones[z]);
    }
    return out;
}

}  // namespace claque::asset
