// Levels with one colour per triangle: unlit and lit pictures, sent data, and no effect on other individuals.
#include "passes/flat.h"

#include <set>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "passes/welded.h"
#include "tests/gl/support/crowds.h"
#include "tests/gl/support/hooked.h"

namespace gltest
{
namespace
{

class Flat : public CrowdOf<60>
{
protected:
    const passes::FlatLevel &flat_level()
    {
        if (prepared_.levels.empty()) {
            EXPECT_TRUE(passes::prepare_without_gl(prepared_, *posed_->tmpl, {}, 8).ok());
        }
        return prepared_.levels[0].flat;
    }
    using Colour = std::array<double, 3>;
    std::vector<Colour> colours_lit_from(const glm::dvec3 &light, const Item &item, const uint8_t *zone_rgb);

    passes::PreparedTemplate prepared_{std::pmr::get_default_resource()};
};

// In double precision, with GL's lighting: what each provoking vertex shows.
std::vector<Flat::Colour> Flat::colours_lit_from(const glm::dvec3 &light, const Item &item, const uint8_t *zone_rgb)
{
    constexpr double ambient = 0.2;  // GL's default
    const passes::FlatLevel &flat = flat_level();
    glm::dmat3 turn;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) turn[c][r] = double(item.model_view[4 * c + r]);
    const auto at = [&](uint16_t v) {
        const float *p = item.vertices.positions + 3 * size_t(flat.vertices[v]);
        return turn * glm::dvec3(double(p[0]), double(p[1]), double(p[2]));
    };
    std::vector<glm::dvec3> normals(flat.vertices.size(), glm::dvec3(0));
    for (size_t i = 0; i < flat.indices.size(); i += 3) {
        const glm::dvec3 a = at(flat.indices[i]), b = at(flat.indices[i + 1]), c = at(flat.indices[i + 2]);
        normals[flat.indices[i + 2]] += (item.mirrored ? -1.0 : 1.0) * glm::cross(b - a, c - a);
    }
    std::vector<Colour> out;
    for (size_t i = 2; i < flat.indices.size(); i += 3) {
        const uint16_t v = flat.indices[i];
        const double lit = ambient + std::max(0.0, glm::dot(glm::normalize(normals[v]), glm::normalize(light)));
        Colour colour;
        for (size_t k = 0; k < 3; ++k) {
            const double zone = zone_rgb[3 * flat.zones[flat.colour_entries[v]] + k] / 255.0;
            colour[k] = 255 * std::min(1.0, lit * zone * flat.texel(flat.colour_entries[v], 0)[k] / 255.0);
        }
        out.push_back(colour);
    }
    return out;
}

TEST_F(Flat, ShowUnlitWhatTheyShowSmooth)
{
    const Picture flat = shown(many(), {}), expected = shown(many(), smooth());
    ASSERT_GT(covered(expected), 5000u);
    EXPECT_EQ(different(flat, expected, 1), 0u);
}

TEST_F(Flat, ShowUnlitWhatTheyShowSmoothWithTexturesToo)
{
    constexpr uint32_t block = 4;  // side in texels of the uniform squares in proxies' textures
    PosedModel painted = proxy_posed(60);
    model::Texture &texture = painted.tmpl->textures[painted.tmpl->levels[0].surfaces[0].texture];
    for (uint32_t y = 0; y < texture.height; ++y)
        for (uint32_t x = 0; x < texture.width; ++x)
            for (uint32_t c = 0; c < 3; ++c)
                texture.rgba[4 * size_t(y * texture.width + x) + c] =
                    static_cast<uint8_t>(110 + (40 * (x / block) + 25 * (y / block) + 60 * c) % 146);
    posed_ = &painted;
    const Picture flat = shown(many(), {}), expected = shown(many(), smooth());
    EXPECT_GT(different(expected, shown(squeezed(), smooth()), 8), 1000u);
    EXPECT_EQ(different(flat, expected, 1), 0u);
    posed_ = &posed();
    EXPECT_GT(different(flat, shown(many(), {}), 8), 1000u) << "the texture is not visible";
}

TEST_F(Flat, SendAboutOneVertexForTwoTriangles)
{
    passes::DrawStats flat, smoothly;
    shown(many(), {}, &flat);
    shown(many(), smooth(), &smoothly);
    EXPECT_EQ(flat.individuals, smoothly.individuals);
    EXPECT_EQ(flat.triangles, smoothly.triangles);
    EXPECT_LT(flat.vertices, 3 * flat.triangles / 4);
    EXPECT_LT(flat.vertices, smoothly.vertices);
    EXPECT_LE(flat.draws, smoothly.draws);
}

TEST_F(Flat, AreTheSameForAllStrategiesAndFormatsOfColours)
{
    light_from({1, 0.4f, 0.2f, 0});
    expect_the_same_for_all_strategies_and_formats();
}

// A single individual, unscaled, in odd scales and mirrored: every pixel has the colour of one of its triangles.
TEST_F(Flat, AreDrawnTogetherWhateverTheirTextureSets)
{
    PosedModel dressed = proxy_posed(60);
    ASSERT_EQ(dressed.tmpl->textures[0].set_images.size(), 1u);
    model::Array<uint8_t> &rgba = dressed.tmpl->textures[0].set_images[0].rgba;
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) rgba[i] = static_cast<uint8_t>(rgba[i] / 2);
    posed_ = &dressed;
    DrawList alike = many(), by_turns = many();
    for (size_t i = 1; i < by_turns.items.size(); i += 2) by_turns.items[i].texture_set = 1;
    passes::DrawStats of_one, of_two;
    const Picture one = shown(alike, {}, &of_one), two = shown(by_turns, {}, &of_two);
    EXPECT_GT(different(one, two, 8), 1000u) << "the other set is not visible";
    EXPECT_EQ(of_two.draws, of_one.draws);
    posed_ = &posed();
}

