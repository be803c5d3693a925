// A draw leaves no trace: all GL 1.1 state before and after a draw, for a host with no state at its default.
#include "passes/guard.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/hostile.h"
#include "tests/gl/support/spy.h"
#include "tests/gl/support/state_dump.h"

namespace gltest
{
namespace
{

using passes::Guard;
using passes::Left;

class HostState : public GlTest
{
protected:
    // Names of the state that a draw changed.
    std::vector<std::string> changed_by_draw(passes::Renderer &renderer, const claque::draw::DrawList &list)
    {
        const State before = dump_state(*host_);
        passes::DrawStats stats;
        const Status status = renderer.draw(list, &stats);
        EXPECT_TRUE(status.ok()) << status.text;
        EXPECT_EQ(stats.individuals, list.items.size());
        after_ = dump_state(*host_);
        return differences(before, after_);
    }

    // Draws for hosts with everything at its default, with arrays left enabled, and hostile; colours by array and by
    // glColor; mirrored and double-sided or not.
    std::set<gl::Enum> names_changed(Guard guard)
    {
        std::set<gl::Enum> names;
        for (const passes::Strategy strategy : {passes::Strategy::fused, passes::Strategy::per_zone})
            for (const Host kind : {Host::calm, Host::arrays_on, Host::hostile})
                for (const bool turned : {false, true}) {
                    SetUp();
                    PosedModel posed = small_posed();
                    posed.tmpl->levels[0].surfaces[0].double_sided = turned;
                    const auto renderer = make_renderer_of(posed, options_of(strategy, guard));
                    const std::unique_ptr<HostileHost> hostile = become(kind);
                    claque::draw::DrawList list = list_of(posed, whole_view(posed));
                    list.items[0].mirrored = turned;
                    for (const std::string &name : changed_by_draw(*renderer, list))
                        if (!is_of_a_texture(name)) names.insert(after_.at(name).name);
                }
        return names;
    }

    enum class Host { calm, arrays_on, hostile };
    std::unique_ptr<HostileHost> become(Host kind)
    {
        if (kind == Host::hostile) return std::make_unique<HostileHost>(*host_);
        if (kind == Host::arrays_on)
            for (const gl::Enum array : {gl::vertex_array, gl::normal_array, gl::texture_coord_array})
                host_->EnableClientState(array);
        return nullptr;
    }

    // Parameters belong to the bound texture, and a draw binds another one.
    static bool is_of_a_texture(const std::string &name) { return name.rfind("GL_TEXTURE_2D GL_", 0) == 0; }

    static void expect_documented(const std::set<gl::Enum> &changed, const std::vector<Left> &documented)
    {
        std::set<gl::Enum> names;
        for (const Left &left : documented) {
            names.insert(left.name);
            const bool undefined = std::string(left.as).find("undefined") != std::string::npos;
            EXPECT_TRUE(undefined || changed.count(left.name)) << "documented as left, but never changed: " << left.as;
        }
        for (const gl::Enum name : changed) EXPECT_TRUE(names.count(name)) << "changed, but not documented: " << name;
    }

