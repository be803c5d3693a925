// What samples/hello.c left: a picture with people in it.
#include <fstream>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/gl/support/absent.h"

TEST(Hello, ThePictureShowsAColouredCrowd)
{
    std::ifstream file(HELLO_PICTURE, std::ios::binary);
    if (const std::string absent = gltest::absent_gl(contexts::Kind::any); !file && !absent.empty())
        GTEST_SKIP() << absent;
    ASSERT_TRUE(file) << "samples/hello.c left no " HELLO_PICTURE;
    std::string magic;
    int width = 0, height = 0, most = 0;
    file >> magic >> width >> height >> most;
    file.get();
    ASSERT_EQ(magic, "P6");
    std::vector<unsigned char> rgb(3u * width * height);
    file.read(reinterpret_cast<char *>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
    ASSERT_EQ(static_cast<size_t>(file.gcount()), rgb.size());
    std::set<unsigned> colours;
    int people = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) {
        colours.insert(rgb[i] << 16 | rgb[i + 1] << 8 | rgb[i + 2]);
        people += !(rgb[i] == rgb[0] && rgb[i + 1] == rgb[1] && rgb[i + 2] == rgb[2]);
    }
    EXPECT_GT(people, width * height / 5) << "a crowd covers at least a fifth of this picture";
    EXPECT_LT(people, width * height * 9 / 10);
    EXPECT_GT(colours.size(), 1000u) << "individuals have colours of their own";
}
