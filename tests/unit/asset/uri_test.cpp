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

TEST(RelativeUri, IsAPathBesideTheFileOrRefusedByItsRule)
{
    EXPECT_EQ(asset::decode_relative_path("a%2Fb/c%C3%9f.bin"), "a/b/c\xc3\x9f.bin");
    EXPECT_EQ(asset::decode_relative_path("a/b:c"), "a/b:c") << "a colon behind a slash is no scheme";
    EXPECT_EQ(asset::decode_relative_path("%61%2e%62"), "a.b") << "codes at both ends";
    const std::string_view behind = "a%2f";
    EXPECT_EQ(outcome_of([&] { asset::decode_relative_path(behind.substr(0, 3)); }).status, CLQ_FORMAT)
        << "what stands behind the text is no part of it";
    const struct {
        const char *uri;
        int status;
        const char *sentence;
    } all[] = {{":a", CLQ_FORMAT, "URI ':a' has an empty scheme"},
               {"http://a/b", CLQ_UNSUPPORTED, "only data URIs and files beside this one are read"},
               {"c:b", CLQ_UNSUPPORTED, "only data URIs and files beside this one are read"},
               {"", CLQ_FORMAT, "a URI is empty"},
               {"/a", CLQ_FORMAT, "is an absolute path"},
               {"%2fa", CLQ_FORMAT, "is an absolute path"},
               {"a\\b", CLQ_FORMAT, "has a backslash or control character"},
               {"a%5cb", CLQ_FORMAT, "has a backslash or control character"},
               {"a%00b", CLQ_FORMAT, "has a backslash or control character"},
               {"a%7Fb", CLQ_FORMAT, "has a backslash or control character"},
               {"a/../b", CLQ_FORMAT, "leaves the folder"},
               {"a%2", CLQ_FORMAT, "has a broken percent code"},
               {"a%g0", CLQ_FORMAT, "has a broken percent code"},
               {"a%0g", CLQ_FORMAT, "has a broken percent code"}};
    for (const auto &one : all) {
        const Outcome found = outcome_of([&] { asset::decode_relative_path(one.uri); });
        EXPECT_EQ(found.status, one.status) << one.uri;
        EXPECT_NE(found.text.find(one.sentence), std::string::npos) << found.text;
    }
}

}  // namespace
}  // namespace claque::testing
