// Visibility pictures in a host's context: they leave no trace, keep holes, and are refused where a host's buffer would
// be read instead of texels.
#include "tests/gl/support/absent_extension.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/hostile.h"
#include "tests/gl/support/state_dump.h"
#include "tests/gl/support/unpack_buffer.h"

namespace gltest
{
namespace
{

PosedModel with_holes()
{
    ZoneMap map = torture_map(128, 8, 3);
    for (size_t i = 0; i < map.zones.size(); ++i)
        if (i / 128 % 16 < 5 && i % 16 < 5) map.zones[i] = hole;
    return make_posed(sheet(9, 0.2f), map);
}

class VisibilityHost : public GlTest
{
protected:
    VisibilityHost() : posed_(with_holes()) {}
    claque::draw::DrawList list() const { return list_of(posed_, whole_view(posed_)); }

    PosedModel posed_;
};

TEST_F(VisibilityHost, HasTheStateOfBeforeWhateverTheGuardMode)
{
    for (const passes::Guard guard : {passes::Guard::none, passes::Guard::minimal, passes::Guard::full}) {
        SetUp();
        const auto renderer = make_renderer_of(posed_, options_of(passes::Strategy::fused, guard));
        const HostileHost hostile(*host_);
        const State before = dump_state(*host_);
        const Status status = renderer->draw_visibility(list(), {}, nullptr);
        EXPECT_TRUE(status.ok()) << status.text;
        EXPECT_TRUE(differences(before, dump_state(*host_)).empty()) << "guard " << int(guard);
    }
}

TEST_F(VisibilityHost, ShowsNumbersWhereThePictureShowsTheIndividual)
{
    const auto renderer = make_renderer_of(posed_);
    const Picture shown = draw(*context_, *renderer, list());
    Picture numbers = begin_picture(*context_, *host_, background);
    host_->clear(0, 0, 0);
    ASSERT_TRUE(renderer->draw_visibility(list(), {}, nullptr).ok());
    context_->read_rgb(numbers);
    size_t covered = 0, different = 0;
    for (size_t i = 0; i < shown.size(); i += 3) {
        const bool is_there = !std::equal(background, background + 3, &shown[i]);
        covered += is_there;
        different += is_there != (numbers[i] != 0 || numbers[i + 1] != 0 || numbers[i + 2] != 0);
    }
    EXPECT_GT(covered, 10000u);
    EXPECT_EQ(different, 0u);
}

TEST_F(VisibilityHost, IsRefusedWhereAHostsBufferWouldBeReadInstead)
{
    NEEDS_EXTENSION("GL_ARB_pixel_buffer_object", *host_);
    const auto renderer = make_renderer_of(posed_);
    const UnpackBuffer buffer(*host_);
    buffer.bind();
    const Status status = renderer->draw_visibility(list(), {}, nullptr);
    EXPECT_EQ(status.code, CLQ_GL_STATE) << status.text;
    EXPECT_NE(std::string(status.text).find("GL_PIXEL_UNPACK_BUFFER"), std::string::npos) << status.text;
    buffer.unbind();
    EXPECT_TRUE(renderer->draw_visibility(list(), {}, nullptr).ok());
    buffer.bind();
    EXPECT_TRUE(renderer->draw_visibility(list(), {}, nullptr).ok()) << "the texture is there already";
    buffer.unbind();
}

}  // namespace
}  // namespace gltest
