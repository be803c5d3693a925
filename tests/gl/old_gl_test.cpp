// claque on a GL that knows version 1.1 and nothing else: the calls it makes.
#include <cstdlib>
#include <fstream>

#include "tests/gl/support/checked.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/jointed.h"

namespace gltest
{
namespace
{

class OpenGl11 : public HooksTest
{
protected:
    void SetUp() override
    {
        HooksTest::SetUp();
        if (!context_) return;
        if (!std::ifstream("/usr/include/GL/gl.h")) GTEST_SKIP() << "no /usr/include/GL/gl.h to read the names from";
        ASSERT_GT(values_of_gl_1_1().size(), 300u) << "/usr/include/GL/gl.h was not read";
        spy_ = std::make_unique<Spy>(*context_);
        checked_ = std::make_unique<Checked>(*spy_);
    }

    // A renderer's whole life.
    void live(const passes::RendererOptions &options, const PosedModel &posed, const std::vector<DrawList> &lists)
    {
        passes::Renderer renderer(std::pmr::get_default_resource(), options);
        ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy_->user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        for (const DrawList &list : lists) ASSERT_TRUE(renderer.draw(list, nullptr).ok());
        renderer.destroy();
    }
    template <class Function>
    Function call(const char *name)
    {
        return reinterpret_cast<Function>(Spy::get_proc_address(spy_->user(), name));
    }
    void expect_no_offence() const
    {
        for (const std::string &offence : checked_->offences) ADD_FAILURE() << offence;
        EXPECT_GT(checked_->calls, 100u);
    }

    std::unique_ptr<Spy> spy_;
    std::unique_ptr<Checked> checked_;
};

TEST_F(OpenGl11, IsAskedForNothingThatItDoesNotKnow)
{
    const Callbacks nothing([] { return 0; }, [] {});
    for (const passes::Strategy strategy : all_strategies)
        for (const passes::Guard guard : {passes::Guard::full, passes::Guard::minimal, passes::Guard::none})
            for (const passes::ColourFormat format : {passes::ColourFormat::ubyte, passes::ColourFormat::real}) {
                passes::RendererOptions options = options_of(strategy, guard);
                options.colours = format;
                live(options, posed_, {list_of(posed_, whole_view(posed_)), trio(nothing)});
            }
    expect_no_offence();
}

TEST_F(OpenGl11, HasStacksDeepEnoughForAnyTree)
{
    const Jointed jointed = make_jointed(rope(48), torture_map(128, 2, 64));
    for (const passes::Guard guard : {passes::Guard::full, passes::Guard::none})
        live(options_of(passes::Strategy::fused, guard), jointed.posed,
             {by_matrices(jointed, whole_view(jointed.posed))});
    expect_no_offence();
}

// The tests above can fail.
TEST_F(OpenGl11, DetectsCallsThatItDoesNotKnow)
{
    call<void (*)(gl::Enum)>("glEnable")(0x806F);                                            // GL_TEXTURE_3D
    call<void (*)(gl::Enum, gl::Enum, int32_t)>("glTexParameteri")(0x0DE1, 0x2802, 0x812F);  // GL_CLAMP_TO_EDGE
    const std::vector<uint8_t> texels(4 * 100 * 64);
    call<void (*)(gl::Enum, int32_t, int32_t, int32_t, int32_t, int32_t, gl::Enum, gl::Enum, const void *)>(
        "glTexImage2D")(gl::texture_2d, 0, int32_t(gl::rgba8), 100, 64, 0, gl::rgba, gl::unsigned_byte, texels.data());
    call<void (*)(gl::Enum)>("glMatrixMode")(gl::projection);
    for (int i = 0; i < 2; ++i) call<void (*)()>("glPushMatrix")();
    call<void (*)(gl::Bits)>("glPushAttrib")(0x20000000);  // GL_MULTISAMPLE_BIT
    const std::vector<std::string> expected = {"glEnable of 0x806F", "glTexParameteri of 0x812F",
                                               "a texture of 100 x 64", "glPushMatrix to 3 of 0x1701",
                                               "glPushAttrib of 0x20000000"};
    EXPECT_EQ(checked_->offences, expected);
}

// If the environment asks for such a GL, as it does for some tests of this folder.
TEST_F(OpenGl11, IsReportedByMesaOnRequest)
{
    const char *asked = std::getenv("MESA_GL_VERSION_OVERRIDE");
    if (!asked) GTEST_SKIP() << "MESA_GL_VERSION_OVERRIDE is not set";
    const std::string version = reinterpret_cast<const char *>(host_->GetString(gl::version));
    const std::string extensions = reinterpret_cast<const char *>(host_->GetString(gl::extensions));
    EXPECT_EQ(version.substr(0, 3), asked);
    for (const char *newer : {"multitexture", "vertex_buffer_object", "texture_non_power_of_two", "shader_objects"})
        EXPECT_EQ(extensions.find(newer), std::string::npos) << extensions;
}

}  // namespace
}  // namespace gltest
