// Sampled colours fill their range evenly, in HSB or in OKLab; OKLab is computed here independently of the library.
#include "tests/api/colour_fixture.h"

namespace colours
{
namespace
{

double light(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

struct Lab {
    double l, a, b;
};
Lab lab_of(const Rgb &c)
{
    const double r = light(c.r), g = light(c.g), b = light(c.b);
    const double x = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b),
                 y = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b),
                 z = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * x + 0.7936177850 * y - 0.0040720468 * z,
            1.9779984951 * x - 2.4285922050 * y + 0.4505937099 * z,
            0.0259040371 * x + 0.7827717662 * y - 0.8086757660 * z};
}

double encoded(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

Rgb rgb_of(const Lab &c)
{
    const auto cube = [](double x) { return x * x * x; };
    const double x = cube(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b),
                 y = cube(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b),
                 z = cube(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b);
    return {encoded(4.0767416621 * x - 3.3077115913 * y + 0.2309699292 * z),
            encoded(-1.2684380046 * x + 2.6097574011 * y - 0.3413193965 * z),
            encoded(-0.0041960863 * x - 0.7034186147 * y + 1.7076147010 * z)};
}

constexpr int across = 4, boxes = across * across * across;
int box_of(const Lab &c, const Lab &first, const Lab &last)
{
    const auto place = [](double x, double from, double to) {
        return std::clamp(int(across * (x - from) / (to - from)), 0, across - 1);
    };
    return (place(c.l, first.l, last.l) * across + place(c.a, first.a, last.a)) * across + place(c.b, first.b, last.b);
}

// Chi-square of the samples in boxes of OKLab against the part of each box that the range fills: the fraction of evenly
// spread points of the box that lie in the range. Boxes of fewer than 8 expected samples are merged. The result is
// divided by the degrees of freedom.
double unevenness(const std::vector<Lab> &drawn, const clq_hsb_range &r)
{
    Lab first = drawn[0], last = drawn[0];
    for (const Lab &c : drawn) {
        first = {std::min(first.l, c.l), std::min(first.a, c.a), std::min(first.b, c.b)};
        last = {std::max(last.l, c.l), std::max(last.a, c.a), std::max(last.b, c.b)};
    }
    double filled[boxes] = {}, all = 0;
    constexpr int fine = 64;
    for (int i = 0; i < fine * fine * fine; ++i) {
        const Lab at = {first.l + (last.l - first.l) * (i % fine + 0.5) / fine,
                        first.a + (last.a - first.a) * (i / fine % fine + 0.5) / fine,
                        first.b + (last.b - first.b) * (i / fine / fine + 0.5) / fine};
        const Rgb c = rgb_of(at);
        const auto shown = [](double x) { return x >= 0 && x <= 1; };
        if (!shown(c.r) || !shown(c.g) || !shown(c.b)) continue;
        const Hsb h = hsb_of(c);
        const double width = double(r.hue_max_deg) - double(r.hue_min_deg) + (r.hue_min_deg > r.hue_max_deg ? 360 : 0);
        double turn = h.hue - double(r.hue_min_deg);
        if (turn < 0) turn += 360;
        if (turn > width || h.saturation < double(r.saturation_min) || h.saturation > double(r.saturation_max) ||
            h.brightness < double(r.brightness_min) || h.brightness > double(r.brightness_max))
            continue;
        ++filled[box_of(at, first, last)];
        ++all;
    }
    double counts[boxes] = {};
    for (const Lab &c : drawn) ++counts[box_of(c, first, last)];
    double chi2 = 0, few = 0, few_counted = 0;
    int used = 0;
    for (int i = 0; i < boxes; ++i) {
        const double expected = filled[i] / all * double(drawn.size());
        if (expected < 8) {
            few += expected;
            few_counted += counts[i];
            continue;
        }
        chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
        ++used;
    }
    if (few >= 8) chi2 += (few_counted - few) * (few_counted - few) / few, ++used;
    return chi2 / (used - 1);
}

}  // namespace

