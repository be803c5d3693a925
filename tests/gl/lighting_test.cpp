// Unlit and emitting surfaces: what they show under lights, in every strategy, and that the host's light stays its own.
#include "passes/batch.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/plates.h"
#include "tests/gl/support/spy.h"

namespace gltest
{
namespace
{

constexpr Rgb dim = {51, 102, 153}, glow = {102, 51, 204}, black = {0, 0, 0};

Rgb sum_of(const Rgb &a, const Rgb &b)
{
    Rgb out;
    for (size_t k = 0; k < 3; ++k) out[k] = static_cast<uint8_t>(std::min(255, int(a[k]) + int(b[k])));
    return out;
}

// One by one, with close textures, in batches, and in batches of one colour a triangle.
std::vector<passes::RendererOptions> every_way()
{
    std::vector<passes::RendererOptions> out;
    for (const passes::Strategy strategy : all_strategies)
        for (const passes::ColourFormat colours : {passes::ColourFormat::ubyte, passes::ColourFormat::real})
            for (int way = 0; way < 4; ++way) {
                passes::RendererOptions options = options_of(strategy);
                options.colours = colours;
                options.batch_triangles = way < 2 ? 0 : 128, options.flat_triangles = way < 3 ? 0 : 64;
                options.close_bytes = way == 1 ? 1 << 20 : 0, options.close_distance_m = 1000;
                out.push_back(options);
            }
    return out;
}

class Lighting : public PlateTest
{
};

TEST_F(Lighting, LeavesUnlitSurfaceItsColourWhateverTheLights)
{
    const PosedModel posed = split_posed(model_of(std::vector<Plate>{{dim, unlit()}, {dim, {}}}));
    for (const Lights lights : all_lights) {
        set(lights);
        const Picture picture = shown(posed);
        EXPECT_EQ(at(picture, 0, 2), dim) << int(lights);
        EXPECT_EQ(at(picture, 1, 2), lights == Lights::none ? black : lights == Lights::grey ? Rgb({20, 41, 61}) : dim);
    }
}

TEST_F(Lighting, AddsEmissionToTheLightThatColoursReturn)
{
    const PosedModel posed = split_posed(model_of(
        std::vector<Plate>{{black, emitting(glow)}, {dim, emitting(glow)}, {{200, 200, 200}, emitting(glow)}}));
    for (const Lights lights : {Lights::none, Lights::bright}) {
        set(lights);
        const Picture picture = shown(posed);
        const bool lit = lights == Lights::bright;
        EXPECT_EQ(at(picture, 0, 3), glow);
        EXPECT_EQ(at(picture, 1, 3), lit ? sum_of(dim, glow) : glow);
        EXPECT_EQ(at(picture, 2, 3), lit ? sum_of({200, 200, 200}, glow) : glow);
    }
}

TEST_F(Lighting, IsTheSameInEveryStrategyInBatchesAndAlone)
{
    for (const model::Lighting &lighting : {unlit(), emitting(glow), model::Lighting()})
        for (const bool mixed : {false, true}) {
            std::vector<Plate> plates = {{dim, lighting}};
            if (mixed) plates.push_back({{250, 90, 20}, {}}), plates.push_back({{7, 180, 33}, unlit()});
            const PosedModel posed = split_posed(model_of(plates));
            for (const Lights lights : all_lights) {
                set(lights);
                const Picture expected = shown(posed, options_of(passes::Strategy::per_zone));
                for (const passes::RendererOptions &options : every_way())
                    EXPECT_TRUE(shown(posed, options) == expected)
                        << int(lights) << int(options.strategy) << options.batch_triangles << options.flat_triangles;
            }
        }
}

TEST_F(Lighting, IsADrawOfItsOwnOnlyWhereItDiffers)
{
    passes::DrawStats stats;
    const auto draws = [&](const std::vector<Plate> &plates) {
        shown(split_posed(model_of(plates)), {}, &stats);
        return stats.draws;
    };
    EXPECT_EQ(draws({{dim, {}}, {glow, {}}}), 1u);
    EXPECT_EQ(draws({{dim, unlit()}, {glow, unlit()}}), 1u);
    EXPECT_EQ(draws({{dim, {}}, {glow, unlit()}, {dim, emitting(glow)}, {glow, unlit()}}), 3u);
}

TEST_F(Lighting, AsksGlNothingForCharactersThatAreLitAlone)
{
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    const auto calls = [&](const PosedModel &posed) {
        EXPECT_TRUE(renderer.prepare(*posed.tmpl).ok());
        spy.reset();
        EXPECT_TRUE(renderer.draw(list_of_one(posed), nullptr).ok());
        return spy.calls["glGetMaterialfv"] + spy.calls["glMaterialfv"];
    };
    const PosedModel lit = split_posed(model_of(std::vector<Plate>{{dim, {}}}));
    const PosedModel bright = split_posed(model_of(std::vector<Plate>{{dim, emitting(glow)}}));
    EXPECT_EQ(calls(lit), 0u);
    EXPECT_EQ(calls(bright), 6u) << "two queries, two to set, two to restore";
    renderer.destroy();
}

// Guards: the host's light and emission are as found after a draw, and lit surfaces show them meanwhile.
TEST_F(Lighting, OfTheHostIsAsFound)
{
    const PosedModel posed = split_posed(model_of(
        std::vector<Plate>{{black, unlit()}, {black, {}}, {black, emitting(glow)}, {black, {}}, {dim, unlit()}}));
    const float front[4] = {0.2f, 0.4f, 0.6f, 1}, back[4] = {0.1f, 0.3f, 0.5f, 1};
    for (const passes::Guard guard : {passes::Guard::full, passes::Guard::minimal, passes::Guard::none}) {
        set(Lights::none);
        host_->Materialfv(gl::front, gl::emission, front);
        host_->Materialfv(gl::back, gl::emission, back);
        const Picture picture = shown(posed, options_of(passes::Strategy::fused, guard));
        EXPECT_EQ(at(picture, 0, 5), black);
        EXPECT_EQ(at(picture, 1, 5), dim);
        EXPECT_EQ(at(picture, 2, 5), glow);
        EXPECT_EQ(at(picture, 3, 5), dim);
        EXPECT_TRUE(host_->IsEnabled(gl::lighting)) << int(guard);
        float now[4];
        host_->GetMaterialfv(gl::front, gl::emission, now);
        EXPECT_TRUE(std::equal(now, now + 4, front)) << int(guard);
        host_->GetMaterialfv(gl::back, gl::emission, now);
        EXPECT_TRUE(std::equal(now, now + 4, back)) << int(guard);
        set(Lights::off);
        shown(posed, options_of(passes::Strategy::fused, guard));
        EXPECT_FALSE(host_->IsEnabled(gl::lighting)) << int(guard);
    }
}

// What a hook sets of lights acts on lit surface of its actor, and on nothing after it.
TEST_F(Lighting, OfAHookEndsWithIt)
{
    const PosedModel posed = split_posed(model_of(std::vector<Plate>{{dim, unlit()}, {dim, {}}}));
    const auto renderer = make_renderer_of(posed);
    set(Lights::none);
    const Callbacks lights([&] { return host_->Disable(gl::lighting), 0; }, nullptr);
    claque::draw::DrawList list = list_of_one(posed);
    list.items.push_back(list.items[0]);
    list.items[1].hooks = &lights.hooks;
    Picture picture = draw(*context_, *renderer, list);
    EXPECT_EQ(at(picture, 0, 2), dim);
    EXPECT_EQ(at(picture, 1, 2), dim);
    list.items.push_back(list.items[0]);
    picture = draw(*context_, *renderer, list);
    EXPECT_EQ(at(picture, 0, 2), dim);
    EXPECT_EQ(at(picture, 1, 2), black);
    EXPECT_TRUE(host_->IsEnabled(gl::lighting));
    renderer->destroy();
}

// A palette's texel contains the base colour where the zone has a colour of its own.
TEST_F(Lighting, IsNotDarkenedByTheTexelOfItsMaterial)
{
    model::Model source = model_of(std::vector<Plate>{{{255, 255, 255}, emitting({50, 50, 50})}});
    for (size_t k = 0; k < 3; ++k) source.materials[0].base_colour[k] = 100.0f / 255;
    const PosedModel posed = split_unwhitened(source);
    ASSERT_TRUE(passes::Batch::fits(*posed.tmpl, posed.tmpl->levels[0], 64))
        << "or no batch and no flat level draws it";
    set(Lights::none);
    for (const passes::RendererOptions &options : every_way()) EXPECT_NEAR(at(shown(posed, options), 0, 1)[0], 50, 1);
}

}  // namespace
}  // namespace gltest
