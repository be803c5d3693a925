// The binary interface of the shared libraries, as tests/abi/*.abi lists it: soname, exports, what is needed and
// imported.
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace
{

std::set<std::string> lines_of(std::istream &text)
{
    std::set<std::string> lines;
    std::string line;
    while (std::getline(text, line)) lines.insert(line);
    return lines;
}

std::set<std::string> interface_of(const std::string &library)
{
    FILE *pipe = popen(("'" CLAQUE_SOURCE_DIR "/tests/abi/list.sh' '" + library + "'").c_str(), "r");
    std::stringstream said;
    char some[4096];
    while (const size_t n = pipe ? std::fread(some, 1, sizeof some, pipe) : 0) said.write(some, static_cast<long>(n));
    EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << library;
    return lines_of(said);
}

// What a compiler leaves to be imported is its own affair, and so is what sanitizers bring. A build without a decoder
// needs less.
bool held_here(const std::string &line)
{
    return CLAQUE_ABI_COMPILER || line.rfind("exports ", 0) == 0 || line.rfind("soname ", 0) == 0;
}

void expect_as_listed(const std::string &file, const std::string &library)
{
    std::ifstream text(std::string(CLAQUE_SOURCE_DIR "/tests/abi/") + file);
    const std::set<std::string> listed = lines_of(text), found = interface_of(library);
    ASSERT_GT(listed.size(), 40u) << file;
    for (const std::string &line : listed)
        EXPECT_TRUE(!held_here(line) || found.count(line)) << file << " has, but the library has not: " << line;
    for (const std::string &line : found)
        EXPECT_TRUE(!held_here(line) || listed.count(line)) << file << " has not, but the library has: " << line;
    if (testing::Test::HasFailure())
        std::puts("If that is meant: make abi-accept, and a new soname where an export is gone or changed.");
}

TEST(Abi, OfLibclaqueIsTheOneThatIsListed) { expect_as_listed("libclaque.abi", CLAQUE_LIBRARY); }
TEST(Abi, OfLibclaqueAssetsIsTheOneThatIsListed) { expect_as_listed("libclaque-assets.abi", CLAQUE_ASSETS_LIBRARY); }
TEST(Abi, OfLibclaqueStageIsTheOneThatIsListed) { expect_as_listed("libclaque-stage.abi", CLAQUE_STAGE_LIBRARY); }

}  // namespace
