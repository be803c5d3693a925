// Images that are no PNG or JPEG, that are cut off, or that would take too much are refused by name and number.
#include "lib/asset/image.h"

#include <gtest/gtest.h>

#include "png.h"

namespace claque::testing
{
namespace
{

using asset::ImageLimits;

Bytes grey(uint32_t width, uint32_t height) { return make_png(width, height, 8, Bytes(width + 1, 0), height); }

void image_refused(const Bytes &bytes, int status, const std::string &sentence, const ImageLimits &limits = {})
{
    const Outcome found = outcome_of([&] { asset::decode_image(bytes.data(), bytes.size(), "coat", limits); });
    EXPECT_EQ(found.status, status) << sentence;
    EXPECT_NE(found.text.find(sentence), std::string::npos) << found.text << "\nand not: " << sentence;
}

Bytes bytes_of(const std::string &text) { return Bytes(text.begin(), text.end()); }

TEST(Image, OfAnotherFormatIsRefusedByItsName)
{
    image_refused(bytes_of("\xabKTX 20\xbb\r\n\x1a\n"), CLQ_UNSUPPORTED, "image 'coat' is KTX: PNG and JPEG are read");
    image_refused(bytes_of("DDS |and more"), CLQ_UNSUPPORTED, "image 'coat' is DDS: PNG and JPEG are read");
    for (const char *text : {"", "GIF89a", "DDS", "RIFF....WAVE", "\xabKTX", "\x89PNG"})
        image_refused(bytes_of(text), CLQ_FORMAT, "bytes is neither PNG, JPEG nor WebP");
}

TEST(Image, WhoseChunksAreCutOffIsRefusedByTheChunk)
{
    const Bytes good = grey(3, 2);
    const model::Image read = asset::decode_image(good.data(), good.size(), "coat", {});
    EXPECT_EQ(read.width, 3u);
    EXPECT_EQ(read.height, 2u);
    const auto cut = [&](size_t size) { return Bytes(good.begin(), good.begin() + long(size)); };
    image_refused(cut(8), CLQ_FORMAT, "the PNG has no end");
    image_refused(cut(8 + 11), CLQ_FORMAT, "PNG chunk 0 is cut off");
    image_refused(cut(8 + 25 + 5), CLQ_FORMAT, "PNG chunk 1 is cut off");
    image_refused(cut(8 + 25), CLQ_FORMAT, "the PNG has no end");
    Bytes longer = good;
    longer[8 + 3] = 200;
    image_refused(longer, CLQ_FORMAT, "PNG chunk 0 says 200 bytes, ");
    longer = good;
    longer[longer.size() - 12 + 3] = 1;
    image_refused(longer, CLQ_FORMAT, "PNG chunk 2 says 1 bytes, 0 are left");
    Bytes empty = good;
    for (size_t i = 16; i < 24; ++i) empty[i] = 0;
    image_refused(empty, CLQ_FORMAT, "its header is broken");
}

TEST(Image, ThatWouldTakeTooMuchIsRefusedByItsSize)
{
    ImageLimits limits;
    limits.max_px = 8;
    image_refused(grey(9, 1), CLQ_LIMIT, "image 'coat' is 9 x 1: at most 8 pixels a side are read", limits);
    image_refused(grey(1, 9), CLQ_LIMIT, "image 'coat' is 1 x 9: at most 8 pixels a side are read", limits);
    limits.max_bytes = 4 * 8 * 8 - 1;
    image_refused(grey(8, 8), CLQ_LIMIT, "of 8 x 8 would take 256 bytes: 255 are left of the limit", limits);
    limits.max_bytes = 4 * 8 * 8;
    const Bytes all = grey(8, 8);
    EXPECT_EQ(asset::decode_image(all.data(), all.size(), "coat", limits).rgba.size(), 256u);
    Bytes claims = grey(8, 8);
    claims[18] = claims[22] = 0x20;  // 8200 x 8200
    image_refused(claims, CLQ_LIMIT, "says 8200 x 8200 pixels in ");
}

// A picture of 4096 x 4096 may be all of one colour; a larger one has a byte for each 256 pixels.
TEST(Image, ThatSaysMorePixelsThanItsBytesCanHoldIsNotBelieved)
{
    ImageLimits limits;
    limits.max_bytes = 0;
    const char *const believed = " would take ", *const not_believed = "pixels in ";
    Bytes claims = grey(8, 8);
    claims[18] = claims[22] = 0x10, claims[19] = claims[23] = 0;
    image_refused(claims, CLQ_LIMIT, believed, limits);
    claims[23] = 1;  // 4096 x 4097
    image_refused(claims, CLQ_LIMIT, not_believed, limits);
    claims.resize(4097 * 16 - 1);  // behind its end
    image_refused(claims, CLQ_LIMIT, not_believed, limits);
    claims.push_back(0);
    image_refused(claims, CLQ_LIMIT, believed, limits);
}

}  // namespace
}  // namespace claque::testing