    State after_;
};

TEST_F(HostState, IsAsItWasAfterADrawInGuardModeFullForEveryStrategy)
{
    const PosedModel posed = small_posed();
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(posed, options_of(strategy));
        const HostileHost hostile(*host_);
        const std::vector<std::string> changed = changed_by_draw(*renderer, list_of(posed, whole_view(posed)));
        for (const std::string &name : changed) ADD_FAILURE() << name << " is now " << text_of(after_.at(name));
        SetUp();
    }
}

TEST_F(HostState, IsAsItWasAfterATemplateWasPreparedAndAfterTheRendererWasDestroyed)
{
    const PosedModel posed = small_posed();
    const HostileHost hostile(*host_);
    const State before = dump_state(*host_);
    const auto renderer = make_renderer_of(posed);
    EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
    renderer->destroy();
    EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
}

TEST_F(HostState, IsLeftExactlyAsDocumentedInGuardModeMinimal)
{
    expect_documented(names_changed(Guard::minimal),
                      {std::begin(passes::left_by_minimal), std::end(passes::left_by_minimal)});
}

TEST_F(HostState, IsLeftExactlyAsDocumentedInGuardModeNone)
{
    std::vector<Left> documented(std::begin(passes::left_by_minimal), std::end(passes::left_by_minimal));
    documented.insert(documented.end(), std::begin(passes::left_by_none), std::end(passes::left_by_none));
    expect_documented(names_changed(Guard::none), documented);
}

TEST_F(HostState, OfAHostileHostDoesNotSpoilThePicture)
{
    const PosedModel posed = small_posed();
    const Camera camera = whole_view(posed);
    for (const passes::Strategy strategy : all_strategies)
        for (const Guard guard : {Guard::full, Guard::minimal, Guard::none}) {
            const auto renderer = make_renderer_of(posed, options_of(strategy, guard));
            const Picture calm = draw(*context_, *renderer, list_of(posed, camera));
            renderer->destroy();
            SetUp();
            const HostileHost hostile(*host_);
            const auto again = make_renderer_of(posed, options_of(strategy, guard));
            EXPECT_EQ(draw(*context_, *again, list_of(posed, camera)), calm) << int(strategy) << " " << int(guard);
            SetUp();
        }
}

TEST_F(HostState, OfEdgeFlagsLeftOnDoesNotSpoilAWireframe)
{
    const PosedModel posed = small_posed();
    const auto renderer = make_renderer_of(posed);
    constexpr gl::Enum line = 0x1B01;
    host_->PolygonMode(gl::front_and_back, line);
    const Picture calm = draw(*context_, *renderer, list_of(posed, whole_view(posed)));
    const std::vector<uint8_t> no_edges(posed.tmpl->levels[0].vertex_count, 0);
    host_->ask<void (*)(int32_t, const void *)>("glEdgeFlagPointer")(1, no_edges.data());
    host_->EnableClientState(gl::edge_flag_array);
    EXPECT_EQ(draw(*context_, *renderer, list_of(posed, whole_view(posed))), calm);
}

// Colours must reach the materials whatever colour-material mode the host set; emission and highlights stay the host's.
TEST_F(HostState, OfAHostileHostDoesNotSpoilThePictureUnderLight)
{
    const PosedModel posed = small_posed();
    const Camera camera = whole_view(posed);
    const auto light_up = [&] {
        const float direction[4] = {0.3f, 0.5f, 0.8f, 0}, none[4] = {0, 0, 0, 1}, dim[4] = {0.2f, 0.2f, 0.2f, 1};
        host_->Disable(gl::colour_material);
        for (const gl::Enum name : {0x1202u, 0x1600u}) host_->Materialfv(gl::front_and_back, name, none);
        host_->LightModelfv(0x0B53, dim);
        host_->MatrixMode(gl::modelview);
        host_->LoadIdentity();
        host_->Lightfv(0x4000, 0x1203, direction);
        host_->Enable(0x4000);
        host_->Enable(0x0B50);
    };
    for (const passes::Strategy strategy : all_strategies) {
        light_up();
        const Picture calm = draw(*context_, *make_renderer_of(posed, options_of(strategy)), list_of(posed, camera));
        SetUp();
        const HostileHost hostile(*host_);
        light_up();
        host_->ColorMaterial(gl::back, 0x1600);  // GL_EMISSION
        host_->Enable(gl::colour_material);
        const auto renderer = make_renderer_of(posed, options_of(strategy));
        EXPECT_EQ(draw(*context_, *renderer, list_of(posed, camera)), calm) << int(strategy);
        SetUp();
    }
}

TEST_F(HostState, KeepsTheHostsRgbMaskAndNeverWritesAlpha)
{
    const PosedModel posed = small_posed();
    const auto renderer = make_renderer_of(posed);
    host_->Viewport(0, 0, width, height);
    host_->ColorMask(1, 0, 1, 1);
    const Picture picture = draw(*context_, *renderer, list_of(posed, whole_view(posed)));
    for (size_t i = 1; i < picture.size(); i += 3) ASSERT_EQ(picture[i], background[1]);
    std::vector<uint8_t> rgba(4 * width * height);
    host_->ask<void (*)(int, int, int, int, unsigned, unsigned, void *)>("glReadPixels")(
        0, 0, width, height, gl::rgba, gl::unsigned_byte, rgba.data());
    for (size_t i = 3; i < rgba.size(); i += 4) ASSERT_EQ(rgba[i], 255);
}

// A host that tracks what claque tracks: popping its attributes is not enough for Mesa 22.3.6.
TEST_F(HostState, OfMaterialsThatFollowColoursIsTheHostsOwn)
{
    const PosedModel posed = small_posed();
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(posed, options_of(strategy));
        host_->ColorMaterial(gl::front_and_back, gl::ambient_and_diffuse);
        host_->Enable(gl::colour_material);
        host_->Color4f(0.125f, 0.25f, 0.5f, 0.75f);
        for (const std::string &name : changed_by_draw(*renderer, list_of(posed, whole_view(posed))))
            ADD_FAILURE() << int(strategy) << ": " << name << " is now " << text_of(after_.at(name));
        SetUp();
    }
}

