// Damaged JPEG pictures: tables that say more than the decoder has room for, scans that leave coefficients out.
#include <fstream>
#include <functional>
#include <iterator>
#include <malloc.h>

#include <gtest/gtest.h>

#include "lib/asset/image.h"
#include "maker.h"

namespace claque::testing
{
namespace
{

// A table segment with this many codes of each length from 1 to 16, and its values.
Bytes tables(const std::vector<Bytes> &counts)
{
    Bytes body;
    for (const Bytes &each : counts) {
        size_t codes = 0;
        for (const uint8_t count : each) codes += count;
        body.push_back(0x13);
        body.insert(body.end(), each.begin(), each.end());
        body.insert(body.end(), codes, uint8_t(7));
    }
    const size_t length = body.size() + 2;
    Bytes out = {0xff, 0xc4, static_cast<uint8_t>(length >> 8), static_cast<uint8_t>(length)};
    out.insert(out.end(), body.begin(), body.end());
    return out;
}

// Bytes between the beginning of a picture and a header that cannot be read.
std::string refusal_of(const Bytes &middle)
{
    Bytes file = {0xff, 0xd8};
    file.insert(file.end(), middle.begin(), middle.end());
    file.insert(file.end(), {0xff, 0xc0, 0, 3, 8, 0, 0, 0});
    return outcome_of([&] { asset::decode_image(file.data(), file.size(), "face", asset::ImageLimits()); }).text;
}

Bytes counts(uint8_t last, uint8_t before_last)
{
    Bytes out(16, 0);
    out[15] = last, out[14] = before_last;
    return out;
}

TEST(Jpeg, ATableWithMoreCodesThanItsDecoderHoldsIsRefused)
{
    const auto has_many = [](const std::string &text) { return text.find("257 codes") != std::string::npos; };
    EXPECT_EQ(refusal_of(tables({counts(255, 1)})).find("Huffman"), std::string::npos) << "256 are legal";
    EXPECT_TRUE(has_many(refusal_of(tables({counts(255, 2)}))));
    EXPECT_TRUE(has_many(refusal_of(tables({counts(9, 0), counts(255, 2)})))) << "the second table of a segment";
    Bytes beyond = tables({counts(255, 2)});
    beyond[2] = 0, beyond[3] = 3;
    EXPECT_TRUE(has_many(refusal_of(beyond))) << "a table that leaves its segment";
    Bytes padded = {0xff, 0xfe, 0, 2, 0x11, 0xff, 0xff};
    const Bytes table = tables({counts(255, 2)});
    padded.insert(padded.end(), table.begin() + 1, table.end());
    EXPECT_TRUE(has_many(refusal_of(padded))) << "behind padding";
    Bytes comment = {0xff, 0xfe, 2, 0};
    comment.insert(comment.end(), table.begin(), table.end());
    comment.resize(4 + 0x200 - 2);
    EXPECT_FALSE(has_many(refusal_of(comment))) << "a comment may hold anything";
    // Markers without a segment: the next one stands right behind them.
    for (const uint8_t alone : {0x00, 0xd0, 0xd7, 0xd8}) {
        Bytes behind = {0xff, alone};
        behind.insert(behind.end(), table.begin(), table.end());
        EXPECT_TRUE(has_many(refusal_of(behind))) << int(alone);
    }
    for (const uint8_t with_segment : {0x01, 0xcf, 0xda, 0xfe}) {
        Bytes within = comment;
        within[1] = with_segment;
        EXPECT_FALSE(has_many(refusal_of(within))) << int(with_segment);
    }
    Bytes ended = {0xff, 0xd9, 0, 2}, unmarked = {0xff, 0};
    ended.insert(ended.end(), table.begin(), table.end());
    EXPECT_FALSE(has_many(refusal_of(ended))) << "behind the end";
    unmarked.insert(unmarked.end(), table.begin() + 1, table.end());
    EXPECT_FALSE(has_many(refusal_of(unmarked))) << "compressed data";
    // A segment without a length, or of none, hides nothing.
    for (const uint8_t length : {0, 1}) {
        Bytes empty = {0xff, 0xfe, 0, length};
        empty.insert(empty.end(), table.begin(), table.end());
        EXPECT_TRUE(has_many(refusal_of(empty))) << int(length);
    }
}

TEST(Jpeg, ThatEndsAnywhereInATableIsReadToItsEnd)
{
    Bytes whole = {0xff, 0xd8};
    const Bytes table = tables({counts(255, 2)});
    whole.insert(whole.end(), table.begin(), table.end());
    for (size_t size = 3; size <= whole.size(); ++size) {
        const Bytes file(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        const Outcome found =
            outcome_of([&] { asset::decode_image(file.data(), file.size(), "face", asset::ImageLimits()); });
        EXPECT_EQ(found.status, CLQ_FORMAT) << size << ": " << found.text;
        // The codes of all lengths are there.
        EXPECT_EQ(found.text.find("257 codes") != std::string::npos, size >= 2 + 4 + 17) << size << ": " << found.text;
    }
}

TEST(Jpeg, OfMoreThan100ScansIsRefused)
{
    const auto scans = [](int count, uint8_t before) {
        Bytes out = {0xff, before};
        for (int i = 0; i < count; ++i) out.insert(out.end(), {0xff, 0xda, 0, 2, 7});
        return refusal_of(out);
    };
    EXPECT_EQ(scans(100, 0xd8).find("scans"), std::string::npos);
    EXPECT_NE(scans(101, 0xd8).find("image 'face': the JPEG has 101 scans, 100 are read"), std::string::npos);
    EXPECT_EQ(scans(101, 0xd9).find("scans"), std::string::npos) << "behind the end";
}

TEST(JpegScans, ThatLeaveCoefficientsOutShowTheSameWhateverMemoryHeld)
{
    std::ifstream file(CLAQUE_SOURCE_DIR "/tests/fuzz/corpus/image/found-scan-without-coefficients", std::ios::binary);
    const Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ASSERT_GT(bytes.size(), 100u);
    const auto pixels_after = [&](int fill) {
        mallopt(M_PERTURB, fill);  // new blocks hold this byte's complement
        const model::Image image = asset::decode_image(bytes.data(), bytes.size(), "face", asset::ImageLimits());
        mallopt(M_PERTURB, 0);
        return image.rgba;
    };
    const auto once = pixels_after(0x35);
    EXPECT_FALSE(once.empty());
    EXPECT_TRUE(once == pixels_after(0xc2));
}

}  // namespace
}  // namespace claque::testing
