// A template whose arrays GL would read beyond their ends is not prepared: each length and each number that is an
// index, on both sides of its bound.
#include <functional>

#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

using Forge = std::function<void(model::Template &)>;

model::Level &level(model::Template &tmpl) { return tmpl.levels[0]; }
model::Surface &surface(model::Template &tmpl) { return tmpl.levels[0].surfaces[0]; }

// With all four ranges, and of two texture sets, so that a texture has a second image.
PosedModel good()
{
    PosedModel posed = make_posed(sheet(24, 0.2f), torture_map(128, 3, 6));
    EXPECT_FALSE(surface(*posed.tmpl).clean.empty() || surface(*posed.tmpl).dirty_by_zone.empty());
    posed.tmpl->texture_sets.emplace_back("second");
    model::Texture &texture = posed.tmpl->textures[0];
    model::TextureImage &image = texture.set_images.emplace_back(std::pmr::get_default_resource());
    image.width = texture.width, image.height = texture.height, image.rgba = texture.rgba;
    return posed;
}

class SoundTemplates : public GlTest
{
protected:
    // The refusal of one that was forged; "" if it is prepared.
    std::string said(const Forge &forge)
    {
        const PosedModel forged = good();
        forge(*forged.tmpl);
        const auto renderer = make_renderer();
        const Status status = renderer->prepare(*forged.tmpl);
        renderer->destroy();
        if (status.ok()) return "";
        EXPECT_EQ(status.code, CLQ_ARGUMENT);
        return status.text;
    }
    void refuses(const char *why, const Forge &forge, int line)
    {
        EXPECT_EQ(said(forge), std::string("template 'hand-made': ") + why) << "line " << line;
    }
    void takes(const Forge &forge, int line) { EXPECT_EQ(said(forge), "") << "line " << line; }
};

#define REFUSES(why, ...) \
    refuses(              \
        why, [](model::Template &t) { __VA_ARGS__; }, __LINE__)
#define TAKES(...) takes([]([[maybe_unused]] model::Template &t) { __VA_ARGS__; }, __LINE__)

TEST_F(SoundTemplates, HaveAColourOfEachZone)
{
    const char *const why = "zone colours do not match its zones";
    TAKES();
    REFUSES(why, t.zone_colours.pop_back());
    REFUSES(why, t.zone_colours.push_back({}));
}

TEST_F(SoundTemplates, HaveTheBytesAndKeysOfTheirTextures)
{
    const char *const why = "a texture's bytes or keys do not match its size or zones";
    REFUSES(why, t.textures[0].width = 0, t.textures[0].rgba.clear());
    REFUSES(why, t.textures[0].height = 0, t.textures[0].rgba.clear());
    REFUSES(why, t.textures[0].rgba.pop_back());
    REFUSES(why, t.textures[0].rgba.push_back(0));
    TAKES(t.textures.push_back(t.textures[0]));
    REFUSES(why, t.textures.push_back(t.textures[0]), t.textures[1].keys.clear());
    TAKES(t.textures[0].set_images.clear());
    REFUSES(why, t.texture_sets.clear());
    REFUSES(why, t.texture_sets.emplace_back("third"));
    REFUSES(why, t.textures[0].set_images[0].rgba.pop_back());
    TAKES(t.textures[0].keys[0].zone = t.zone_count() - 1);
    REFUSES(why, t.textures[0].keys[0].zone = t.zone_count());
}

TEST_F(SoundTemplates, HaveTheArraysOfTheirVertices)
{
    const char *const why = "a level has an index, part or array length out of range";
    TAKES(level(t).source_count = level(t).vertex_count);
    REFUSES(why, level(t).source_count = level(t).vertex_count + 1);
    REFUSES(why, level(t).uvs.pop_back());
    REFUSES(why, level(t).uvs.push_back(0));
    REFUSES(why, level(t).slots.pop_back());
    REFUSES(why, level(t).slots.push_back(0));
    TAKES(level(t).colours.resize(4 * level(t).vertex_count));
    REFUSES(why, level(t).colours.resize(4 * level(t).vertex_count - 1));
    REFUSES(why, level(t).colours.resize(4 * level(t).vertex_count + 1));
    TAKES(level(t).indices.back() = level(t).vertex_count - 1);
    for (const size_t at : {size_t(0), level(*good().tmpl).indices.size() - 1})
        refuses(
            why, [=](model::Template &t) { level(t).indices[at] = level(t).vertex_count; }, __LINE__);
}

TEST_F(SoundTemplates, HaveTheRangesOfTheirSurfaces)
{
    const char *const why = "a level has an index, part or array length out of range";
    REFUSES(why, surface(t).texture = 1);
    const auto each = [&](model::IndexRange *(*range)(model::Surface &)) {
        const auto forged = [&](uint32_t first_behind_end, uint32_t count) {
            return [=](model::Template &t) {
                const auto size = static_cast<uint32_t>(level(t).indices.size());
                std::fill(level(t).indices.begin(), level(t).indices.end(), 0u);
                *range(surface(t)) = {size + first_behind_end - count, count};
            };
        };
        takes(forged(0, 3), __LINE__);
        takes(forged(0, 0), __LINE__);
        refuses(why, forged(1, 3), __LINE__);
        refuses(why, forged(1, 0), __LINE__);
        refuses(why, forged(0, 2), __LINE__);
    };
    each([](model::Surface &s) { return &s.dirty; });
    each([](model::Surface &s) { return &s.fused; });
    each([](model::Surface &s) { return &s.clean[0].range; });
    each([](model::Surface &s) { return &s.dirty_by_zone[0].range; });
    TAKES(surface(t).clean[0].zone_index = static_cast<uint32_t>(t.textures[0].keys.size()) - 1);
    REFUSES(why, surface(t).clean[0].zone_index = static_cast<uint32_t>(t.textures[0].keys.size()));
    REFUSES(why, surface(t).dirty_by_zone[0].zone_index = static_cast<uint32_t>(t.textures[0].keys.size()));
}

}  // namespace
}  // namespace gltest