TEST_F(Colours, SampledInHsbFillItsBoxEvenly)
{
    const clq_hsb_range range = {300, 60, 0.3f, 0.9f, 0.4f, 1};
    const std::vector<clq_palette_entry> entry = {{range, 1}};
    make({zone("one", entry)});
    constexpr int draws = 20000;
    int counts[boxes] = {};
    for (uint64_t seed = 0; seed < draws; ++seed) {
        const Hsb c = hsb_of(draw(seed)[1]);
        const double turn = (c.hue < 180 ? c.hue + 60 : c.hue - 300) / 120;
        const auto place = [](double x) { return std::clamp(int(across * x), 0, across - 1); };
        ++counts[(place(turn) * across + place((c.saturation - 0.3) / 0.6)) * across +
                 place((c.brightness - 0.4) / 0.6)];
    }
    double chi2 = 0;
    for (const int n : counts)
        chi2 += (n - draws / double(boxes)) * (n - draws / double(boxes)) / (draws / double(boxes));
    EXPECT_LT(chi2, 103.4) << "63 degrees of freedom, one in a thousand";
}

TEST_F(Colours, SampledInOklabFillItEvenlyAndOthersDoNot)
{
    const clq_hsb_range ranges[] = {
        {0, 360, 0.2f, 1, 0.2f, 1}, {190, 290, 0.4f, 0.8f, 0.3f, 0.9f}, {335, 58, 0.1f, 0.9f, 0.1f, 0.9f}};
    for (const clq_hsb_range &range : ranges) {
        const std::vector<clq_palette_entry> entry = {{range, 1}};
        double of[2];
        for (const clq_colour_space uniform : {CLQ_COLOUR_SPACE_HSB, CLQ_COLOUR_SPACE_OKLAB}) {
            make({zone("one", entry, uniform)});
            std::vector<Lab> drawn;
            for (uint64_t seed = 0; seed < 6000; ++seed) drawn.push_back(lab_of(draw(seed)[1]));
            of[uniform] = unevenness(drawn, range);
        }
        EXPECT_LT(of[CLQ_COLOUR_SPACE_OKLAB], 1.6) << range.hue_min_deg;
        EXPECT_GT(of[CLQ_COLOUR_SPACE_HSB], 5 * of[CLQ_COLOUR_SPACE_OKLAB]) << "otherwise the first test shows nothing";
    }
}

// A line of one hue and saturation: equal perceptual steps are equally frequent.
TEST_F(Colours, OfARangeThatIsALineAreEvenAlongIt)
{
    const std::vector<clq_palette_entry> entry = {{{30, 30, 0.5f, 0.5f, 0, 1}, 1}};
    make({zone("one", entry, CLQ_COLOUR_SPACE_OKLAB)});
    const double whole = lab_of({1, 0.75, 0.5}).l;
    constexpr int draws = 5000, bins = 10;
    int counts[bins] = {};
    for (uint64_t seed = 0; seed < draws; ++seed)
        ++counts[std::min(bins - 1, int(lab_of(draw(seed)[1]).l / whole * bins))];
    double chi2 = 0;
    for (int i = 0; i < bins; ++i) chi2 += (counts[i] - 500) * (counts[i] - 500) / 500.0;
    EXPECT_LT(chi2, 27.9) << "nine degrees of freedom, one in a thousand";
}

TEST_F(Colours, OfGreysAreEvenFromDarkToLightAndBlackIsBlack)
{
    const std::vector<clq_palette_entry> grey = {{{0, 360, 0, 0, 0, 1}, 1}}, black = {{{0, 360, 0, 1, 0, 0}, 1}};
    make({zone("one", grey, CLQ_COLOUR_SPACE_OKLAB), zone("two", black, CLQ_COLOUR_SPACE_OKLAB)});
    constexpr int draws = 5000, bins = 10;
    int counts[bins] = {};
    for (uint64_t seed = 0; seed < draws; ++seed) {
        const std::vector<Rgb> c = draw(seed);
        EXPECT_EQ(c[1].r, c[1].b);
        EXPECT_EQ(c[2].r + c[2].g + c[2].b, 0);
        ++counts[std::min(bins - 1, int(lab_of(c[1]).l * bins))];
    }
    double chi2 = 0;
    for (const int n : counts) chi2 += (n - 500) * (n - 500) / 500.0;
    EXPECT_LT(chi2, 27.9) << "nine degrees of freedom, one in a thousand";
}

}  // namespace colours
