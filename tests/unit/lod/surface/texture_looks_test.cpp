// How differently textures look that lie beside their place: against the widths of bands that are known.
#include "lib/lod/surface/texture_looks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/lod/chain.h"

using namespace claque;

namespace
{

constexpr uint32_t side = 256;

// A square metre of 2 * cells * cells triangles, whose texture coordinates are its places.
model::Model sheet(uint32_t cells)
{
    model::Model model;
    model.name = "sheet";
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    model.materials.emplace_back();
    model.materials[0].image = 0;
    model.materials[0].wrap_s = model.materials[0].wrap_t = model::Wrap::clamp;
    model.images.emplace_back();
    model.images[0].width = model.images[0].height = side;
    model.images[0].rgba.assign(4 * size_t(side) * side, 255);
    model::Part part;
    part.name = "sheet", part.node = 0, part.material = 0;
    for (uint32_t i = 0; i < (cells + 1) * (cells + 1); ++i) {
        const uint32_t x = i % (cells + 1), z = i / (cells + 1);
        part.positions.emplace_back(float(x) / float(cells), 0, float(z) / float(cells));
        part.uvs.emplace_back(float(x) / float(cells), float(z) / float(cells));
        if (x < cells && z < cells)
            for (const uint32_t v : {i, i + cells + 1, i + 1, i + 1, i + cells + 1, i + cells + 2})
                part.indices.push_back(v);
    }
    part.joints.assign(part.positions.size(), 0), part.weights.assign(part.positions.size(), 1);
    model.parts.push_back(part);
    return model;
}

// colour(u, v) of each texel: red, green, blue, alpha.
template <class Colour>
void paint(model::Model &model, const Colour &colour)
{
    for (uint32_t i = 0; i < side * side; ++i) {
        const std::array<uint8_t, 4> c = colour((i % side + 0.5) / side, (i / side + 0.5) / side);
        std::copy(c.begin(), c.end(), model.images[0].rgba.begin() + 4 * std::ptrdiff_t(i));
    }
}

// `material`: of the level.
template <class Change>
lod::LookDifference difference(const model::Model &model, const Change &change, uint32_t material = 0)
{
    lod::TextureLooks looks;
    looks.add(model);
    model::Part level = model.parts[0];
    level.material = material;
    for (glm::vec2 &uv : level.uvs) change(uv);
    const lod::PosedParts fine = lod::posed_at_rest(model.rig, {&model.parts[0]}),
                          coarse = lod::posed_at_rest(model.rig, {&level});
    std::vector<double> areas;
    for (uint32_t t = 0; t < fine.triangles().size(); ++t) areas.push_back(lod::area_of(fine, t));
    return looks.difference(fine, coarse, lod::nearest_pairs(fine, coarse), areas, 1);
}

// In the finest pixels.
double after_shift(const model::Model &model, float by)
{
    return difference(model, [by](glm::vec2 &uv) { uv.x += by; }).colours[0];
}

std::array<uint8_t, 4> grey(double value)
{
    const uint8_t g = static_cast<uint8_t>(value);
    return {g, g, g, 255};
}

}  // namespace

TEST(TextureLooks, OfPlainTexturesAreAlikeWhereverTheyLie)
{
    model::Model model = sheet(30);
    paint(model, [](double, double) { return grey(140); });
    const lod::LookDifference found = difference(model, [](glm::vec2 &uv) { uv = glm::vec2(uv.y, 0.3f * uv.x); });
    EXPECT_EQ(found.colours[0], 0);
    for (const double shape_m : {0.0, 0.003, 0.5}) EXPECT_EQ(found.hidden_by(shape_m), shape_m);
}

TEST(TextureLooks, AreAlikeWhereNothingMoves)
{
    model::Model model = sheet(30);
    paint(model, [](double u, double v) { return grey(int(u * 16) % 2 == int(v * 16) % 2 ? 30 : 220); });
    EXPECT_LT(after_shift(model, 0), 1e-6);
}

// The line lies in the middle of a region of fourteen, a band beside it has the other grey.
TEST(TextureLooks, OfALineThatMovesDifferByItsShareOfTheRegion)
{
    model::Model model = sheet(40);
    for (const double apart : {60.0, 120.0, 220.0}) {
        paint(model, [apart](double u, double) { return grey(u < 7.5 / 14 ? 20 : 20 + apart); });
        for (const float by : {0.0125f, 0.025f}) {
            const lod::LookDifference found = difference(model, [by](glm::vec2 &uv) { uv.x += by; });
            const double expected = 14 * double(by) * std::pow(apart / 255, 0.75);
            EXPECT_NEAR(found.colours[0], expected, 0.15 * expected) << apart << ' ' << by;
        }
    }
}

TEST(TextureLooks, OfFineGrainAreAlikeInPixelsThatAreLargerThanTheGrain)
{
    model::Model model = sheet(40);
    paint(model, [](double u, double v) { return grey(int(u * side / 2) % 2 == int(v * side / 2) % 2 ? 60 : 190); });
    const lod::LookDifference found = difference(model, [](glm::vec2 &uv) { uv.x += 0.1f; });
    EXPECT_GT(found.colours[0], 0.1);
    EXPECT_LT(found.colours[8], 0.02) << "sixteen texels";
}