// Mesa's indirect GLX.
TEST_F(HostState, OfAnArrayThatGlForgetsToPopIsTheHostsOwn)
{
    const PosedModel posed = small_posed();
    for (const Guard guard : {Guard::full, Guard::minimal}) {
        Spy spy(*context_);
        spy.forgets_vertex_array = true;
        passes::Renderer renderer(std::pmr::get_default_resource(), options_of(passes::Strategy::fused, guard));
        ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        const double corners[6] = {0};
        constexpr gl::Enum of_doubles = 0x140A;
        host_->VertexPointer(2, of_doubles, 24, corners);
        const State before = dump_state(*host_);
        ASSERT_TRUE(renderer.draw(list_of(posed, whole_view(posed)), nullptr).ok());
        const State after = dump_state(*host_);
        for (const char *name :
             {"GL_VERTEX_ARRAY_SIZE", "GL_VERTEX_ARRAY_TYPE", "GL_VERTEX_ARRAY_STRIDE", "GL_VERTEX_ARRAY_POINTER"})
            EXPECT_EQ(before.at(name).values, after.at(name).values) << name << ", guard " << int(guard);
        renderer.destroy();
    }
}

// NVIDIA's driver 580.159.04.
TEST_F(HostState, OfSwitchesForSamplesThatGlForgetsToPopIsTheHostsOwn)
{
    constexpr gl::Enum switches[] = {gl::multisample, gl::sample_alpha_to_coverage, gl::sample_alpha_to_one};
    const PosedModel posed = small_posed();
    for (const bool on : {true, false}) {
        Spy spy(*context_);
        spy.forgets_samples = true;
        passes::Renderer renderer(std::pmr::get_default_resource(), options_of(passes::Strategy::fused));
        ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        for (const gl::Enum one : switches) on ? host_->Enable(one) : host_->Disable(one);
        ASSERT_TRUE(renderer.draw(list_of(posed, whole_view(posed)), nullptr).ok());
        for (const gl::Enum one : switches) EXPECT_EQ(host_->IsEnabled(one) != 0, on) << one;
        renderer.destroy();
    }
}

TEST_F(HostState, OfErrorsIsTheHostsOwn)
{
    constexpr gl::Enum invalid_enum = 0x0500;
    const PosedModel posed = small_posed();
    const HostileHost hostile(*host_);
    const auto renderer = make_renderer_of(posed);
    EXPECT_EQ(host_->GetError(), 0u) << "left by prepare";
    draw(*context_, *renderer, list_of(posed, whole_view(posed)));
    EXPECT_EQ(host_->GetError(), 0u) << "left by draw";
    host_->Enable(0xffff);
    draw(*context_, *renderer, list_of(posed, whole_view(posed)));
    EXPECT_EQ(host_->GetError(), invalid_enum) << "the host's pending error was cleared";
    EXPECT_EQ(host_->GetError(), 0u);
}

TEST_F(HostState, IsNotTouchedByAnEmptyListOrARefusal)
{
    const PosedModel posed = small_posed(), other = small_posed();
    for (const Guard guard : {Guard::full, Guard::none}) {
        const auto renderer = make_renderer_of(posed, options_of(passes::Strategy::fused, guard));
        const State before = dump_state(*host_);
        const claque::draw::DrawList empty(std::pmr::get_default_resource());
        EXPECT_TRUE(renderer->draw(empty, nullptr).ok());
        EXPECT_EQ(renderer->draw(list_of(other, whole_view(other)), nullptr).code, CLQ_ARGUMENT);
        EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
    }
}

}  // namespace
}  // namespace gltest
