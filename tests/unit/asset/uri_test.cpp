#include "lib/asset/uri.h"

#include <gtest/gtest.h>

#include "maker.h"

namespace claque::testing
{
namespace
{

Bytes decoded(const std::string &uri) { return asset::decode_data_uri(uri); }

TEST(DataUri, Base64OfEveryLengthIsDecoded)
{
    EXPECT_EQ(decoded("data:application/octet-stream;base64,"), Bytes());
    EXPECT_EQ(decoded("data:;base64,/w=="), Bytes{255});
    EXPECT_EQ(decoded("data:;base64,/+8="), (Bytes{255, 239}));
    EXPECT_EQ(decoded("data:;base64,AQID"), (Bytes{1, 2, 3}));
    EXPECT_EQ(decoded("data:;base64,AQIDBA=="), (Bytes{1, 2, 3, 4}));
    EXPECT_EQ(decoded("data:text/plain,a%20b+"), (Bytes{'a', ' ', 'b', '+'}));
}

TEST(DataUri, ThatIsNoBase64IsRefused)
{
    for (const char *body : {"A", "AA", "AAA", "A===", "====", "AA=A", "AA==AAAA", "AA A", "AA\nA", "AA-_", "`AAA"})
        EXPECT_EQ(outcome_of([&] { decoded(std::string("data:;base64,") + body); }).status, CLQ_FORMAT) << body;
    EXPECT_EQ(outcome_of([] { decoded("data:nothing"); }).status, CLQ_FORMAT);
    EXPECT_EQ(outcome_of([] { decoded("data:;;base64,AAAA"); }).status, CLQ_FORMAT);
}

TEST(DataUri, HoldsBuffersAndTheFileIsTheSameAsItsGlb)
{
    Maker maker;
    maker.triangle();
    const model::Model from_glb = load(maker.glb());
    maker.json["buffers"] =
        Json::array({{{"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"},
                      {"byteLength", 36}}});
    const model::Model from_text = load(maker.text());
    EXPECT_EQ(from_text.parts.at(0).positions, from_glb.parts.at(0).positions);
    EXPECT_EQ(from_text.parts[0].positions[1], glm::vec3(1, 0, 0));
}

}  // namespace
}  // namespace claque::testing
