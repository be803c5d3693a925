// A host selects an instruction set, reads it back, and is refused one that the processor lacks.
#include <claque/claque.h>

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace
{

class Simd : public testing::Test
{
protected:
    void TearDown() override { EXPECT_EQ(clq_simd_set(before_), CLQ_OK); }
    const clq_simd before_ = clq_simd_get();
};

TEST_F(Simd, IsReadBackAsSet)
{
    for (const clq_simd simd : {CLQ_SIMD_SCALAR, CLQ_SIMD_128, CLQ_SIMD_256, CLQ_SIMD_FMA}) {
        const clq_simd was = clq_simd_get();
        const clq_status status = clq_simd_set(simd);
        if (status == CLQ_UNSUPPORTED && simd >= CLQ_SIMD_256) {
            EXPECT_NE(std::string(clq_last_error()).find("this processor has no AVX2"), std::string::npos);
            EXPECT_EQ(clq_simd_get(), was);
            continue;
        }
        ASSERT_EQ(status, CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_simd_get(), simd);
    }
}

TEST_F(Simd, IsTheWidestOfEqualBitsWhereNothingIsNamed)
{
    ASSERT_EQ(clq_simd_set(CLQ_SIMD_WIDEST), CLQ_OK);
    const clq_simd widest = clq_simd_get();
    EXPECT_TRUE(widest == CLQ_SIMD_128 || widest == CLQ_SIMD_256);
    EXPECT_EQ(clq_simd_set(CLQ_SIMD_256), widest == CLQ_SIMD_256 ? CLQ_OK : CLQ_UNSUPPORTED);
}

TEST_F(Simd, OfNoNameIsRefusedAndChangesNothing)
{
    const int number = 5;
    clq_simd none;
    std::memcpy(&none, &number, sizeof none);
    EXPECT_EQ(clq_simd_set(none), CLQ_ARGUMENT);
    EXPECT_STREQ(clq_last_error(), "clq_simd_set: 5 is no instruction set");
    EXPECT_EQ(clq_simd_get(), before_);
}

}  // namespace
