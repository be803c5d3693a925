// EXT_texture_webp, by pictures that libwebp's encoder packs here.
#ifdef CLAQUE_HAS_WEBP
#include <webp/encode.h>
#endif

#include "decoder_test.h"

namespace claque::testing
{
namespace
{

// The triangle with a texture whose only picture is these bytes.
Maker webp_textured(const Bytes &picture)
{
    Maker maker;
    maker.triangle();
    maker.add("images", {{"bufferView", maker.view(picture)}, {"mimeType", "image/webp"}});
    maker.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    maker.json["extensionsRequired"] = {"EXT_texture_webp"};
    return maker;
}

#ifdef CLAQUE_HAS_WEBP

constexpr uint32_t wide = 37, high = 21;

Bytes pixels()
{
    Bytes out;
    for (uint32_t i = 0; i < wide * high; ++i)
        for (const uint32_t value : {7 * i, i / wide * 11, i % 13 * 19, 255u})
            out.push_back(static_cast<uint8_t>(value));
    return out;
}

Bytes lossless()
{
    uint8_t *made = nullptr;
    const size_t size = WebPEncodeLosslessRGBA(pixels().data(), wide, high, 4 * wide, &made);
    const Bytes out(made, made + size);
    WebPFree(made);
    return out;
}

Bytes lossy()
{
    uint8_t *made = nullptr;
    const size_t size = WebPEncodeRGBA(pixels().data(), wide, high, 4 * wide, 80, &made);
    const Bytes out(made, made + size);
    WebPFree(made);
    return out;
}

TEST(Webp, PicturesAreWhatWasPacked)
{
    const model::Model model = load(webp_textured(lossless()).glb());
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].width, wide);
    EXPECT_EQ(model.images[0].height, high);
    EXPECT_EQ(model.images[0].rgba, pixels());
    EXPECT_EQ(load(webp_textured(lossy()).glb()).images.at(0).rgba.size(), pixels().size());
}

TEST(Webp, SizesAreCheckedBeforeTheDecoderRuns)
{
    asset::LoadOptions options;
    options.max_image_px = 36;
    const Outcome outcome = outcome_of(webp_textured(lossless()).glb(), options);
    EXPECT_EQ(outcome.status, CLQ_LIMIT);
    EXPECT_NE(outcome.text.find("37 x 21"), std::string::npos) << outcome.text;
}

TEST(Webp, CutPicturesAreRefused)
{
    Bytes cut = lossless();
    cut.resize(cut.size() / 2);
    const Outcome outcome = outcome_of(webp_textured(cut).glb());
    EXPECT_EQ(outcome.status, CLQ_FORMAT);
    EXPECT_NE(outcome.text.find("cannot be decoded"), std::string::npos) << outcome.text;
}

TEST(Webp, DamagedPicturesGiveASentence)
{
    uint64_t seed = 0;
    for (const Bytes &picture : {lossless(), lossy()}) {
        const Maker maker = webp_textured(picture);
        const size_t at = maker.json["bufferViews"][1]["byteOffset"];
        const Bytes glb = maker.glb();
        expect_sentences(glb, glb.size() - (maker.binary.size() + 3) / 4 * 4 + at, picture.size(), 2000, ++seed);
    }
}

#endif

}  // namespace
}  // namespace claque::testing
