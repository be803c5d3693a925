// The policy of default colours, as far as it promises something.
#include "lib/asset/zone_ranges.h"

#include <gtest/gtest.h>

#include "lib/math/hsb.h"

namespace claque::asset
{
namespace
{

using Colour = std::array<float, 3>;

float width_of(const model::HsbRange &r)
{
    return r.hue_max_deg - r.hue_min_deg + (r.hue_min_deg > r.hue_max_deg ? 360.0f : 0.0f);
}

bool holds(const model::HsbRange &r, double hue, double saturation, double brightness)
{
    const double above = hue - static_cast<double>(r.hue_min_deg);
    const double inside = above < -1e-3 ? above + 360 : above;
    const bool in_hue = saturation == 0 || inside <= static_cast<double>(width_of(r)) + 1e-3;
    return in_hue && saturation >= static_cast<double>(r.saturation_min) - 1e-5 &&
           saturation <= static_cast<double>(r.saturation_max) + 1e-5 &&
           brightness >= static_cast<double>(r.brightness_min) - 1e-5 &&
           brightness <= static_cast<double>(r.brightness_max) + 1e-5;
}

TEST(ZoneRanges, HoldTheColourTheyAreFor)
{
    for (const char *name : {"Skin", "Hair", "Eyes", "Teeth", "Lips", "Belt", "Shirt"})
        for (const Texturing texturing : {Texturing::untextured, Texturing::textured})
            for (double hue = 0; hue < 360; hue += 30)
                for (const double saturation : {0.0, 0.05, 0.5, 1.0})
                    for (const double brightness : {0.02, 0.5, 0.95, 1.0}) {
                        double rgb[3];
                        math::hsb_to_rgb(hue, saturation, brightness, rgb);
                        const Colour colour = {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]),
                                               static_cast<float>(rgb[2])};
                        const model::HsbRange range = default_range(name, colour, texturing);
                        EXPECT_TRUE(holds(range, hue, saturation, brightness))
                            << name << " " << hue << " " << saturation << " " << brightness;
                        EXPECT_TRUE(range.hue_min_deg >= 0 && range.hue_min_deg < 360 && range.hue_max_deg >= 0 &&
                                    range.hue_max_deg < 360);
                        EXPECT_LE(range.saturation_min, range.saturation_max);
                        EXPECT_LE(range.brightness_min, range.brightness_max);
                    }
}

TEST(ZoneRanges, LetClothesVaryAndPeopleStayPeople)
{
    const Colour tan = {0.8f, 0.6f, 0.45f}, blue = {0.2f, 0.3f, 0.7f};
    EXPECT_LT(width_of(default_range("Skin", tan, Texturing::untextured)), 30);
    EXPECT_LT(width_of(default_range("Face", tan, Texturing::untextured)), 30);
    EXPECT_LT(width_of(default_range("LeftEye", blue, Texturing::untextured)), 30);
    EXPECT_GT(width_of(default_range("Shirt", blue, Texturing::untextured)), 270);
    EXPECT_LT(default_range("Atlas", {1, 1, 1}, Texturing::textured).saturation_max, 0.3f);
    EXPECT_GT(default_range("Atlas", {1, 1, 1}, Texturing::textured).brightness_min, 0.7f);
}

TEST(ZoneRanges, NamesSayWhatThingsAre)
{
    EXPECT_EQ(zone_kind_of("EyeBrows"), ZoneKind::hair);
    EXPECT_EQ(zone_kind_of("Eyes.001"), ZoneKind::eyes);
    EXPECT_EQ(zone_kind_of("HUMAN_SKIN"), ZoneKind::skin);
    EXPECT_EQ(zone_kind_of("Pants"), ZoneKind::cloth);
    EXPECT_EQ(zone_kind_of(""), ZoneKind::cloth);
}

}  // namespace
}  // namespace claque::asset
