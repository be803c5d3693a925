// Individuals that stand in each other's shadows.
#pragma once

#include "lib/figures/figure.h"
#include "tests/gl/support/ground.h"
#include "tests/gl/support/split.h"

namespace gltest
{

inline constexpr uint8_t lit = 255, dark = 127;  // half of white, as llvmpipe and softpipe round it, or one more
inline constexpr glm::dvec4 sun(-0.5, 0.66, 0.36, 0), lamp(-2.5, 4.5, 1.5, 1);

inline passes::ShadowOptions options_for(const glm::dvec4 &light, int32_t stencil_bit)
{
    passes::ShadowOptions options;
    for (int k = 0; k < 4; ++k) options.light[k] = light[k];
    options.stencil_bit = stencil_bit;
    options.lift = 0.002;
    return options;
}

class Shadows : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (!context_) return;
        static const PosedModel made = split_posed(claque::figures::citizen(), 2, 0.7);
        posed_ = &made;
        // So close that they stand in each other's shadows.
        people_ = {ground_.stand(made, {0, 0, 0}, 0.4f), ground_.stand(made, {0.5, 0, -0.4}, 2.0f),
                   ground_.stand(made, {1.2, 0, 0.6}, -1.0f, 0.9f)};
    }

    Picture read()
    {
        std::vector<uint8_t> rgb;
        context_->read_rgb(rgb);
        return rgb;
    }
    Picture shown(passes::Renderer &renderer, const DrawList &list, const passes::ShadowOptions &options,
                  passes::ShadowStats *stats = nullptr)
    {
        ground_.draw(*host_, width, height);
        const Status status = renderer.draw_shadows(list, options, stats);
        EXPECT_TRUE(status.ok()) << status.text;
        return read();
    }
    Picture shown(const std::vector<Item> &items, const passes::ShadowOptions &options,
                  passes::ShadowStats *stats = nullptr)
    {
        return shown(*make_renderer_of(*posed_), ground_.list_of(items), options, stats);
    }
    static uint32_t darkened(const Picture &picture)
    {
        uint32_t count = 0;
        for (size_t i = 0; i < picture.size(); i += 3) count += picture[i] != lit && picture[i] != 0;
        return count;
    }
    // Pixels that neither show the ground unchanged nor darkened once.
    static uint32_t wrong_shades(const Picture &picture)
    {
        uint32_t count = 0;
        for (size_t i = 0; i < picture.size(); i += 3)
            count += picture[i] != lit && picture[i] != dark && picture[i] != dark + 1 && picture[i] != 0;
        return count;
    }
    static uint32_t differing(const Picture &a, const Picture &b)
    {
        uint32_t count = 0;
        for (size_t i = 0; i < a.size(); i += 3) count += a[i] != b[i];
        return count;
    }

    Ground ground_{{0.8, 3.0, 4.6}, {0.6, 0.2, 0}, 320.0f / 240.0f};
    const PosedModel *posed_ = nullptr;
    std::vector<Item> people_;
};

}  // namespace gltest
