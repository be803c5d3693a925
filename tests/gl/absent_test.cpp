// Skips for want of OpenGL: only a library that the loader does not find is a reason. What goes wrong with the library
// there is a failure.
#include "tests/gl/support/absent.h"

#include <gtest/gtest-spi.h>

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

}  // namespace
}  // namespace gltest
