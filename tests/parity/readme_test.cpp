// Runs the commands of docs/parity.md, section "As a reference renderer", word for word; the gpu_peer of this build is
// the other renderer.
#include "tests/embed/readme.h"

#include <gtest/gtest.h>

#include "samples/contexts/offscreen.h"
#include "tests/embed/scratch.h"
#include "tests/gl/support/absent.h"

namespace
{

TEST(ReadmeParity, ShowsHowToCompareARendererWithClaque)
{
    std::string why;
    if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why))
        END_WITHOUT_CONTEXT(contexts::Kind::any, why);
    const Scratch folder;
    ASSERT_EQ(folder.run("mkdir build && ln -s '" CLAQUE_BUILD_DIR "' build/release").first, 0);
    int followed = 0;
    for (const Block &block : blocks_of(text_of_file(CLAQUE_SOURCE_DIR "/docs/parity.md"), "As a reference renderer")) {
        if (block.language != "sh") continue;
        ++followed;
        const auto [code, printed] = folder.run("export ASAN_OPTIONS=detect_leaks=0\n" + block.text);
        EXPECT_EQ(code, 0) << block.text << printed;
        EXPECT_NE(printed.find("yours passes gpu"), std::string::npos) << printed;
    }
    EXPECT_EQ(followed, 1);
    EXPECT_NE(text_of_file(folder.path() + "/parity.json").find("\"colour"), std::string::npos);
    EXPECT_NE(text_of_file(folder.path() + "/parity.html").find("<html"), std::string::npos);
}

}  // namespace
