// All strategies, colour formats and context kinds give the same RGB and depth, lit and unlit, for every kind
// of template.
#include <cmath>

#include "tests/gl/support/absent.h"
#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

using passes::ColourFormat;
using passes::Strategy;

constexpr gl::Enum lighting = 0x0B50, light0 = 0x4000, fog = 0x0B60, flat = 0x1D00;

struct Shot {
    Picture rgb;
    std::vector<float> depth;
    bool operator==(const Shot &other) const { return rgb == other.rgb && depth == other.depth; }
};

uint32_t differing_pixels(const Picture &a, const Picture &b)
{
    uint32_t count = 0;
    for (size_t i = 0; i < a.size(); i += 3) count += !std::equal(&a[i], &a[i] + 3, &b[i]);
    return count;
}

class Strategies : public GlTest
{
protected:
    Shot shoot(const PosedModel &posed, const passes::RendererOptions &options, const claque::draw::DrawList &list)
    {
        const auto renderer = make_renderer_of(posed, options);
        Shot shot;
        shot.rgb = draw(*context_, *renderer, list);
        context_->read_depth(shot.depth);
        renderer->destroy();
        return shot;
    }

    // Compares every strategy and format with the papers' way.
    void expect_same(const PosedModel &posed, const claque::draw::DrawList &list)
    {
        const Shot papers = shoot(posed, options_of(Strategy::per_zone), list);
        for (const Strategy strategy : all_strategies)
            for (const ColourFormat format : {ColourFormat::ubyte, ColourFormat::real}) {
                passes::RendererOptions options = options_of(strategy);
                options.colours = format;
                const Shot shot = shoot(posed, options, list);
                EXPECT_EQ(differing_pixels(shot.rgb, papers.rgb), 0u) << int(strategy) << " " << int(format);
                EXPECT_TRUE(shot.depth == papers.depth) << int(strategy) << " " << int(format);
            }
    }
    void expect_same(const PosedModel &posed) { expect_same(posed, list_of(posed, whole_view(posed))); }

    void light_up() const
    {
        const float direction[4] = {0.3f, 0.5f, 0.8f, 0}, colour[4] = {0.9f, 0.8f, 0.7f, 1};
        host_->MatrixMode(gl::modelview);
        host_->LoadIdentity();
        host_->Lightfv(light0, 0x1203, direction);
        host_->Lightfv(light0, 0x1201, colour);
        host_->Enable(light0);
        host_->Enable(lighting);
        const float fog_colour[4] = {0.5f, 0.6f, 0.7f, 1};
        host_->Fogfv(0x0B66, fog_colour);
        host_->Enable(fog);
    }
};

TEST_F(Strategies, AgreeOnAPaintedTexture)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    expect_same(posed);
}

TEST_F(Strategies, AgreeUnderLightAndFogSmoothAndFlat)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    light_up();
    expect_same(posed);
    host_->ShadeModel(flat);
    expect_same(posed);
}

