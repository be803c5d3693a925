#include "lib/asset/colour_file.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "lib/asset/toml.h"
#include "lib/asset/toml_keys.h"
#include "lib/asset/toml_number.h"
#include "lib/base/error.h"
#include "lib/base/near_names.h"
#include "lib/math/hsb.h"
#include "lib/model/colour_rules.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr size_t max_file_bytes = size_t(4) << 20;

// Reads "#3a5fcd" as a range that holds one colour.
bool read_hex(const std::string &text, clq_hsb_range &out)
{
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return false;
    double rgb[3], hsb[3];
    for (size_t k = 0; k < 3; ++k) rgb[k] = double(std::stoi(text.substr(1 + 2 * k, 2), nullptr, 16)) / 255;
    math::rgb_to_hsb(rgb, hsb);
    const float hue = float(hsb[0]), saturation = float(hsb[1]), brightness = float(hsb[2]);
    out = {hue, hue, saturation, saturation, brightness, brightness};
    return true;
}

class Reader
{
public:
    Reader(const std::string &name, ColourFile &out) : name_(name), out_(out) {}

    void read(const toml::table &all)
    {
        known(all, {"classes"});
        const toml::node *classes = all.get("classes");
        if (!classes) refuse(all, "it has no [[classes]]");
        for (const toml::node &one : list(*classes, "classes")) read_class(table(one, "a class"));
        out_.def.class_count = uint32_t(out_.classes.size());
        out_.def.classes = out_.classes.data();
        const model::BrokenColourRule rule = model::first_broken_rule(out_.def);
        if (rule.broken) refuse(source_of(rule, all), rule.text);
    }

    [[noreturn]] void refuse(const toml::source_region &at, const std::string &sentence) const
    {
        fail(CLQ_FORMAT, "%s, line %u, column %u: %s", name_.c_str(), unsigned(at.begin.line),
             unsigned(at.begin.column), sentence.c_str());
    }
    [[noreturn]] void refuse(const toml::node &at, const std::string &sentence) const { refuse(at.source(), sentence); }

private:
    const toml::table &table(const toml::node &node, const std::string &what) const
    {
        if (!node.is_table()) refuse(node, what + " is not a table");
        return *node.as_table();
    }

    const toml::array &list(const toml::node &node, const std::string &what) const
    {
        if (!node.is_array()) refuse(node, "'" + what + "' is not a list");
        return *node.as_array();
    }

    const char *text(const toml::node &node, const std::string &what)
    {
        if (!node.is_string()) refuse(node, "'" + what + "' is not a string");
        return keep(node.as_string()->get(), node);
    }

    const char *keep(std::string value, const toml::node &at)
    {
        if (value.find('\0') != std::string::npos) refuse(at, "a name holds a zero byte");
        out_.texts.push_back(std::move(value));
        return out_.texts.back().c_str();
    }

    float number(const toml::node &node, const std::string &what) const
    {
        std::string wrong;
        const double found = number_in(node, wrong);
        if (wrong.empty() && std::fabs(found) > double(FLT_MAX)) wrong = "is too large";
        if (!wrong.empty()) refuse(node, "'" + what + "' " + wrong);
        return float(found);
    }

    void known(const toml::table &in, std::initializer_list<std::string_view> keys) const
    {
        for (const auto &[key, node] : in)
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
                refuse(key.source(),
                       "'" + std::string(key.str()) + "' is not known here" + base::names_near(key.str(), keys));
    }

    void read_class(const toml::table &from)
    {
        known(from, {"name", "template", "zones"});
        clq_colour_class made = {};
        if (const toml::node *name = from.get("name")) made.name = text(*name, "name");
        if (const toml::node *tmpl = from.get("template")) made.tmpl = text(*tmpl, "template");
        std::vector<clq_zone_colours> &zones = out_.zones.emplace_back();
        sources_.push_back({&from, {}});
        if (const toml::node *all = from.get("zones"))
            for (const auto &[key, node] : in_order(table(*all, "'zones'"))) read_zone(*key, *node, zones);
        made.zone_count = uint32_t(zones.size());
        made.zones = zones.data();
        out_.classes.push_back(made);
    }

