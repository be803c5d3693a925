// The GL functions that claque loads and calls: those of GL 1.1 only, no redundant calls, none after a lost context.
#include <fstream>
#include <set>

#include "tests/gl/support/fixture.h"
#include "tests/gl/support/spy.h"
#include "tests/support/patterns.h"

namespace gltest
{
namespace
{

class Calls : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (context_) spy_ = std::make_unique<Spy>(*context_);
    }
    Status open(passes::Renderer &renderer) { return renderer.open(Spy::get_proc_address, spy_->user()); }

    std::unique_ptr<Spy> spy_;
};

std::unique_ptr<passes::Renderer> fresh(const passes::RendererOptions &options = {})
{
    return std::make_unique<passes::Renderer>(std::pmr::get_default_resource(), options);
}

// In Mesa's header every name of GL 1.1 stands above the first function of 1.2.
std::set<std::string> names_of_gl_1_1()
{
    std::ifstream file("/usr/include/GL/gl.h");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::string first = text.substr(0, text.find("OpenGL 1.2"));
    std::set<std::string> names;
    for (const patterns::Match &found : patterns::matches("GLAPI.*GLAPIENTRY\\s+(gl\\w+)", first))
        names.insert(found[1]);
    return names;
}

TEST_F(Calls, AskForNamesOfGl11Alone)
{
    if (!std::ifstream("/usr/include/GL/gl.h")) GTEST_SKIP() << "no /usr/include/GL/gl.h to read the names from";
    const std::set<std::string> names = names_of_gl_1_1();
    ASSERT_EQ(names.size(), 336u);
    const auto renderer = fresh();
    ASSERT_TRUE(open(*renderer).ok());
    EXPECT_GT(spy_->asked.size(), 30u);
    for (const std::string &name : spy_->asked) EXPECT_TRUE(names.count(name)) << name;
}

TEST_F(Calls, NameEachFunctionThatIsMissing)
{
    ASSERT_TRUE(open(*fresh()).ok());
    const std::vector<std::string> names = spy_->asked;
    for (const std::string &name : names) {
        spy_->refuse = name;
        const auto renderer = fresh();
        spy_->reset();
        const Status status = open(*renderer);
        EXPECT_EQ(status.code, CLQ_GL_MISSING);
        EXPECT_NE(std::string(status.text).find(name + ","), std::string::npos) << status.text;
        EXPECT_EQ(spy_->call_count(), 0u);
        const PosedModel posed = small_posed();
        EXPECT_EQ(renderer->prepare(*posed.tmpl).code, CLQ_GL_MISSING);
        EXPECT_EQ(renderer->draw(list_of(posed, whole_view(posed)), nullptr).code, CLQ_GL_MISSING);
    }
}

TEST_F(Calls, MakeNoObjectAndAskForNoErrorInADraw)
{
    const PosedModel posed = small_posed();
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = fresh(options_of(strategy));
        ASSERT_TRUE(open(*renderer).ok());
        ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
        spy_->reset();
        draw(*context_, *renderer, list_of(posed, whole_view(posed)));
        for (const char *name : {"glGenTextures", "glTexImage2D", "glDeleteTextures", "glTexParameteri"})
            EXPECT_EQ(spy_->calls[name], 0u) << name;
        EXPECT_EQ(spy_->calls["glPushAttrib"], spy_->calls["glPopAttrib"]);
        EXPECT_EQ(spy_->calls["glPushClientAttrib"], spy_->calls["glPopClientAttrib"]);
        renderer->destroy();
    }
    for (const std::string &name : spy_->asked) EXPECT_NE(name, "glGetError");
}