TEST(TextureLooks, OfEqualColoursInAnotherChartAreAlike)
{
    model::Model model = sheet(40);
    for (glm::vec2 &uv : model.parts[0].uvs) uv.x *= 0.5f;
    paint(model, [](double u, double) { return grey(int(u * 16) % 2 ? 30 : 220); });
    EXPECT_LT(after_shift(model, 0.5f), 1e-3);
    EXPECT_GT(after_shift(model, 0.0625f), 0.3);
}

TEST(TextureLooks, CountTheColoursOfZonesAndHoles)
{
    model::Model model = sheet(40);
    model.images[0].alpha = model::AlphaMeaning::zone_keys;
    model.zones.resize(2);
    model.zones[0].key = 10, model.zones[0].colour = {0.9f, 0.8f, 0.7f};
    model.zones[1].key = 20, model.zones[1].colour = {0.9f, 0.2f, 0.1f};
    paint(model, [](double u, double) { return std::array<uint8_t, 4>{200, 200, 200, uint8_t(u < 0.5 ? 10 : 20)}; });
    EXPECT_GT(after_shift(model, 0.05f), 0.05);
    model.zones[1].colour = model.zones[0].colour;
    EXPECT_EQ(after_shift(model, 0.05f), 0);
    model.images[0].alpha = model::AlphaMeaning::opacity;
    EXPECT_EQ(after_shift(model, 0.05f), 0);
    model.materials[0].alpha_mode = model::AlphaMode::mask, model.materials[0].alpha_cutoff = 0.06f;
    EXPECT_GT(after_shift(model, 0.05f), 0.05);
}

TEST(TextureLooks, LeaveOutHolesThroughWhichALevelShowsOtherSurface)
{
    model::Model model = sheet(40);
    paint(model, [](double u, double) { return std::array<uint8_t, 4>{90, 90, 90, uint8_t(u < 0.5 ? 0 : 255)}; });
    model.materials.push_back(model.materials[0]);
    model.materials[0].alpha_mode = model::AlphaMode::mask, model.materials[1].image = 1;
    model.images.push_back(model.images[0]);
    paint(model, [](double u, double) { return grey(u < 0.5 ? 230 : 90); });
    std::swap(model.images[0], model.images[1]);
    EXPECT_LT(difference(
                  model, [](glm::vec2 &) {}, 1)
                  .colours[0],
              0.02)
        << "beside the edge of the hole alone";
    model.materials[0].alpha_mode = model::AlphaMode::opaque;
    EXPECT_GT(difference(
                  model, [](glm::vec2 &) {}, 1)
                  .colours[0],
              0.2);
}

TEST(TextureLooks, MakeAnErrorOfTheShapeMoreVisibleUntilTheCharacterIsSmall)
{
    lod::LookDifference found;
    found.longest_m = 1.6;
    found.colours.fill(0.05), found.factors.fill(2);
    EXPECT_DOUBLE_EQ(found.hidden_by(0.002), 0.004);
    EXPECT_DOUBLE_EQ(found.hidden_by(0.015), 0.0195) << "nearly 0.02 m, of which 1.6 m are 80";
    double before = 0;
    for (double shape_m = 1e-4; shape_m < 0.05; shape_m *= 1.1) {
        EXPECT_GT(found.hidden_by(shape_m), before);
        before = found.hidden_by(shape_m);
        if (shape_m > 0.02) EXPECT_DOUBLE_EQ(before, shape_m);
        else EXPECT_LE(before, 0.02);
    }
    // Of other colours than the source's up to pixels of 1.6 m / 512.
    found.factors.fill(1);
    for (size_t k = 0; k < 3; ++k) found.colours[k] = 0.5;
    EXPECT_DOUBLE_EQ(found.hidden_by(0), 1.6 / 512);
    EXPECT_DOUBLE_EQ(found.hidden_by(0.004), 0.004);
    found.colours.fill(0.9), found.factors.fill(9);
    for (const double shape_m : {0.021, 0.03, 0.2}) EXPECT_DOUBLE_EQ(found.hidden_by(shape_m), shape_m);
}

// A flat sheet loses nothing of its shape, and its texture all the more.
TEST(TextureLooks, DecideWhereALevelBeginsThatKeepsItsShapeAlone)
{
    lod::ChainOptions options;
    options.targets = {300, 80, 8}, options.proxy_max_triangles = 0, options.decimation.texture = 0;
    std::vector<lod::LevelReport> of[2];
    for (const bool striped : {false, true}) {
        model::Model model = sheet(24);
        for (glm::vec2 &uv : model.parts[0].uvs) uv.x = 0.5f * (uv.x + uv.x * uv.x);
        paint(model, [striped](double u, double) { return grey(!striped ? 128 : int(u * 20) % 2 ? 40 : 210); });
        of[striped] = lod::make_chain(model, options);
    }
    const std::vector<lod::LevelReport> &without = of[0], &with_stripes = of[1];
    ASSERT_GE(with_stripes.size(), 2u);
    EXPECT_LT(with_stripes.back().deviation.posed_rms_m, 1e-6);
    EXPECT_LT(without.back().error_m, 1e-6);
    EXPECT_GT(with_stripes.back().error_m, 0.003) << "stripes of 50 mm are off by up to an eighth of a metre";
    EXPECT_EQ(with_stripes.back().distance_m, lod::switch_distance(with_stripes.back().error_m, 1));
}
