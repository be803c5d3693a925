// A host's callbacks round the drawing of one individual (S0 7.1): when they are called, which state they find, and
// what they may change.
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/spy.h"

namespace gltest
{
namespace
{

using Hooks = HooksTest;

TEST_F(Hooks, AreCalledBeforeAndAfterTheDrawOfTheirIndividual)
{
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), options_of(passes::Strategy::per_zone));
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*posed_.tmpl).ok());
    passes::DrawStats alone;
    ASSERT_TRUE(renderer.draw(list_of(posed_, whole_view(posed_)), &alone).ok());
    std::vector<uint32_t> draws;
    const auto note = [&] { draws.push_back(spy.calls["glDrawElements"]); };
    const Callbacks both([&] { return note(), 0; }, note), first([&] { return note(), 0; }, nullptr),
        last(nullptr, note);
    DrawList list = trio(both);
    list.items[0].hooks = &first.hooks;
    list.items[2].hooks = &last.hooks;
    spy.reset();
    ASSERT_TRUE(renderer.draw(list, nullptr).ok());
    const uint32_t n = alone.draws;
    EXPECT_EQ(draws, (std::vector<uint32_t>{0, n, 2 * n, 3 * n}));
    EXPECT_EQ(both.index1, 12u);
    EXPECT_EQ(both.generation, 5u);
    EXPECT_EQ(first.index1, 11u);
    EXPECT_EQ(last.index1, 13u);
}

TEST_F(Hooks, AreNotCalledForActorsThatAreNotDrawn)
{
    uint32_t calls = 0;
    const Callbacks counting([&] { return ++calls, 0; }, [&] { ++calls; });
    const auto renderer = make_renderer_of(posed_);
    DrawList list = trio(counting);
    list.items[1].shadow_only = true;
    draw(*context_, *renderer, list);
    list.items[1].shadow_only = false;
    list.items[1].parts = 0;
    draw(*context_, *renderer, list);
    EXPECT_EQ(calls, 0u);
}

TEST_F(Hooks, FindTheirIndividualsTransformNoArraysAndNoTexture)
{
    const auto look = [&] {
        EXPECT_EQ(host_->IsEnabled(gl::vertex_array) + host_->IsEnabled(gl::colour_array), 0);
        int32_t mode = 0, texture = -1;
        host_->GetIntegerv(gl::matrix_mode, &mode);
        host_->GetIntegerv(gl::texture_binding_2d, &texture);
        EXPECT_EQ(gl::Enum(mode), gl::modelview);
        EXPECT_EQ(texture, 0);
        double matrix[16];
        host_->GetDoublev(gl::modelview_matrix, matrix);
        const DrawList list = trio();
        EXPECT_TRUE(std::equal(matrix, matrix + 16, list.items[1].model_view));
        host_->GetDoublev(gl::projection_matrix, matrix);
        EXPECT_TRUE(std::equal(matrix, matrix + 16, list.projection));
        return 0;
    };
    const Callbacks looking(look, look);
    for (const passes::Strategy strategy : all_strategies)
        draw(*context_, *make_renderer_of(posed_, options_of(strategy)), trio(looking));
}

// One hook may push and the other pop: lights for one individual.
TEST_F(Hooks, MayLightTheirIndividual)
{
    constexpr gl::Enum lighting = 0x0B50;
    const float dim[4] = {0.4f, 0.4f, 0.4f, 1};
    const Callbacks dims(
        [&] {
            host_->PushAttrib(gl::all_attrib_bits);
            host_->LightModelfv(0x0B53, dim);
            host_->Enable(lighting);
            return 0;
        },
        [&] { host_->PopAttrib(); });
    const Picture expected = calm();
    const Picture dimmed = draw(*context_, *make_renderer_of(posed_), trio(dims));
    expect_same_neighbours(dimmed, expected);
    EXPECT_FALSE(same_middle(dimmed, expected));
    uint64_t sum = 0, expected_sum = 0;
    for (size_t i = 0; i < dimmed.size(); ++i)
        if (is_middle(i)) sum += dimmed[i], expected_sum += expected[i];
    EXPECT_LT(sum, expected_sum);
    EXPECT_EQ(host_->GetError(), 0u);
}

// The same template with another image, and the zone keys that the image needs.
TEST_F(Hooks, MayBindATextureOfTheirOwn)
{
    PosedModel other = small_posed();
    paint(*other.tmpl);
    model::Texture &texture = other.tmpl->textures[0];
    for (size_t i = 0; i < texture.rgba.size(); i += 4)
        std::swap(texture.rgba[i], texture.rgba[i + 1]), texture.rgba[i + 2] /= 2;
    uint32_t name = 0;
    host_->GenTextures(1, &name);
    host_->BindTexture(gl::texture_2d, name);
    host_->TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host_->TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host_->TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(texture.width), int32_t(texture.height), 0,
                      gl::rgba, gl::unsigned_byte, texture.rgba.data());
    host_->BindTexture(gl::texture_2d, 0);
    int32_t answer = 1;
    const Callbacks binds([&] { return host_->BindTexture(gl::texture_2d, name), answer; }, nullptr);
    for (const passes::Strategy strategy : all_strategies) {
        const Picture expected = calm(options_of(strategy));
        DrawList list = trio();
        for (claque::draw::Item &item : list.items) item.tmpl = other.tmpl.get();
        const Picture all_other = draw(*context_, *make_renderer_of(other, options_of(strategy)), list);
        EXPECT_FALSE(same_middle(all_other, expected));
        const auto renderer = make_renderer_of(posed_, options_of(strategy));
        answer = 1;
        const Picture swapped = draw(*context_, *renderer, trio(binds));
        expect_same_neighbours(swapped, expected);
        EXPECT_TRUE(same_middle(swapped, all_other)) << int(strategy);
        answer = 0;
        EXPECT_EQ(draw(*context_, *renderer, trio(binds)), expected) << "the hook did not request its texture";
    }
}

TEST_F(Hooks, NeedOneMoreLevelOfTheAttributeStacks)
{
    const Callbacks none([] { return 0; }, nullptr);
    const auto renderer = make_renderer_of(posed_);
    int32_t most = 0;
    host_->GetIntegerv(gl::max_attrib_stack_depth, &most);
    for (int32_t i = 1; i < most; ++i) host_->PushAttrib(gl::current_bit);
    EXPECT_TRUE(renderer->draw(trio(), nullptr).ok());
    const Status status = renderer->draw(trio(none), nullptr);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_NE(std::string(status.text).find("glPushAttrib stack, claque needs 2"), std::string::npos) << status.text;
    host_->PopAttrib();
    EXPECT_TRUE(renderer->draw(trio(none), nullptr).ok());
    EXPECT_EQ(host_->GetError(), 0u);
}

}  // namespace
}  // namespace gltest
