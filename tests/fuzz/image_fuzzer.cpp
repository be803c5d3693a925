// PNG, JPEG and WebP pictures.
#include "lib/asset/image.h"
#include "lib/base/error.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    using namespace claque;
    asset::ImageLimits limits;
    limits.max_px = 4096;
    limits.max_bytes = 16u << 20;
    try {
        const model::Image image = asset::decode_image(bytes, size, "picture", limits);
        EXPECT_TRUE(image.width > 0 && image.width <= limits.max_px) << image.width;
        EXPECT_TRUE(image.height > 0 && image.height <= limits.max_px) << image.height;
        EXPECT_EQ(image.rgba.size(), 4 * size_t(image.width) * image.height);
        const model::Image again = asset::decode_image(bytes, size, "picture", limits);
        EXPECT_EQ(image.rgba, again.rgba);
    } catch (const base::Error &error) {
        EXPECT_TRUE(error.status() == CLQ_FORMAT || error.status() == CLQ_UNSUPPORTED || error.status() == CLQ_LIMIT)
            << clq_status_name(error.status()) << ": " << error.what();
        EXPECT_STRNE(error.what(), "");
    }
    return 0;
}