TEST_F(Calls, AreAsManyDrawsAsTheStatisticsSay)
{
    const PosedModel posed = small_posed();
    const model::Surface &surface = posed.tmpl->levels[0].surfaces[0];
    const size_t expected[] = {1, surface.clean.size() + surface.dirty_by_zone.size(), surface.clean.size() + 8};
    uint32_t once = surface.dirty.count;
    for (const model::Bin &bin : surface.clean) once += bin.range.count;
    EXPECT_EQ(once / 3, 162u);
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = fresh(options_of(strategy));
        ASSERT_TRUE(open(*renderer).ok());
        ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
        spy_->reset();
        passes::DrawStats stats;
        ASSERT_TRUE(renderer->draw(list_of(posed, whole_view(posed)), &stats).ok());
        EXPECT_EQ(stats.draws, spy_->calls["glDrawElements"]);
        EXPECT_EQ(stats.draws, expected[size_t(strategy)]);
        EXPECT_EQ(stats.individuals, 1u);
        EXPECT_GE(stats.triangles, once / 3);
    }
}

// As often as requested, by triangle count, and never by default; the picture is the same.
TEST_F(Calls, FlushAfterSoManyTriangles)
{
    const PosedModel posed = small_posed();
    const Camera view = whole_view(posed);
    const std::vector<Individual> five(5, individual_of(posed, view, nullptr));
    const claque::draw::DrawList list = list_of(five, view.projection);
    Picture expected;
    uint32_t one = 0;
    constexpr uint32_t never = 1u << 20;
    for (const uint32_t individuals : {0u, 1u, 2u, 5u, never}) {
        passes::RendererOptions options;
        options.flush_triangles = individuals == never ? never : individuals * one;
        const auto renderer = fresh(options);
        ASSERT_TRUE(open(*renderer).ok());
        ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
        const Picture shown = draw(*context_, *renderer, list);
        if (individuals == 0) expected = shown;
        EXPECT_TRUE(shown == expected) << individuals;
        passes::DrawStats stats;
        spy_->reset();
        ASSERT_TRUE(renderer->draw(list, &stats).ok());
        if (individuals == 0) one = stats.triangles / 5;
        const uint32_t expected_flushes = individuals == 0 || individuals == never ? 0 : 5 / individuals;
        EXPECT_EQ(spy_->calls["glFlush"], expected_flushes) << individuals;
        renderer->destroy();
    }
}

TEST_F(Calls, UploadATemplateOnlyOnce)
{
    const PosedModel posed = small_posed();
    const auto renderer = fresh();
    ASSERT_TRUE(open(*renderer).ok());
    ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
    spy_->reset();
    ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
    EXPECT_EQ(spy_->call_count(), 0u);
}

TEST_F(Calls, AreNoneAfterTheContextWasLost)
{
    const PosedModel posed = small_posed();
    {
        const auto renderer = fresh();
        ASSERT_TRUE(open(*renderer).ok());
        ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
        spy_->reset();
        renderer->abandon();
        EXPECT_EQ(renderer->draw(list_of(posed, whole_view(posed)), nullptr).code, CLQ_GL_MISSING);
        renderer->destroy();
    }
    EXPECT_EQ(spy_->call_count(), 0u);
}

TEST_F(Calls, OfANewRendererAfterALossGiveTheSamePicture)
{
    const PosedModel posed = small_posed();
    const claque::draw::DrawList list = list_of(posed, whole_view(posed));
    const auto renderer = make_renderer_of(posed);
    const Picture before = draw(*context_, *renderer, list);
    renderer->abandon();
    GlTest::SetUp();
    ASSERT_TRUE(renderer->open(context_->get_proc_address(), context_->user()).ok());
    ASSERT_TRUE(renderer->prepare(*posed.tmpl).ok());
    EXPECT_EQ(draw(*context_, *renderer, list), before);
}

TEST_F(Calls, LeaveNoTextureBehindInAHundredLives)
{
    const PosedModel posed = small_posed();
    for (int life = 0; life < 100; ++life) {
        const auto renderer = make_renderer_of(posed);
        renderer->draw(list_of(posed, whole_view(posed)), nullptr);
        renderer->destroy();
    }
    for (uint32_t name = 1; name < 1000; ++name) EXPECT_FALSE(host_->IsTexture(name)) << name;
}

}  // namespace
}  // namespace gltest
