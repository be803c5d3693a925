// NumPy's array files, of each type that a parity folder may hold.
#include "samples/parity/npy.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const std::vector<unsigned char> file(bytes, bytes + size);
    for (const char *type : {"<f4", "|u1", "<u2", "<u4"}) {
        try {
            const parity::Array array = parity::read_npy(file, "array.npy", type);
            size_t count = 1;
            for (const size_t side : array.shape) count *= side;
            EXPECT_EQ(array.type, type);
            EXPECT_EQ(array.bytes.size(), count * static_cast<size_t>(type[2] - '0'));
            EXPECT_LE(array.bytes.size(), size);
        } catch (const parity::Unreadable &error) {
            EXPECT_STRNE(error.what(), "");
        }
    }
    return 0;
}
