// Shadows on the ground leave a host's state and buffers unchanged except for the colours that they darken.
#include "tests/gl/support/hostile.h"
#include "tests/gl/support/shadows.h"
#include "tests/gl/support/state_dump.h"

namespace gltest
{
namespace
{

TEST_F(Shadows, LeaveAllOfTheHostsStateAsItWas)
{
    for (const passes::Guard guard : {passes::Guard::full, passes::Guard::minimal, passes::Guard::none})
        for (const int32_t bit : {-1, 2})
            for (const bool hostile : {false, true}) {
                const auto renderer = make_renderer_of(*posed_, options_of(passes::Strategy::fused, guard));
                std::unique_ptr<HostileHost> host;
                if (hostile) host = std::make_unique<HostileHost>(*host_);
                const State before = dump_state(*host_);
                passes::ShadowStats stats;
                const Status status = renderer->draw_shadows(ground_.list_of(people_), options_for(sun, bit), &stats);
                EXPECT_TRUE(status.ok()) << status.text;
                EXPECT_EQ(stats.individuals, people_.size());
                EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>()) << bit << hostile;
                EXPECT_EQ(host_->GetError(), 0u);
                SetUp();
            }
}

TEST_F(Shadows, WriteNoDepthNoAlphaAndNoOtherBitOfTheStencil)
{
    const auto read_pixels =
        host_->ask<void (*)(int32_t, int32_t, int32_t, int32_t, gl::Enum, gl::Enum, void *)>("glReadPixels");
    const auto plane_of = [&](gl::Enum format, gl::Enum type) {
        std::vector<uint32_t> values(size_t(width) * height);
        read_pixels(0, 0, width, height, format, type, values.data());
        return values;
    };
    constexpr gl::Enum depth_component = 0x1902, stencil_index = 0x1901, alpha = 0x1906;
    const auto renderer = make_renderer_of(*posed_);
    ground_.draw(*host_, width, height);
    const auto depth = plane_of(depth_component, gl::unsigned_int), opaque = plane_of(alpha, gl::unsigned_int);
    for (const int32_t bit : {-1, 4}) {
        const Picture before = read();
        ASSERT_TRUE(renderer->draw_shadows(ground_.list_of(people_), options_for(sun, bit), nullptr).ok());
        EXPECT_EQ(plane_of(depth_component, gl::unsigned_int), depth);
        EXPECT_EQ(plane_of(alpha, gl::unsigned_int), opaque);
        EXPECT_GT(differing(read(), before), 1500u);
        const uint32_t own = bit < 0 ? 0 : 1u << bit;
        for (const uint32_t value : plane_of(stencil_index, gl::unsigned_int)) ASSERT_EQ(value | own, 0xffu);
    }
}

TEST_F(Shadows, RefuseABitThatTheTargetDoesNotHave)
{
    const auto renderer = make_renderer_of(*posed_);
    const State before = dump_state(*host_);
    const Status status = renderer->draw_shadows(ground_.list_of(people_), options_for(sun, 8), nullptr);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_STREQ(status.text, "stencil bit 8 is lent to shadows, but the target has 8 stencil bits");
    EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
}

}  // namespace
}  // namespace gltest