    // Members in file order, which a parsed table does not keep.
    std::vector<std::pair<const toml::key *, const toml::node *>> in_order(const toml::table &from) const
    {
        std::vector<std::pair<const toml::key *, const toml::node *>> all;
        for (const auto &[key, node] : from) all.emplace_back(&key, &node);
        std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
            const toml::source_position &x = a.first->source().begin, &y = b.first->source().begin;
            return x.line != y.line ? x.line < y.line : x.column < y.column;
        });
        return all;
    }

    void read_zone(const toml::key &key, const toml::node &node, std::vector<clq_zone_colours> &zones)
    {
        const toml::table &from = table(node, "zone '" + std::string(key.str()) + "'");
        known(from, {"hue", "saturation", "brightness", "colour", "palette", "colour_space", "linked_to", "variation"});
        clq_zone_colours made = {};
        made.zone = keep(std::string(key.str()), node);
        if (const toml::node *colour_space = from.get("colour_space")) {
            const std::string word = text(*colour_space, "colour_space");
            if (word != "hsb" && word != "oklab")
                refuse(*colour_space, "colour_space is '" + word + "'; there are: hsb, oklab");
            made.colour_space = word == "oklab" ? CLQ_COLOUR_SPACE_OKLAB : CLQ_COLOUR_SPACE_HSB;
        }
        if (const toml::node *linked_to = from.get("linked_to")) made.linked_to = text(*linked_to, "linked_to");
        if (const toml::node *variation = from.get("variation")) made.variation = number(*variation, "variation");
        std::vector<clq_palette_entry> &entries = out_.palettes.emplace_back();
        std::vector<const toml::table *> &sources = sources_.back().zones.emplace_back(&from, key.source()).tables;
        if (const toml::node *palette = from.get("palette")) {
            for (const char *own : {"hue", "saturation", "brightness", "colour"})
                if (const toml::node *other = from.get(own))
                    refuse(*other, "it has a palette and '" + std::string(own) + "' beside it");
            for (const toml::node &one : list(*palette, "palette")) {
                const toml::table &palette_entry = table(one, "an entry of the palette");
                known(palette_entry, {"hue", "saturation", "brightness", "colour", "weight"});
                const toml::node *weight = palette_entry.get("weight");
                entries.push_back({read_range(palette_entry), weight ? number(*weight, "weight") : 1});
                sources.push_back(&palette_entry);
            }
        } else if (from.get("hue") || from.get("saturation") || from.get("brightness") || from.get("colour")) {
            entries.push_back({read_range(from), 1});
            sources.push_back(&from);
        }
        made.palette_count = uint32_t(entries.size());
        made.palette = entries.data();
        zones.push_back(made);
    }

    clq_hsb_range read_range(const toml::table &from) const
    {
        clq_hsb_range range = {};
        if (const toml::node *colour = from.get("colour")) {
            for (const char *key : {"hue", "saturation", "brightness"})
                if (const toml::node *other = from.get(key))
                    refuse(*other, "it has a colour and '" + std::string(key) + "' beside it");
            if (!colour->is_string() || !read_hex(colour->as_string()->get(), range))
                refuse(*colour, "'colour' is not a string like \"#8a3b12\"");
            return range;
        }
        read_pair(from, "hue", range.hue_min_deg, range.hue_max_deg);
        read_pair(from, "saturation", range.saturation_min, range.saturation_max);
        read_pair(from, "brightness", range.brightness_min, range.brightness_max);
        return range;
    }

    void read_pair(const toml::table &from, const char *key, float &first, float &last) const
    {
        const toml::node *node = from.get(key);
        if (!node) refuse(from, "it lacks '" + std::string(key) + "'");
        const toml::array *pair = node->as_array();
        if (!pair || pair->size() != 2) refuse(*node, "'" + std::string(key) + "' is not a list [min, max]");
        first = number((*pair)[0], key);
        last = number((*pair)[1], key);
    }

    // The source region of the value that breaks a rule.
    toml::source_region source_of(const model::BrokenColourRule &rule, const toml::table &all) const
    {
        if (rule.colour_class == CLQ_NONE) return all.source();
        const ClassSource &of_class = sources_[rule.colour_class];
        const auto in = [](const toml::table &where, std::initializer_list<const char *> keys) {
            for (const char *key : keys)
                if (const toml::node *node = where.get(key)) return node->source();
            return where.source();
        };
        if (rule.zone == CLQ_NONE)
            return in(*of_class.whole, {rule.field == model::ColourField::name ? "name" : "zones"});
        const ZoneSource &zone = of_class.zones[rule.zone];
        switch (rule.field) {
            case model::ColourField::linked_to:
                return in(*zone.whole, {"linked_to"});
            case model::ColourField::variation:
                return in(*zone.whole, {"variation"});
            case model::ColourField::hue:
                return in(*zone.tables[rule.palette_entry], {"hue", "colour"});
            case model::ColourField::saturation:
                return in(*zone.tables[rule.palette_entry], {"saturation", "colour"});
            case model::ColourField::brightness:
                return in(*zone.tables[rule.palette_entry], {"brightness", "colour"});
            case model::ColourField::weight:
                return in(*zone.tables[rule.palette_entry], {"weight"});
            default:
                return zone.key;
        }
    }

    struct ZoneSource {
        ZoneSource(const toml::table *where, const toml::source_region &name) : whole(where), key(name) {}
        const toml::table *whole;
        toml::source_region key;
        std::vector<const toml::table *> tables;
    };
    struct ClassSource {
        const toml::table *whole;
        std::deque<ZoneSource> zones;
    };
    const std::string &name_;
    ColourFile &out_;
    std::vector<ClassSource> sources_;
};

}  // namespace

void read_colours(std::string_view text, const std::string &name, ColourFile &out)
{
    if (text.size() > max_file_bytes)
        fail(CLQ_LIMIT, "%s has %zu bytes: a colour map has %zu at most", name.c_str(), text.size(), max_file_bytes);
    if (const uint32_t line = line_of_deep_key(text))
        fail(CLQ_LIMIT, "%s, line %u: a key has more than %u parts", name.c_str(), line, max_key_parts);
    if (const uint32_t line = line_of_stray_letter(text))
        fail(CLQ_FORMAT, "%s, line %u: not TOML: a letter outside of strings and comments is not ASCII", name.c_str(),
             line);
    const toml::parse_result parsed = toml::parse(text);
    Reader reader(name, out);
    if (!parsed) reader.refuse(parsed.error().source(), "not TOML: " + std::string(parsed.error().description()));
    reader.read(parsed.table());
}

}  // namespace claque::asset
