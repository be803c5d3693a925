// The tolerances must tell errors of shading from a coarse rasteriser. The GPU peer draws the odeon with vertices
// rounded to a 16th of a pixel, as SwiftShader does: right, and with one error of those that renderers make. The same
// errors of a fine rasteriser must fail `gpu`.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/parity/peer_trial.h"

namespace parity_test
{
namespace
{

constexpr PeerOptions coarse = {Limiting::knots, 4}, fine;

class Coarse : public PeerTrial
{
protected:
    void SetUp() override { begin("odeon", 0); }

    // Both must tell the colours from those of the reference: other measures cannot.
    void expect_caught(const std::function<void(SceneIn &)> &mistake)
    {
        SceneIn changed = scene();
        mistake(changed);
        const std::string said = broken(draw(changed, coarse), "coarse");
        EXPECT_EQ(said.find("colour."), 0u) << "said: " << said;
        const std::string said_of_fine = broken(draw(changed, fine), "gpu");
        EXPECT_EQ(said_of_fine.find("colour."), 0u) << "said: " << said_of_fine;
    }
    void expect_textures_caught(const std::function<double(double lightness, double alpha)> &mistake)
    {
        expect_caught([&](SceneIn &changed) {
            for (Texture &texture : changed.textures)
                for (size_t i = 0; i < texture.rgba.size(); ++i)
                    if (i % 4 < 3)
                        texture.rgba[i] = static_cast<uint8_t>(
                            std::lround(255 * mistake(texture.rgba[i] / 255.0, texture.rgba[i / 4 * 4 + 3] / 255.0)));
        });
    }
};

TEST_F(Coarse, RasterisersPassCoarseAndNotGpu)
{
    const parity::Capture result = draw(scene(), coarse);
    EXPECT_EQ(broken(result, "coarse"), "");
    EXPECT_NE(broken(result, "gpu").find("colour.over_2"), std::string::npos) << broken(result, "gpu");
    EXPECT_EQ(broken(draw(scene(), fine), "gpu"), "");
}

TEST_F(Coarse, AMissingLightIsCaught)
{
    ASSERT_EQ(scene().lighting.lights.size(), 2u);
    for (std::ptrdiff_t light : {0, 1})  // the sun, and the weak light from the other side
        expect_caught(
            [&](SceneIn &changed) { changed.lighting.lights.erase(changed.lighting.lights.begin() + light); });
    expect_caught([&](SceneIn &changed) { changed.lighting.ambient = {}; });
    expect_caught([&](SceneIn &changed) {
        for (float &channel : changed.lighting.lights[1].diffuse) channel /= 2;
    });
}

TEST_F(Coarse, TexturesDecodedFromSrgbAreCaught)
{
    expect_textures_caught(
        [](double c, double) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
}

TEST_F(Coarse, PremultipliedAlphaIsCaught)
{
    expect_textures_caught([](double c, double alpha) { return c * alpha; });
}

TEST_F(Coarse, AlphaThatWasPremultipliedAndDividedOutIsCaught)
{
    expect_textures_caught([](double c, double alpha) {
        return alpha > 0 ? std::min(1.0, std::round(255 * c * alpha) / 255 / alpha) : c;
    });
}

TEST_F(Coarse, AWrongRowOfTheAtlasIsCaught)
{
    constexpr std::ptrdiff_t row = 3 * 256;
    expect_caught(
        [&](SceneIn &changed) { std::copy(scene().atlas.begin() + row, scene().atlas.end(), changed.atlas.begin()); });
    // Of one individual, the one that fills most of the picture.
    std::vector<size_t> pixels(scene().individuals.back().actor + 1);
    for (const uint32_t id : reference().actor->values)
        if (id != 0) ++pixels[id];
    const size_t nearest = static_cast<size_t>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
    expect_caught([&](SceneIn &changed) {
        for (size_t i = 0; i < changed.individuals.size(); ++i) {
            if (changed.individuals[i].actor != nearest) continue;
            const std::ptrdiff_t own = static_cast<std::ptrdiff_t>(i) * row, other = i == 0 ? row : 0;
            std::copy_n(scene().atlas.begin() + other, row, changed.atlas.begin() + own);
        }
    });
}

TEST_F(Coarse, AShiftByOnePixelIsCaught)
{
    const parity::Capture right = draw(scene(), coarse);
    parity::Capture shifted = right;
    const size_t row = 3 * static_cast<size_t>(right.width);
    for (size_t i = 0; i < right.colour->rgb.size(); ++i)
        shifted.colour->rgb[i] = right.colour->rgb[i % row < 3 ? i : i - 3];
    EXPECT_NE(broken(shifted, "coarse"), "");
    shifted = right;
    for (size_t i = 1; i < right.actor->values.size(); ++i) {
        shifted.actor->values[i] = right.actor->values[i - 1];
        shifted.zone->values[i] = right.zone->values[i - 1];
    }
    EXPECT_NE(broken(shifted, "coarse").find("actor_ids.at_silhouettes"), std::string::npos);
}

}  // namespace
}  // namespace parity_test
