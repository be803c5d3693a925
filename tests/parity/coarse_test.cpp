// The tolerances must tell errors of shading from a coarse rasteriser. The GPU peer draws the odeon with vertices
// rounded to a 16th of a pixel, as SwiftShader does: right, and with one error of those that renderers make. The same
// errors of a fine rasteriser must fail `gpu`.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/parity/verdict.h"
#include "samples/parity/write/write.h"
#include "tests/gl/support/absent.h"
#include "tests/parity/result_out.h"

namespace parity_test
{
namespace
{

namespace fs = std::filesystem;

constexpr int coarse_bits = 4;

class Coarse : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        if (!contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
            END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        folder_ = fs::temp_directory_path() / ("claque-coarse-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        scenes::Library library(2);
        scenes::SceneOptions options;
        options.scene = "odeon";
        options.crowd_options.count = 0;
        options.width = 320, options.height = 240;
        options.flat_triangles = 0;
        scenes::SceneRenderer scene_renderer(library, options);
        const parity::CaptureTime capture_time = {options.scene, 2, options.width, options.height};
        parity::write_scene(scene_renderer, capture_time, path("scene"));
        parity::write_result(scene_renderer, capture_time, path("reference"));
        scene_ = read_scene(path("scene"));
        reference_ = parity::read_capture(path("reference"));
    }
    void TearDown() override
    {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    std::string path(const char *name) const { return (folder_ / name).string(); }

    parity::Capture draw(const SceneIn &scene, int subpixel_bits)
    {
        std::string why_not;
        const auto context = contexts::make_offscreen(contexts::Kind::any, scene.width, scene.height,
                                                      contexts::PixelFormat::rgba8888, why_not);
        Peer peer(*context, scene, {Limiting::knots, subpixel_bits});
        write_result(*context, peer, scene, path("scene"), path("result"));
        return parity::read_capture(path("result"));
    }
    // Exceeded limits; empty: all are kept.
    std::string broken(const parity::Capture &result, const char *tolerance) const
    {
        return parity::reasons(
            parity::verdict_of(parity::compare(reference_, result, 67), parity::tolerance_of(tolerance)), 99);
    }
    // Both must tell the colours from those of the reference: other measures cannot.
    void expect_caught(const std::function<void(SceneIn &)> &mistake)
    {
        SceneIn scene = scene_;
        mistake(scene);
        const std::string coarse = broken(draw(scene, coarse_bits), "coarse");
        EXPECT_EQ(coarse.find("colour."), 0u) << "said: " << coarse;
        const std::string fine = broken(draw(scene, 0), "gpu");
        EXPECT_EQ(fine.find("colour."), 0u) << "said: " << fine;
    }
    void expect_textures_caught(const std::function<double(double lightness, double alpha)> &mistake)
    {
        expect_caught([&](SceneIn &scene) {
            for (Texture &texture : scene.textures)
                for (size_t i = 0; i < texture.rgba.size(); ++i)
                    if (i % 4 < 3)
                        texture.rgba[i] = static_cast<uint8_t>(
                            std::lround(255 * mistake(texture.rgba[i] / 255.0, texture.rgba[i / 4 * 4 + 3] / 255.0)));
        });
    }

    fs::path folder_;
    SceneIn scene_;
    parity::Capture reference_;
};

TEST_F(Coarse, RasterisersPassCoarseAndNotGpu)
{
    const parity::Capture result = draw(scene_, coarse_bits);
    EXPECT_EQ(broken(result, "coarse"), "");
    EXPECT_NE(broken(result, "gpu").find("colour.over_2"), std::string::npos) << broken(result, "gpu");
    EXPECT_EQ(broken(draw(scene_, 0), "gpu"), "");
}

TEST_F(Coarse, AMissingLightIsCaught)
{
    ASSERT_EQ(scene_.lighting.lights.size(), 2u);
    for (std::ptrdiff_t light : {0, 1})  // the sun, and the weak light from the other side
        expect_caught([&](SceneIn &scene) { scene.lighting.lights.erase(scene.lighting.lights.begin() + light); });
    expect_caught([&](SceneIn &scene) { scene.lighting.ambient = {}; });
    expect_caught([&](SceneIn &scene) {
        for (float &channel : scene.lighting.lights[1].diffuse) channel /= 2;
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
        [&](SceneIn &scene) { std::copy(scene_.atlas.begin() + row, scene_.atlas.end(), scene.atlas.begin()); });
    // Of one individual, the one that fills most of the picture.
    std::vector<size_t> pixels(scene_.individuals.back().actor + 1);
    for (const uint32_t id : reference_.actor->values)
        if (id != 0) ++pixels[id];
    const size_t nearest = static_cast<size_t>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
    expect_caught([&](SceneIn &scene) {
        for (size_t i = 0; i < scene.individuals.size(); ++i) {
            if (scene.individuals[i].actor != nearest) continue;
            const std::ptrdiff_t own = static_cast<std::ptrdiff_t>(i) * row, other = i == 0 ? row : 0;
            std::copy_n(scene_.atlas.begin() + other, row, scene.atlas.begin() + own);
        }
    });
}

TEST_F(Coarse, AShiftByOnePixelIsCaught)
{
    const parity::Capture right = draw(scene_, coarse_bits);
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
