// Sampling of individuals' colours: ranges hold, palettes keep their weights, linked zones stay alike.
#include "tests/api/colour_fixture.h"

namespace colours
{
namespace
{

bool in_hue(double hue, const clq_hsb_range &r, double slack)
{
    double from = hue - double(r.hue_min_deg), width = double(r.hue_max_deg) - double(r.hue_min_deg);
    if (width < 0) width += 360;
    from -= 360 * std::floor((from + slack) / 360);
    return from <= width + slack;
}

TEST_F(Colours, LieWithinTheirRangesWhateverTheSeedAndTheSpace)
{
    const clq_hsb_range ranges[] = {{190, 290, 0.4f, 0.8f, 0.5f, 0.7f},
                                    {335, 58, 0.35f, 0.9f, 0.2f, 0.9f},
                                    {0, 360, 0.2f, 1, 0.05f, 1},
                                    {359, 1, 0.5f, 0.5f, 0.6f, 0.9f},
                                    {120, 120, 0.3f, 0.31f, 0.4f, 0.4f}};
    for (const clq_colour_space uniform : {CLQ_COLOUR_SPACE_HSB, CLQ_COLOUR_SPACE_OKLAB})
        for (const clq_hsb_range &range : ranges) {
            const std::vector<clq_palette_entry> entry = {{range, 1}};
            make({zone("one", entry, uniform)});
            for (uint64_t seed = 0; seed < 4000; ++seed) {
                const Hsb c = hsb_of(draw(seed)[1]);
                ASSERT_TRUE(in_hue(c.hue, range, 0.01)) << c.hue << " of " << range.hue_min_deg << ", seed " << seed;
                ASSERT_GE(c.saturation, double(range.saturation_min) - 1e-5) << seed;
                ASSERT_LE(c.saturation, double(range.saturation_max) + 1e-5) << seed;
                ASSERT_GE(c.brightness, double(range.brightness_min) - 1e-6) << seed;
                ASSERT_LE(c.brightness, double(range.brightness_max) + 1e-6) << seed;
            }
        }
}

TEST_F(Colours, OfAWrappingHueRangeLieOnBothSidesOfRed)
{
    const std::vector<clq_palette_entry> entry = {{{330, 30, 1, 1, 1, 1}, 1}};
    make({zone("one", entry)});
    int below = 0;
    for (uint64_t seed = 0; seed < 1000; ++seed) below += hsb_of(draw(seed)[1]).hue > 180;
    EXPECT_GT(below, 430);
    EXPECT_LT(below, 570);
}

// 10 000 samples of three palette entries: chi-square with two degrees of freedom exceeds 13.8 for one seed in a
// thousand, and the seeds are fixed.
TEST_F(Colours, OfAPaletteAreAsFrequentAsTheirWeights)
{
    const std::vector<clq_palette_entry> palette = {
        {{0, 0, 1, 1, 1, 1}, 5}, {{120, 120, 1, 1, 1, 1}, 3}, {{240, 240, 1, 1, 1, 1}, 0.5f}};
    for (const clq_colour_space uniform : {CLQ_COLOUR_SPACE_HSB, CLQ_COLOUR_SPACE_OKLAB}) {
        make({zone("two", palette, uniform)});
        int counts[3] = {0, 0, 0};
        for (uint64_t seed = 0; seed < 10000; ++seed) ++counts[int(hsb_of(draw(seed)[2]).hue / 120 + 0.5)];
        const double expected[3] = {10000 * 5 / 8.5, 10000 * 3 / 8.5, 10000 * 0.5 / 8.5};
        double chi2 = 0;
        for (int i = 0; i < 3; ++i) chi2 += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        EXPECT_LT(chi2, 13.8) << counts[0] << ' ' << counts[1] << ' ' << counts[2];
        EXPECT_GT(counts[2], 0);
    }
}

TEST_F(Colours, OfLinkedZonesAreEqualAndDifferMoreWithVariation)
{
    const std::vector<clq_palette_entry> palette = {{{0, 100, 0.2f, 0.9f, 0.3f, 0.9f}, 3},
                                                    {{200, 220, 0.5f, 0.6f, 0.5f, 0.6f}, 1}};
    for (const clq_colour_space uniform : {CLQ_COLOUR_SPACE_HSB, CLQ_COLOUR_SPACE_OKLAB}) {
        double before = -1;
        for (const float variation : {0.0f, 0.1f, 0.4f, 1.0f}) {
            make({zone("three", palette, uniform), linked_to("one", "three", variation)});
            double away = 0;
            for (uint64_t seed = 0; seed < 2000; ++seed) {
                const std::vector<Rgb> c = draw(seed);
                away += std::fabs(c[1].r - c[3].r) + std::fabs(c[1].g - c[3].g) + std::fabs(c[1].b - c[3].b);
            }
            if (variation == 0) {
                EXPECT_EQ(away, 0);
            }
            EXPECT_GT(away, before * 1.3) << variation;
            before = away;
        }
    }
}

// Correlation of brightness, which is uniform by itself, with that of the linked zone.
TEST_F(Colours, OfALinkedZoneKeepTheirOwnDistribution)
{
    const std::vector<clq_palette_entry> entry = {{{10, 20, 0.5f, 0.5f, 0, 1}, 1}};
    for (const float variation : {0.0f, 0.2f, 0.7f, 1.0f}) {
        make({zone("three", entry), linked_to("one", "three", variation)});
        constexpr int draws = 8000, bins = 10;
        int counts[bins] = {};
        double both = 0;
        for (uint64_t seed = 0; seed < draws; ++seed) {
            const std::vector<Rgb> c = draw(seed);
            ++counts[std::min(bins - 1, int(c[1].r * bins))];
            both += 12 * (c[1].r - 0.5) * (c[3].r - 0.5) / draws;
        }
        double chi2 = 0;
        for (const int n : counts) chi2 += (n - draws / bins) * (n - draws / bins) / double(draws / bins);
        EXPECT_LT(chi2, 27.9) << variation;  // nine degrees of freedom, one in a thousand
        if (variation == 0) {
            EXPECT_GT(both, 0.97);
        }
        if (variation == 0.2f) {
            EXPECT_GT(both, 0.9);
        }
        if (variation == 1) {
            EXPECT_NEAR(both, 0, 0.05);
        }
    }
}

TEST_F(Colours, OfALinkedZoneWithAPaletteOfItsOwnTakeTheSamePositionInIt)
{
    const std::vector<clq_palette_entry> light = {{{40, 40, 0.2f, 0.2f, 0.8f, 1}, 1}},
                                         dark = {{{40, 40, 0.2f, 0.2f, 0, 0.4f}, 1}};
    clq_zone_colours follower = zone("zero", dark);
    follower.linked_to = "two";
    make({follower, zone("two", light)});
    for (uint64_t seed = 0; seed < 200; ++seed) {
        const std::vector<Rgb> c = draw(seed);
        EXPECT_NEAR((c[2].r - 0.8) / 0.2, c[0].r / 0.4, 1e-5) << seed;
    }
    // A zone that the class does not name has the template's own range.
    make({linked_to("zero", "three")});
    for (uint64_t seed = 0; seed < 50; ++seed) {
        const std::vector<Rgb> c = draw(seed);
        EXPECT_EQ(c[0].g, c[3].g);
        EXPECT_NE(c[1].g, c[3].g);
    }
}

TEST_F(Colours, OfAClassWithoutOptionsFollowItsRangesAlone)
{
    const clq_hsb_range range = {300, 20, 0.1f, 0.9f, 0.2f, 1};
    const std::vector<clq_palette_entry> entry = {{range, 17}};
    make({zone("zero", entry), zone("one", entry), zone("two", entry), zone("three", entry)});
    clq_crowd_def def = clq_crowd_def_init();
    def.seed = 99;
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(context_, &def, &crowd), CLQ_OK);
    const clq_hsb_range ranges[zone_count] = {range, range, range, range};
    for (uint64_t seed = 0; seed < 40; ++seed) {
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = tmpl_;
        actor_def.seed = seed;
        clq_actor actor;
        float by_ranges[3 * zone_count], by_map[3 * zone_count];
        ASSERT_EQ(clq_actor_create(crowd, &actor_def, &actor), CLQ_OK);
        ASSERT_EQ(clq_actor_randomise_colours(crowd, actor, ranges, zone_count), CLQ_OK);
        ASSERT_EQ(clq_actor_get_colours(crowd, actor, by_ranges, zone_count), CLQ_OK);
        ASSERT_EQ(clq_crowd_randomise_colours(crowd, map_, 0, &actor, 1), CLQ_OK);
        ASSERT_EQ(clq_actor_get_colours(crowd, actor, by_map, zone_count), CLQ_OK);
        const std::vector<Rgb> drawn = draw(seed, 99);
        for (uint32_t i = 0; i < 3 * zone_count; ++i) {
            EXPECT_EQ(by_ranges[i], by_map[i]);
            EXPECT_NEAR(double(by_map[i]),
                        i % 3 == 0   ? drawn[i / 3].r
                        : i % 3 == 1 ? drawn[i / 3].g
                                     : drawn[i / 3].b,
                        0.5 / 255 + 1e-6);
        }
    }
    clq_crowd_destroy(crowd);
}

TEST_F(Colours, ThatBreakARuleAreRefusedByClassAndZone)
{
    const std::vector<clq_palette_entry> good = {{{0, 90, 0.1f, 0.2f, 0.3f, 0.4f}, 1}};
    const auto with = [](clq_hsb_range range, float weight) { return std::vector<clq_palette_entry>{{range, weight}}; };
    const std::vector<clq_palette_entry> bad_hue = with({-1, 90, 0, 1, 0, 1}, 1),
                                         back = with({0, 0, 0.9f, 0.2f, 0, 1}, 1), nan = with({0, 0, 0, 1, 0, NAN}, 1),
                                         free = with({0, 0, 0, 1, 0, 1}, 0);
    clq_zone_colours strange = zone("one", good);
    const unsigned seventeen = 17;
    std::memcpy(&strange.colour_space, &seventeen, sizeof seventeen);
    clq_zone_colours lonely = zone("one", good);
    lonely.variation = 0.5f;
    const struct {
        std::vector<clq_zone_colours> zones;
        std::vector<const char *> says;
    } cases[] = {
        {{zone("one", bad_hue)}, {"class 'people', zone 'one', palette entry 1", "hue is -1 to 90", "0 to 360"}},
        {{zone("one", back)}, {"saturation is 0.9 to 0.2", "wrong way round"}},
        {{zone("one", nan)}, {"brightness"}},
        {{zone("one", free)}, {"weight is 0"}},
        {{zone("one", good), zone("one", good)}, {"zone 'one'", "twice"}},
        {{linked_to("one", "one")}, {"linked to itself"}},
        {{zone("one", good), linked_to("two", "one"), linked_to("three", "two")},
         {"zone 'three'", "'two'", "itself linked to 'one'"}},
        {{zone("one", {})}, {"neither a palette entry"}},
        {{linked_to("one", "two", 1.5f)}, {"variation is 1.5"}},
        {{lonely}, {"variation"}},
        {{strange}, {"colour_space is 17"}},
        {{zone("", good)}, {"zone 1", "no name"}},
    };
    for (const auto &c : cases) {
        EXPECT_EQ(try_map(c.zones), CLQ_ARGUMENT);
        for (const char *word : c.says) EXPECT_TRUE(mentions(word)) << word << " in " << clq_last_error();
    }
    EXPECT_EQ(try_map({zone("one", good)}, ""), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("class 1")) << clq_last_error();
}

TEST_F(Colours, MapsReturnTheirDefinition)
{
    const std::vector<clq_palette_entry> palette = {{{0, 90, 0.1f, 0.2f, 0.3f, 0.4f}, 2}, {{1, 1, 1, 1, 1, 1}, 3}};
    make({zone("one", palette, CLQ_COLOUR_SPACE_OKLAB), linked_to("two", "one", 0.25f)});
    clq_colour_map_def def = clq_colour_map_def_init();
    ASSERT_EQ(clq_colour_map_get_def(map_, &def), CLQ_OK);
    ASSERT_EQ(def.class_count, 1u);
    EXPECT_STREQ(def.classes[0].name, "people");
    ASSERT_EQ(def.classes[0].zone_count, 2u);
    EXPECT_EQ(def.classes[0].zones[0].palette[1].weight, 3.0f);
    EXPECT_EQ(def.classes[0].zones[0].colour_space, CLQ_COLOUR_SPACE_OKLAB);
    EXPECT_STREQ(def.classes[0].zones[1].linked_to, "one");
    EXPECT_EQ(def.classes[0].zones[1].variation, 0.25f);
    EXPECT_EQ(clq_colour_map_find(map_, "people"), 0u);
    EXPECT_EQ(clq_colour_map_find(map_, "nobody"), CLQ_NONE);
    EXPECT_EQ(clq_colour_map_find_template(map_, ""), CLQ_NONE);
    EXPECT_EQ(clq_colour_map_find(nullptr, "people"), CLQ_NONE);
}

}  // namespace
}  // namespace colours
