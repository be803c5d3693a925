// What the shared libraries export and import: only clq_* out; no GL, no printing, no exit of ours in, and no function
// that rounds as the C library and the processor please.
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/patterns.h"

namespace
{

std::vector<std::string> lines_of(const std::string &command)
{
    std::vector<std::string> out;
    FILE *pipe = popen(command.c_str(), "r");
    if (!pipe) return out;
    char line[4096];
    while (std::fgets(line, sizeof line, pipe)) {
        std::string text = line;
        out.push_back(text.substr(0, text.find_last_not_of("\r\n") + 1));
    }
    pclose(pipe);
    return out;
}

std::vector<std::string> symbols(const char *library, const char *which)
{
    return lines_of(std::string("nm -D --without-symbol-versions ") + which + " -P " + library + " | cut -d' ' -f1,2");
}

bool forbidden(const std::string &name)
{
    static const std::string wrong =
        "(gl[A-Z].*|egl[A-Z].*|glX.*|OSMesa.*|printf|fprintf|vprintf|vfprintf|puts|fputs|putchar|"
        "fwrite|perror|exit|_exit|quick_exit|abort|system|rand|srand|time|gettimeofday|"
        "clock_gettime|pthread_create|"
        "(a?(sin|cos|tan)h?|sincos|atan2|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|[tl]gamma|erfc?)[fl]?"
        ")";
    return patterns::describes(wrong, name);
}

}  // namespace

TEST(Symbols, TheLibrariesExportTheCApiAndNothingElse)
{
    for (const char *library : {CLAQUE_LIBRARY, CLAQUE_ASSETS_LIBRARY, CLAQUE_STAGE_LIBRARY}) {
        const std::vector<std::string> names = symbols(library, "--defined-only");
        ASSERT_FALSE(names.empty()) << library;
        for (const std::string &name : names) EXPECT_EQ(name.rfind("clq_", 0), 0u) << name << " of " << library;
    }
}

TEST(Symbols, TheRunTimeLibrariesImportNoGlNoPrintingNoExitNoLibm)
{
    if (CLAQUE_INSTRUMENTED) GTEST_SKIP() << "sanitizers and coverage bring their own imports";
    for (const char *library : {CLAQUE_LIBRARY, CLAQUE_STAGE_LIBRARY}) {
        const std::vector<std::string> names = symbols(library, "--undefined-only");
        ASSERT_FALSE(names.empty());
        for (const std::string &line : names) {
            const std::string name = line.substr(0, line.find(' '));
            EXPECT_FALSE(forbidden(name)) << name << " of " << library;
        }
    }
    EXPECT_TRUE(forbidden("glBegin") && forbidden("printf") && forbidden("exit") && forbidden("sincosf"));
    EXPECT_FALSE(forbidden("snprintf") || forbidden("memcpy") || forbidden("fmod") || forbidden("sqrtf"));
}

TEST(Symbols, LibclaqueNeedsLibcAndLibstdcxxAlone)
{
    if (CLAQUE_INSTRUMENTED) GTEST_SKIP() << "sanitizers and coverage bring their own libraries";
    const std::string allowed = ".*NEEDED.*\\[(libc\\.so|libm\\.so|libstdc\\+\\+\\.so|libgcc_s\\.so|ld-linux).*";
    const std::vector<std::string> needed = lines_of(std::string("readelf -d ") + CLAQUE_LIBRARY + " | grep NEEDED");
    ASSERT_FALSE(needed.empty());
    for (const std::string &line : needed) EXPECT_TRUE(patterns::describes(allowed, line)) << line;
}
