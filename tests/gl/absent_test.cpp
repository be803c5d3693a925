// Skips for want of OpenGL: only a library that the loader does not find is a reason, or an extension that GL's list
// does not name. What goes wrong with the library there is a failure.
#include "tests/gl/support/absent.h"

#include <gtest/gtest-spi.h>

#include "tests/gl/support/absent_extension.h"

namespace gltest
{
namespace
{

TEST(AbsentGl, ALibraryThatIsInstalledCanBeLoadedAndOneThatIsNotCannot)
{
    EXPECT_TRUE(can_load("libc.so.6"));
    EXPECT_FALSE(can_load("libclaque-is-not-there.so.1"));
}

TEST(AbsentGl, IsNamedExactlyWhereNoneOfItsLibrariesIsThere)
{
    const bool osmesa = can_load("libOSMesa.so.8") || can_load("libOSMesa.so.6") || can_load("libOSMesa.so");
    const bool egl = can_load("libEGL.so.1") && can_load("libEGL_mesa.so.0");
    EXPECT_EQ(absent_gl(contexts::Kind::osmesa), osmesa ? "" : "libOSMesa.so.8 is not installed");
    EXPECT_EQ(absent_gl(contexts::Kind::egl), egl ? "" : "libEGL.so.1 and libEGL_mesa.so.0 are not both installed");
    if (contexts::kind_of_environment() == contexts::Kind::any) {
        EXPECT_EQ(absent_gl(contexts::Kind::any).empty(), osmesa || egl);
    }
}

void end_without_context() { END_WITHOUT_CONTEXT(contexts::Kind::any, "its driver crashed"); }

TEST(AbsentGl, AContextThatCannotBeMadeAlthoughItsLibraryIsThereIsAFailure)
{
    if (const std::string absent = absent_gl(contexts::Kind::any); !absent.empty()) GTEST_SKIP() << absent;
    EXPECT_FATAL_FAILURE(end_without_context(), "its driver crashed");
}

TEST(AbsentExtension, IsOneThatGlsWholeListDoesNotName)
{
    const auto find = [](const char *list, const char *version, bool is_limited) {
        return find_extension("GL_EXT_one", list, version, is_limited);
    };
    EXPECT_TRUE(find("GL_EXT_two GL_EXT_one", "2.1", false).is_there);
    EXPECT_FALSE(find("GL_EXT_one_more NGL_EXT_one", "2.1", false).is_there) << "a part of a name is no name";
    const AskedExtension absent = find("GL_EXT_two", "2.1 Other", false);
    EXPECT_TRUE(!absent.is_there && absent.may_be_absent);
    EXPECT_EQ(absent.why, "GL 2.1 Other does not name GL_EXT_one");
    EXPECT_TRUE(find("", "1.1 Mesa 20", true).may_be_absent) << "a Mesa that is limited to old ones";
}

TEST(AbsentExtension, IsAFailureWhereMesaIsNotLimitedOrGlSaysNothing)
{
    for (const auto &[list, version] : {std::pair<const char *, const char *>{"GL_EXT_two", "4.5 Mesa 22.3.6"},
                                        {nullptr, "2.1"},
                                        {"GL_EXT_two", nullptr}}) {
        const AskedExtension wrong = find_extension("GL_EXT_one", list, version, !list || !version);
        EXPECT_FALSE(wrong.is_there || wrong.may_be_absent) << wrong.why;
        EXPECT_FALSE(wrong.why.empty());
    }
}

}  // namespace
}  // namespace gltest
