// Texture sets: other images on the same triangles (S1 1, S2 2.1). Indices and vertices are shared, so a triangle is
// clean only if no set shows a second zone on it.
#include <string>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "models.h"

namespace claque::test
{

namespace
{

uint8_t left_right(uint32_t x, uint32_t) { return x < 8 ? 100 : 200; }
uint8_t right_left(uint32_t x, uint32_t) { return x < 8 ? 200 : 100; }
uint8_t all_left(uint32_t, uint32_t) { return 100; }

model::Model sheet_with(const std::vector<model::Image> &others)
{
    model::Model m = keyed_sheet(8, 4, key_image(16, 16, left_right), {100, 200});
    for (const model::Image &other : others) {
        m.texture_sets.push_back({"set " + std::to_string(m.images.size()), {uint32_t(m.images.size())}});
        m.images.push_back(other);
    }
    return m;
}

uint32_t dirty_of(const std::vector<model::Image> &others)
{
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::build(sheet_with(others), {}, tmpl);
    return tmpl.report.dirty;
}

std::string refusal_of_sets(const model::Model &m)
{
    model::Template tmpl(std::pmr::get_default_resource());
    try {
        meshsplit::build(m, {}, tmpl);
    } catch (const base::Error &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(TextureSets, SetsWhoseZonesLieAlikeMakeNoTriangleDirty)
{
    model::Image darker = key_image(16, 16, left_right);
    for (size_t i = 0; i < darker.rgba.size(); ++i)
        if (i % 4 != 3) darker.rgba[i] /= 2;
    EXPECT_EQ(dirty_of({darker}), dirty_of({}));
    EXPECT_EQ(dirty_of({darker, darker, darker}), dirty_of({}));
}

TEST(TextureSets, ATriangleIsDirtyWhereTwoSetsShowTwoZonesOnIt)
{
    EXPECT_LT(dirty_of({}), 64u);
    EXPECT_EQ(dirty_of({key_image(16, 16, right_left)}), 64u);  // every triangle shows both, in one set or the other
    const uint32_t half = dirty_of({key_image(16, 16, all_left)});
    EXPECT_GT(half, dirty_of({}));  // those on the right show both
    EXPECT_LT(half, 64u);
}

TEST(TextureSets, EverySetKeepsItsOwnTexelsAndSizeUnderCommonKeys)
{
    const model::Model m = sheet_with({key_image(32, 8, all_left), key_image(16, 16, right_left)});
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::build(m, {}, tmpl);
    ASSERT_EQ(tmpl.texture_set_count(), 3u);
    EXPECT_EQ(tmpl.texture_sets[0], "set 1");
    ASSERT_EQ(tmpl.textures.size(), 1u);
    const model::Texture &texture = tmpl.textures[0];
    ASSERT_EQ(texture.keys.size(), 2u);
    ASSERT_EQ(texture.set_images.size(), 2u);
    EXPECT_EQ(texture.set_images[0].width, 32u);
    EXPECT_EQ(texture.set_images[0].height, 8u);
    const uint8_t low = texture.keys[0].key, high = texture.keys[1].key;
    EXPECT_EQ(texture.rgba[3], low);
    EXPECT_EQ(texture.set_images[0].rgba[4 * 31 + 3], low);
    EXPECT_EQ(texture.set_images[1].rgba[3], high);
    EXPECT_EQ(texture.set_images[1].rgba[4 * 15 + 3], low);
    for (uint32_t x = 0; x < 16; ++x) EXPECT_EQ(texture.set_images[1].rgba[4 * x + 1], x * 7) << x;
}

TEST(TextureSets, AZoneThatOneSetAloneShowsIsAZoneOfTheTexture)
{
    model::Model m = keyed_sheet(4, 4, key_image(16, 16, all_left), {100, 200});
    m.images.push_back(key_image(16, 16, left_right));
    m.texture_sets.push_back({"two", {1}});
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::build(m, {}, tmpl);
    EXPECT_EQ(tmpl.textures[0].keys.size(), 2u);
    EXPECT_GT(tmpl.report.dirty, 0u);
}

TEST(TextureSets, ASetThatChangesNothingKeepsNoTexels)
{
    model::Model m = sheet_with({});
    m.texture_sets.push_back({"same", {model::none}});
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::build(m, {}, tmpl);
    EXPECT_EQ(tmpl.texture_set_count(), 2u);
    EXPECT_TRUE(tmpl.textures[0].set_images.empty());
}

TEST(TextureSets, SetsThatBreakARuleAreRefusedByName)
{
    model::Model m = sheet_with({key_image(16, 16, right_left)});
    m.texture_sets[0].images[0] = 7;
    EXPECT_NE(
        refusal_of_sets(m).find("texture set 'set 1' has image 7, which does not exist (there are 2), for material 0"),
        std::string::npos)
        << refusal_of_sets(m);
    m.texture_sets[0].images.push_back(0);
    EXPECT_NE(refusal_of_sets(m).find("texture set 'set 1' names 2 images for 1 materials"), std::string::npos)
        << refusal_of_sets(m);
    m = sheet_with({key_image(16, 16, right_left)});
    m.images[1].alpha = model::AlphaMeaning::opacity;
    EXPECT_NE(refusal_of_sets(m).find("mean different things by alpha"), std::string::npos) << refusal_of_sets(m);
    m = sheet_with({key_image(16, 16, [](uint32_t, uint32_t) { return uint8_t(50); })});
    EXPECT_NE(refusal_of_sets(m).find("has key 50 in 256 texels, and no zone declares it"), std::string::npos)
        << refusal_of_sets(m);
    m = sheet_with(std::vector<model::Image>(64, key_image(2, 2, left_right)));
    EXPECT_NE(refusal_of_sets(m).find("has 65 texture sets: 64 are the most"), std::string::npos) << refusal_of_sets(m);
}

}  // namespace claque::test
