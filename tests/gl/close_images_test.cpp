// The images of textures of single individuals, as GL gets them.
#include <cmath>

#include "tests/gl/support/absent_extension.h"
#include "tests/gl/support/close.h"
#include "tests/gl/support/hostile.h"
#include "tests/gl/support/spy.h"
#include "tests/gl/support/state_dump.h"
#include "tests/gl/support/unpack_buffer.h"

namespace gltest
{
namespace
{

struct Sent {
    size_t width, height;
    std::vector<uint8_t> rgba;
};

class CloseImages : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        paint(*posed_.tmpl);
    }

    // The levels that a first draw sends for one individual.
    std::vector<Sent> levels_of(const PosedModel &posed, const uint8_t *zone_rgb)
    {
        Spy spy(*context_);
        passes::Renderer renderer(std::pmr::get_default_resource(), close_options());
        EXPECT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
        EXPECT_TRUE(renderer.prepare(*posed.tmpl).ok());
        std::vector<Sent> levels;
        spy.watch = [&](const std::string &name, const std::vector<double> &arguments) {
            if (name != "glTexImage2D") return;
            EXPECT_EQ(arguments[1], double(levels.size()));
            const size_t width = size_t(arguments[3]), height = size_t(arguments[4]);
            const auto *pixels = reinterpret_cast<const uint8_t *>(static_cast<uintptr_t>(arguments[8]));
            levels.push_back({width, height, {pixels, pixels + 4 * width * height}});
        };
        EXPECT_TRUE(renderer.draw(list_of(posed, whole_view(posed), zone_rgb), nullptr).ok());
        spy.watch = nullptr;
        renderer.destroy();
        return levels;
    }

    const PosedModel posed_ = small_posed();
};

TEST_F(CloseImages, HaveEveryLevelDownToOneTexelAndEachIsTheMeanOfTheOneBefore)
{
    const std::vector<uint8_t> colours = zone_colours(8);
    const std::vector<Sent> levels = levels_of(posed_, colours.data());
    ASSERT_EQ(levels.size(), 8u);
    for (size_t k = 1; k < levels.size(); ++k) {
        const Sent &from = levels[k - 1], &to = levels[k];
        ASSERT_EQ(to.width, from.width / 2);
        ASSERT_EQ(to.height, from.height / 2);
        for (size_t i = 0; i < to.rgba.size(); ++i) {
            const size_t x = i / 4 % to.width, y = i / 4 / to.width, c = i % 4;
            double mean = 0;
            for (size_t s = 0; s < 4; ++s)
                mean += from.rgba[4 * ((2 * y + s / 2) * from.width + 2 * x + s % 2) + c] / 4.0;
            ASSERT_LE(std::fabs(mean - to.rgba[i]), 0.5) << "level " << k << ", byte " << i;
        }
    }
}

// Each texel is the product of the template's texel and the colour of its zone.
TEST_F(CloseImages, ShowEachTexelInTheColourOfItsZone)
{
    const std::vector<uint8_t> colours = zone_colours(8);
    const Sent first = levels_of(posed_, colours.data()).at(0);
    const model::Texture &texture = posed_.tmpl->textures[0];
    for (size_t i = 0; i < first.rgba.size(); i += 4) {
        size_t key = 0;
        while (texture.keys[key].key != texture.rgba[i + 3]) ++key;
        for (size_t c = 0; c < 3; ++c)
            ASSERT_LE(
                std::fabs(texture.rgba[i + c] * colours[3 * texture.keys[key].zone + c] / 255.0 - first.rgba[i + c]),
                0.5)
                << i;
        ASSERT_EQ(first.rgba[i + 3], 255);
    }
}

// Filtering takes texels beyond the charts, and coarse levels take many.
TEST_F(CloseImages, RepeatTheEdgesOfChartsOutsideThem)
{
    Mesh mesh = sheet(9, 0.2f);
    for (glm::vec2 &uv : mesh.uvs) uv = glm::vec2(0.25f) + 0.5f * uv;
    const PosedModel posed = make_posed(mesh, torture_map(128, 8, 3));
    model::Texture &texture = posed.tmpl->textures[0];
    for (size_t i = 0; i < texture.rgba.size(); i += 4) {
        const size_t x = i / 4 % 128, y = i / 4 / 128;
        const bool inside = x >= 31 && x <= 96 && y >= 31 && y <= 96;
        for (size_t c = 0; c < 3; ++c) texture.rgba[i + c] = inside ? (c == 0 ? 20 : 200) : (c == 0 ? 255 : 0);
    }
    const std::vector<uint8_t> white(24, 255);
    for (const Sent &level : levels_of(posed, white.data()))
        for (size_t i = 0; i < level.rgba.size(); i += 4)
            ASSERT_TRUE(level.rgba[i] == 20 && level.rgba[i + 1] == 200) << level.width << ", texel " << i / 4;
}

TEST_F(CloseImages, AreNotMadeForTrianglesAtAnEdgeThatClamps)
{
    for (const float reach : {0.5f, 0.49f}) {
        Mesh mesh = sheet(9, 0.2f);
        for (glm::vec2 &uv : mesh.uvs) uv = glm::vec2(0.5f) + 2 * reach * (uv - glm::vec2(0.5f));
        const PosedModel posed = make_posed(mesh, torture_map(128, 8, 3));
        posed.tmpl->textures[0].wrap_s = posed.tmpl->textures[0].wrap_t = model::Wrap::clamp;
        EXPECT_EQ(levels_of(posed, nullptr).empty(), reach == 0.5f) << reach;
    }
}

TEST_F(CloseImages, LeaveTheStateOfAHostileHostAsItWasWhenTheyAreMadeAndWhenTheyGo)
{
    passes::RendererOptions options = close_options();
    options.close_bytes = 100000;
    for (const bool in_two_colours : {false, true}) {
        const auto renderer = make_renderer_of(posed_, options);
        const HostileHost hostile(*host_);
        const std::vector<uint8_t> colours = zone_colours(8), others(24, 77);
        const State before = dump_state(*host_);
        passes::DrawStats stats;
        ASSERT_TRUE(renderer->draw(list_of(posed_, whole_view(posed_), colours.data()), &stats).ok());
        if (in_two_colours) {
            ASSERT_TRUE(renderer->draw(list_of(posed_, whole_view(posed_), others.data()), &stats).ok());
        }
        EXPECT_EQ(stats.close_made, 1u);
        EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
        SetUp();
    }
}

TEST_F(CloseImages, AreRefusedWithTheDrawWhereAHostsBufferWouldBeReadInstead)
{
    NEEDS_EXTENSION("GL_ARB_pixel_buffer_object", *host_);
    const auto renderer = make_renderer_of(posed_, close_options()), plain = make_renderer_of(posed_);
    const UnpackBuffer buffer(*host_);
    buffer.bind();
    const Status status = renderer->draw(list_of(posed_, whole_view(posed_)), nullptr);
    EXPECT_EQ(status.code, CLQ_GL_STATE) << status.text;
    EXPECT_NE(std::string(status.text).find("GL_PIXEL_UNPACK_BUFFER"), std::string::npos) << status.text;
    EXPECT_TRUE(plain->draw(list_of(posed_, whole_view(posed_)), nullptr).ok());
    buffer.unbind();
    EXPECT_TRUE(renderer->draw(list_of(posed_, whole_view(posed_)), nullptr).ok());
}

}  // namespace
}  // namespace gltest
