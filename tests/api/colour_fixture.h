// A template of four zones, and colour maps of one class for it.
#pragma once

#include <claque/claque.h>
#include <claque/colour_files.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace colours
{

constexpr uint32_t zone_count = 4;

struct Rgb {
    double r, g, b;
};

// Written independently of the library, by the textbook's case distinction; hue 0 for greys.
struct Hsb {
    double hue, saturation, brightness;
};
inline Hsb hsb_of(const Rgb &c)
{
    const double high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b}), span = high - low;
    Hsb out = {0, high > 0 ? span / high : 0, high};
    if (span <= 0) return out;
    if (high == c.r) out.hue = 60 * (c.g - c.b) / span;
    else if (high == c.g) out.hue = 60 * (c.b - c.r) / span + 120;
    else out.hue = 60 * (c.r - c.g) / span + 240;
    if (out.hue < 0) out.hue += 360;
    return out;
}

class Colours : public testing::Test
{
protected:
    void SetUp() override
    {
        const char *names[zone_count] = {"zero", "one", "two", "three"};
        for (uint32_t i = 0; i < zone_count; ++i) {
            zones_[i] = small_.zones[i % 2];
            zones_[i].name = names[i];
            zones_[i].range = {20, 40, 0.5f, 0.6f, 0.7f, 0.8f};
            if (i > 1) zones_[i].key = 100 + i;
        }
        small_.def.zones = zones_;
        small_.def.zone_count = zone_count;
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
    }
    void TearDown() override
    {
        clq_colour_map_destroy(map_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }

    clq_status try_map(const std::vector<clq_zone_colours> &zones, const char *name = "people")
    {
        clq_colour_class one = {name, "", uint32_t(zones.size()), zones.data()};
        clq_colour_map_def def = clq_colour_map_def_init();
        def.class_count = 1;
        def.classes = &one;
        clq_colour_map_destroy(map_);
        map_ = nullptr;
        return clq_colour_map_create(context_, &def, &map_);
    }
    void make(const std::vector<clq_zone_colours> &zones) { ASSERT_EQ(try_map(zones), CLQ_OK) << clq_last_error(); }
    // The colours of all zones of one individual.
    std::vector<Rgb> draw(uint64_t seed, uint64_t crowd_seed = 7) const
    {
        float rgb[3 * zone_count];
        EXPECT_EQ(api_test::sample_colours(map_, 0, tmpl_, crowd_seed, seed, rgb, zone_count), CLQ_OK)
            << clq_last_error();
        std::vector<Rgb> out;
        for (uint32_t i = 0; i < zone_count; ++i)
            out.push_back({double(rgb[3 * i]), double(rgb[3 * i + 1]), double(rgb[3 * i + 2])});
        return out;
    }
    bool mentions(const char *word) const { return std::string(clq_last_error()).find(word) != std::string::npos; }

    SmallTemplate small_;
    clq_zone_def zones_[zone_count];
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_colour_map *map_ = nullptr;
};

inline clq_zone_colours zone(const char *name, const std::vector<clq_palette_entry> &palette,
                             clq_colour_space uniform = CLQ_COLOUR_SPACE_HSB)
{
    return {name, uint32_t(palette.size()), palette.data(), uniform, nullptr, 0};
}

inline clq_zone_colours linked_to(const char *name, const char *leader, float variation = 0)
{
    return {name, 0, nullptr, CLQ_COLOUR_SPACE_HSB, leader, variation};
}

}  // namespace colours
