// E6: the same calls give the same bytes for every compiler, optimisation and instruction set, templates included.
#include <claque/claque.h>

#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace
{

// The hash in the header of what clq_template_save writes.
uint64_t hash_of(const clq_template *tmpl)
{
    saved::Bytes bytes;
    const auto keep = [](void *user, const void *from, size_t size) {
        const uint8_t *first = static_cast<const uint8_t *>(from);
        static_cast<saved::Bytes *>(user)->insert(static_cast<saved::Bytes *>(user)->end(), first, first + size);
        return 0;
    };
    EXPECT_EQ(clq_template_save(tmpl, keep, &bytes), CLQ_OK) << clq_last_error();
    uint64_t hash = 0;
    for (size_t i = 0; i < 8; ++i) hash |= uint64_t(bytes.at(24 + i)) << (8 * i);
    return hash;
}

}  // namespace

// The hashes change with the form of prepared templates and with what is searched for their spheres. They are then
// updated by hand, with the reason.
TEST(RecordedTemplate, HasTheSameBytesInEveryBuild)
{
    const TestWorld world;
    EXPECT_EQ(hash_of(world.templates[0]), 0x30aa2991cfb4b6ebull) << "with degrees of freedom";
    EXPECT_EQ(hash_of(world.templates[1]), 0xd544f29df1be1a2dull) << "without";
}