TEST_F(Flat, AreLitByTheirFaceNormals)
{
    light_from({1, 0.4f, 0.2f, 0});
    for (const DrawList &crowd_list : {many(), squeezed()})
        for (const uint32_t person : {19u, 21u}) {  // 21 is mirrored in the second
            DrawList list = crowd_list;
            list.items = {crowd_list.items[person]};
            const std::vector<Colour> expected = colours_lit_from({1, 0.4, 0.2}, list.items[0], list.items[0].zone_rgb);
            const Picture picture = shown(list, {});
            uint32_t seen = 0, none_of_them = 0;
            std::set<std::array<uint8_t, 3>> distinct;
            for (size_t i = 0; i + 2 < picture.size(); i += 3) {
                if (is_background(picture, i)) continue;
                ++seen;
                distinct.insert({picture[i], picture[i + 1], picture[i + 2]});
                none_of_them += std::none_of(expected.begin(), expected.end(), [&](const Colour &c) {
                    for (size_t k = 0; k < 3; ++k)
                        if (std::fabs(c[k] - picture[i + k]) > 1.01) return false;
                    return true;
                });
            }
            EXPECT_GT(seen, 100u);
            EXPECT_GT(distinct.size(), 5u);
            EXPECT_LE(distinct.size(), expected.size());
            EXPECT_EQ(none_of_them, 0u) << "of " << seen << ", " << person;
        }
}

TEST_F(Flat, AreOnlyThoseOfFewTrianglesAtOneTexelEach)
{
    EXPECT_FALSE(flat_level().indices.empty());
    passes::RendererOptions fewer;
    fewer.flat_triangles = 59;
    passes::PreparedTemplate prepared(std::pmr::get_default_resource());
    ASSERT_TRUE(passes::prepare_without_gl(prepared, *posed_->tmpl, fewer, 8).ok());
    EXPECT_TRUE(prepared.levels[0].flat.indices.empty());

    PosedModel moved = proxy_posed(60);
    moved.tmpl->levels[0].uvs[0] += 0.001f;
    EXPECT_FALSE(passes::shows_texels(moved.tmpl->levels[0], 64));
    EXPECT_TRUE(passes::shows_texels(posed_->tmpl->levels[0], 64));
    const PosedModel sheet = small_posed();
    EXPECT_FALSE(passes::shows_texels(sheet.tmpl->levels[0], 1000));
}

// The host's shade model, texture coordinates and textures are restored for hooks and for smooth individuals that are
// drawn after those in flat colours.
TEST_F(Flat, LeaveOthersTheHostsShadeModel)
{
    constexpr gl::Enum smooth_model = 0x1D01;
    for (const gl::Enum model : {gl::flat, smooth_model}) {
        host_->ShadeModel(model);
        int32_t in_hook = 0, after = 0;
        const auto ask = [&] {
            host_->GetIntegerv(gl::shade_model, &in_hook);
            return 0;
        };
        const Callbacks hooks(ask, {});
        DrawList list = many();
        list.items[20].hooks = &hooks.hooks;
        for (const passes::Guard guard : {passes::Guard::full, passes::Guard::minimal, passes::Guard::none}) {
            in_hook = after = 0;
            shown(list, options_of(passes::Strategy::fused, guard));
            host_->GetIntegerv(gl::shade_model, &after);
            EXPECT_EQ(gl::Enum(in_hook), model);
            EXPECT_EQ(gl::Enum(after), model);
            SetUp();
            host_->ShadeModel(model);
        }
    }
}

TEST_F(Flat, DrawActorsWithHooksSmoothBetweenThem)
{
    light_from({1, 0.4f, 0.2f, 0});
    const auto nothing = [] { return 0; };
    const Callbacks hooks(nothing, {});
    DrawList list = many(), one = many();
    list.items[20].hooks = one.items[20].hooks = &hooks.hooks;
    one.items = {one.items[20]};
    DrawList smooth_one = many();
    smooth_one.items = {smooth_one.items[20]};
    EXPECT_TRUE(shown(one, {}) == shown(smooth_one, apart()));
    DrawList others = many();
    others.items.erase(others.items.begin() + 20);
    const Picture with = shown(list, {}), without = shown(others, {}), alone = shown(one, {});
    for (size_t i = 0; i + 2 < with.size(); i += 3) {
        const Picture &from = is_background(alone, i) ? without : with;
        ASSERT_TRUE(std::equal(from.begin() + long(i), from.begin() + long(i) + 3, with.begin() + long(i)));
    }
}

// A texture of the host's must not affect individuals that are drawn without one.
TEST_F(Flat, AreNotTintedByATextureThatTheHostHasLeftOn)
{
    const Picture calm = shown(many(), {});
    constexpr gl::Enum texture_1d = 0x0DE0, rgb = 0x1907;
    const uint8_t dark[2 * 3] = {20, 20, 20, 40, 40, 40};
    host_->ask<void (*)(gl::Enum, int32_t, int32_t, int32_t, int32_t, gl::Enum, gl::Enum, const void *)>(
        "glTexImage1D")(texture_1d, 0, int32_t(rgb), 2, 0, rgb, gl::unsigned_byte, dark);
    host_->ask<void (*)(gl::Enum, gl::Enum, int32_t)>("glTexParameteri")(texture_1d, 0x2801, 0x2600);
    host_->Enable(texture_1d);
    EXPECT_TRUE(shown(many(), {}) == calm);
    EXPECT_TRUE(host_->IsEnabled(texture_1d));
}

}  // namespace
}  // namespace gltest
