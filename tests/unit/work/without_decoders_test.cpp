// A build without the decoders of compressed data says which one a file needs. It is linked with the rooms that are
// compiled without them, whichever the libraries have.
#include <gtest/gtest.h>

#include "../asset/maker.h"
#include "lib/asset/decoders.h"

namespace claque::testing
{
namespace
{

void expect_named(const Outcome &outcome, const char *extension, const char *library)
{
    EXPECT_EQ(outcome.status, CLQ_UNSUPPORTED);
    for (const char *words : {extension, library, "this libclaque-assets was built without any decoder"})
        EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
}

TEST(WithoutDecoders, NoneIsThere)
{
    for (const asset::Decoder decoder : {asset::Decoder::draco, asset::Decoder::meshopt, asset::Decoder::webp})
        EXPECT_FALSE(asset::has_decoder(decoder));
}

TEST(WithoutDecoders, AnExtensionThatAFileRequiresIsNamedWithItsDecoder)
{
    for (const auto &[extension, library] :
         {std::pair("KHR_draco_mesh_compression", "libdraco"), {"EXT_meshopt_compression", "libmeshoptimizer"}}) {
        Maker maker;
        maker.triangle();
        maker.json["extensionsRequired"] = {extension};
        expect_named(outcome_of(maker.glb()), extension, library);
    }
}

TEST(WithoutDecoders, APrimitiveByDracoIsNamedWithItsDecoder)
{
    Maker maker;
    maker.triangle();
    maker.json["accessors"][0].erase("bufferView");  // what is packed has no numbers of its own
    maker.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", maker.view(Bytes{'D', 'R', 'A', 'C', 'O'})}, {"attributes", {{"POSITION", 0}}}};
    expect_named(outcome_of(maker.glb()), "KHR_draco_mesh_compression", "libdraco");
}

TEST(WithoutDecoders, ATextureByWebpIsNamedWithItsDecoder)
{
    Maker maker;
    maker.triangle();
    maker.add("images", {{"bufferView", maker.view(Bytes{'R', 'I', 'F', 'F'})}, {"mimeType", "image/webp"}});
    maker.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    expect_named(outcome_of(maker.glb()), "EXT_texture_webp", "libwebp");
}

}  // namespace
}  // namespace claque::testing