PosedModel with_vertex_colours()
{
    Mesh mesh = sheet(9, 0.2f);
    for (size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.colours.push_back({uint8_t(v * 7), uint8_t(255 - v), uint8_t(90 + v), 255});
    PosedModel posed = make_posed(mesh, torture_map(128, 8, 3));
    paint(*posed.tmpl);
    return posed;
}

TEST_F(Strategies, AgreeWithVertexColours)
{
    const PosedModel posed = with_vertex_colours();
    expect_same(posed);
    light_up();
    expect_same(posed);
}

TEST_F(Strategies, AgreeOnHolesAndLeaveThem)
{
    ZoneMap map = torture_map(128, 8, 3);
    for (size_t i = 0; i < map.zones.size(); ++i)
        if (i / 128 % 16 < 5 && i % 16 < 5) map.zones[i] = hole;
    const PosedModel posed = make_posed(sheet(9, 0.2f), map);
    expect_same(posed);
    const Wanted wanted = wanted_of(*context_, posed, whole_view(posed));
    const std::vector<uint8_t> colours = zone_colours(8);
    const auto list = list_of(posed, whole_view(posed), colours.data());
    for (const Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(posed, options_of(strategy));
        const Comparison c = Verdict().hold(wanted, draw(*context_, *renderer, list), 0.15);
        EXPECT_LT(c.covered, 0.95 * 0.26 * width * height) << "no hole to be seen";
    }
}

// The sheet seen from behind: nothing unless it is double-sided; mirrored, its front.
TEST_F(Strategies, AgreeOnMirroredAndDoubleSidedOnes)
{
    PosedModel posed = small_posed();
    light_up();
    const Camera behind = camera_on(posed, 2.6f, 2.8f, 0.4f, float(width) / height);
    claque::draw::DrawList list = list_of(posed, behind);
    const auto shown = [&](Strategy strategy) {
        return covered(draw(*context_, *make_renderer_of(posed, options_of(strategy)), list, 0));
    };
    for (const Strategy strategy : all_strategies) {
        list.items[0].mirrored = false;
        posed.tmpl->levels[0].surfaces[0].double_sided = false;
        EXPECT_LT(shown(strategy), 400u) << "the waves show a little of the front at most";
        list.items[0].mirrored = true;
        EXPECT_GT(shown(strategy), 10000u);
        list.items[0].mirrored = false;
        posed.tmpl->levels[0].surfaces[0].double_sided = true;
        EXPECT_GT(shown(strategy), 10000u);
    }
    expect_same(posed, list);
}

TEST_F(Strategies, AgreeWithThePapersEqualTest)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    const claque::draw::DrawList list = list_of(posed, whole_view(posed));
    passes::RendererOptions options = options_of(Strategy::per_zone);
    const Shot at_least = shoot(posed, options, list);
    options.key_test = passes::KeyTest::equal;
    EXPECT_TRUE(shoot(posed, options, list) == at_least);
}

TEST_F(Strategies, AgreeOnIndividualsOfTheirOwnColoursBehindEachOther)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    light_up();
    std::vector<std::vector<uint8_t>> colours(5, zone_colours(8));
    claque::draw::DrawList list = list_of(posed, whole_view(posed));
    for (uint32_t i = 0; i < 5; ++i) {
        for (uint8_t &c : colours[i]) c = static_cast<uint8_t>(c * 7 + i * 31);
        claque::draw::Item item = list.items[0];
        item.zone_rgb = colours[i].data();
        item.model_view[12] += 0.5f * float(i) - 1;
        item.model_view[14] -= 0.7f * float(i);
        list.items.push_back(item);
    }
    expect_same(posed, list);
}

// Under light of one half, odd multiples of 17 on odd multiples of 15 lie exactly between two pixel values: an ulp of
// difference between the ways of passing a colour to GL becomes another pixel.
TEST_F(Strategies, AgreeWhereAPixelIsOneUlpFromAnother)
{
    constexpr gl::Enum light_model_ambient = 0x0B53;
    const float half[4] = {0.5f, 0.5f, 0.5f, 1};
    host_->LightModelfv(light_model_ambient, half);
    host_->Enable(lighting);
    const PosedModel posed = small_posed();
    model::Array<uint8_t> &rgba = posed.tmpl->textures[0].rgba;
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) rgba[i] = static_cast<uint8_t>(15 * (2 * (i / 4 % 9) + 1));
    std::vector<uint8_t> colours;
    for (uint32_t c = 0; c < 24; ++c) colours.push_back(static_cast<uint8_t>(17 * (2 * (c % 8) + 1)));
    expect_same(posed, list_of(posed, whole_view(posed), colours.data()));
}

TEST_F(Strategies, GiveTheSamePixelsWithOsmesaAndEgl)
{
    const PosedModel posed = with_vertex_colours();
    const claque::draw::DrawList list = list_of(posed, whole_view(posed));
    for (const Strategy strategy : all_strategies) {
        Shot shots[2];
        for (const contexts::Kind kind : {contexts::Kind::osmesa, contexts::Kind::egl}) {
            std::string why;
            context_ = contexts::make_offscreen(kind, width, height, contexts::PixelFormat::rgba8888, why);
            if (!context_) END_WITHOUT_CONTEXT(kind, why);
            host_ = std::make_unique<HostGl>(*context_);
            light_up();
            shots[kind == contexts::Kind::egl] = shoot(posed, options_of(strategy), list);
        }
        EXPECT_TRUE(shots[0] == shots[1]) << int(strategy);
    }
}

}  // namespace
}  // namespace gltest
