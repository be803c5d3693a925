// Individuals whose zones all have one colour are drawn with one call a surface, and show what the papers' passes show.
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/jointed.h"

namespace gltest
{
namespace
{

using passes::ColourFormat;
using passes::Strategy;

struct Drawn {
    Picture rgb;
    std::vector<float> depth;
    passes::DrawStats stats;
};

ZoneMap map_with_holes()
{
    ZoneMap map = torture_map(128, 8, 3);
    for (size_t i = 0; i < map.zones.size(); ++i)
        if (i / 128 % 16 < 5 && i % 16 < 5) map.zones[i] = hole;
    return map;
}

Mesh with_vertex_colours()
{
    Mesh mesh = sheet(9, 0.2f);
    for (size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.colours.push_back({uint8_t(v * 7), uint8_t(255 - v), uint8_t(90 + v), 255});
    return mesh;
}

// Its middle is of one zone.
ZoneMap map_of_a_middle()
{
    ZoneMap map = torture_map(128, 8, 3);
    for (uint32_t y = 0; y < 128; ++y)
        for (uint32_t x = 36; x < 92; ++x) map.zones[128 * y + x] = 0;
    return map;
}

std::vector<uint8_t> one_colour_of(const PosedModel &posed)
{
    std::vector<uint8_t> rgb;
    for (uint32_t zone = 0; zone < posed.tmpl->zone_count(); ++zone) rgb.insert(rgb.end(), {190, 120, 40});
    return rgb;
}

class Plain : public GlTest
{
protected:
    Drawn shoot(const PosedModel &posed, const passes::RendererOptions &options, const claque::draw::DrawList &list)
    {
        const auto renderer = make_renderer_of(posed, options);
        Drawn drawn;
        drawn.rgb = draw(*context_, *renderer, list);
        context_->read_depth(drawn.depth);
        EXPECT_TRUE(renderer->draw(list, &drawn.stats).ok());
        renderer->destroy();
        return drawn;
    }
    Drawn shoot(const PosedModel &posed, Strategy strategy, const std::vector<uint8_t> &rgb)
    {
        return shoot(posed, options_of(strategy), list_of(posed, whole_view(posed), rgb.data()));
    }

    // The per-zone strategy keeps the papers' passes, whatever the colours.
    void expect_what_passes_show(const PosedModel &posed)
    {
        const std::vector<uint8_t> rgb = one_colour_of(posed);
        const auto list = list_of(posed, whole_view(posed), rgb.data());
        const Drawn papers = shoot(posed, options_of(Strategy::per_zone), list);
        const size_t surfaces = posed.tmpl->levels[0].surfaces.size();
        EXPECT_GT(papers.stats.draws, surfaces);
        for (const Strategy strategy : {Strategy::fused, Strategy::binned})
            for (const ColourFormat format : {ColourFormat::ubyte, ColourFormat::real}) {
                passes::RendererOptions options = options_of(strategy);
                options.colours = format;
                const Drawn plain = shoot(posed, options, list);
                EXPECT_TRUE(plain.rgb == papers.rgb) << int(strategy) << " " << int(format);
                EXPECT_TRUE(plain.depth == papers.depth) << int(strategy) << " " << int(format);
                EXPECT_EQ(plain.stats.draws, surfaces);
                EXPECT_EQ(plain.stats.triangles, once(posed));
                EXPECT_EQ(plain.stats.vertices, posed.tmpl->levels[0].source_count);
            }
    }
    // The triangles of each surface's fused stream.
    static std::vector<uint32_t> fused_counts(const PosedModel &posed)
    {
        std::vector<uint32_t> counts;
        for (const model::Surface &surface : posed.tmpl->levels[0].surfaces) counts.push_back(surface.fused.count / 3);
        return counts;
    }
    static uint32_t once(const PosedModel &posed)
    {
        uint32_t count = 0;
        for (const model::Surface &surface : posed.tmpl->levels[0].surfaces) {
            for (const model::Bin &bin : surface.clean) count += bin.range.count / 3;
            count += surface.dirty.count / 3;
        }
        return count;
    }
    void light_up() const
    {
        const float direction[4] = {0.3f, 0.5f, 0.8f, 0}, strong[4] = {2.5f, 1.4f, 0.7f, 1};
        host_->MatrixMode(gl::modelview);
        host_->LoadIdentity();
        host_->Lightfv(0x4000, 0x1203, direction);
        host_->Lightfv(0x4000, 0x1201, strong);
        host_->Enable(0x4000);
        host_->Enable(0x0B50);
    }
};

TEST_F(Plain, IndividualsOfOneColourShowWhatPassesShow)
{
    PosedModel posed = small_posed();
    paint(*posed.tmpl);
    expect_what_passes_show(posed);
    light_up();  // above 1, where GL limits light times colour
    expect_what_passes_show(posed);
}

TEST_F(Plain, IndividualsKeepHolesAndVertexColours)
{
    PosedModel with_holes = make_posed(sheet(9, 0.2f), map_with_holes());
    paint(*with_holes.tmpl);
    expect_what_passes_show(with_holes);
    PosedModel coloured = make_posed(with_vertex_colours(), torture_map(128, 8, 3));
    paint(*coloured.tmpl);
    expect_what_passes_show(coloured);
}

TEST_F(Plain, IndividualsShowTheirPartsAlone)
{
    Jointed on = make_jointed(puppet(), map_of_a_middle());
    paint(*on.posed.tmpl);
    const model::Surface &surface = on.posed.tmpl->levels[0].surfaces[0];
    ASSERT_TRUE(!surface.clean.empty() && surface.dirty.count != 0);
    const std::vector<uint8_t> rgb = one_colour_of(on.posed);
    for (uint32_t i = 1; i < 12; ++i) {
        auto list = list_of(on.posed, camera_on(on.posed, 2.6f, 0.5f * float(i), 0.2f, 4.0f / 3), rgb.data());
        list.items[0].parts = 0x5a5 ^ (i * 37);
        const Drawn papers = shoot(on.posed, options_of(Strategy::per_zone), list);
        const Drawn plain = shoot(on.posed, options_of(Strategy::fused), list);
        EXPECT_TRUE(plain.rgb == papers.rgb && plain.depth == papers.depth) << "parts " << list.items[0].parts;
        EXPECT_LT(plain.stats.triangles, once(on.posed));
    }
}

// Every zone counts, and each of its channels.
TEST_F(Plain, OneZoneOfAnotherColourTakesTheStrategyAgain)
{
    PosedModel posed = small_posed();
    paint(*posed.tmpl);
    const std::vector<uint8_t> alike = one_colour_of(posed);
    const uint32_t fused = fused_counts(posed)[0];
    ASSERT_GT(fused, once(posed));
    EXPECT_EQ(shoot(posed, Strategy::fused, alike).stats.triangles, once(posed));
    for (size_t byte = 0; byte < alike.size(); ++byte) {
        std::vector<uint8_t> rgb = alike;
        rgb[byte] ^= 1;
        EXPECT_EQ(shoot(posed, Strategy::fused, rgb).stats.triangles, fused) << "byte " << byte;
    }
}

TEST_F(Plain, FilteredCleanTrianglesKeepTheirTwoTextures)
{
    PosedModel posed = make_posed(sheet(40, 0.2f), torture_map(128, 4, 3));
    paint(*posed.tmpl);
    const std::vector<uint8_t> rgb = one_colour_of(posed);
    const auto list = list_of(posed, whole_view(posed), rgb.data());
    passes::RendererOptions options = options_of(Strategy::fused), papers = options_of(Strategy::per_zone);
    const Drawn unfiltered = shoot(posed, options, list);
    options.linear_clean = papers.linear_clean = true;
    const Drawn filtered = shoot(posed, options, list);
    EXPECT_TRUE(filtered.rgb == shoot(posed, papers, list).rgb);
    EXPECT_FALSE(filtered.rgb == unfiltered.rgb) << "no triangle is filtered";
}

// The keys of a host's texture are the template's, and so are its holes.
class PlainHooks : public HooksTest
{
};

TEST_F(PlainHooks, TexturesOfHostsKeepTheirHoles)
{
    PosedModel other = make_posed(sheet(9, 0.2f), map_with_holes());
    paint(*other.tmpl);
    const model::Texture &texture = other.tmpl->textures[0];
    uint32_t name = 0;
    host_->GenTextures(1, &name);
    host_->BindTexture(gl::texture_2d, name);
    host_->TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host_->TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host_->TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(texture.width), int32_t(texture.height), 0,
                      gl::rgba, gl::unsigned_byte, texture.rgba.data());
    host_->BindTexture(gl::texture_2d, 0);
    const Callbacks binds([&] { return host_->BindTexture(gl::texture_2d, name), 1; }, nullptr);
    std::vector<uint8_t> alike = one_colour_of(posed_), apart = alike;
    apart[0] ^= 1;
    const auto shot = [&](const std::vector<uint8_t> &rgb) {
        DrawList list = trio(binds);
        for (claque::draw::Item &item : list.items) item.zone_rgb = rgb.data();
        return draw(*context_, *make_renderer_of(posed_), list);
    };
    const Picture plain = shot(alike), passes = shot(apart);
    uint32_t holes = 0, differing = 0;
    for (size_t i = 0; i < plain.size(); i += 3) {
        const bool hole_in_one = std::equal(background, background + 3, &plain[i]);
        const bool hole_in_other = std::equal(background, background + 3, &passes[i]);
        holes += is_middle(i) && hole_in_other;
        differing += hole_in_one != hole_in_other;
    }
    EXPECT_EQ(differing, 0u);
    EXPECT_GT(holes, 100u);
}

}  // namespace
}  // namespace gltest
