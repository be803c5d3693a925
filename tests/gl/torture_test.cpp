// Hosts with random state get the same picture as one with default state, and their state back.
#include "tests/gl/support/torture.h"

#include "tests/gl/support/fixture.h"
#include "tests/gl/support/state_dump.h"

namespace gltest
{
namespace
{

class Torture : public GlTest
{
protected:
    static constexpr int small_width = 96, small_height = 72;

    void SetUp() override { make_context(small_width, small_height); }

    void expect_unchanged(const State &before, const std::string &when)
    {
        const State after = dump_state(*host_);
        for (const std::string &name : differences(before, after))
            ADD_FAILURE() << when << ": " << name << " is now " << text_of(after.at(name)) << ", was "
                          << text_of(before.at(name));
    }
    static passes::RendererOptions options_of_number(uint32_t number)
    {
        passes::RendererOptions options = options_of(all_strategies[number % 3]);
        if (number / 3 % 2) options.colours = passes::ColourFormat::real;
        return options;
    }

    const PosedModel posed_ = small_posed();
};

// Every call of a renderer's life, each between two dumps of all state.
TEST_F(Torture, OfFortyHostsSpoilsNeitherThePictureNorTheirState)
{
    std::vector<Picture> calm;
    for (uint32_t number = 0; number < 6; ++number)
        calm.push_back(
            draw(*context_, *make_renderer_of(posed_, options_of_number(number)), list_of(posed_, whole_view(posed_))));
    for (uint32_t number = 60; number < 100; ++number) {
        const std::string host = "host " + std::to_string(number);
        SetUp();
        host_->clear(background[0] / 255.0f, background[1] / 255.0f, background[2] / 255.0f);
        const TorturedHost tortured(*host_, number);
        ASSERT_EQ(host_->GetError(), 0u) << host;
        const State before = dump_state(*host_);
        const auto renderer = make_renderer(options_of_number(number));
        expect_unchanged(before, host + " after open");
        const Status prepared = renderer->prepare(*posed_.tmpl);
        ASSERT_TRUE(prepared.ok()) << host << ": " << prepared.text;
        expect_unchanged(before, host + " after prepare");
        const Status drawn = renderer->draw(list_of(posed_, whole_view(posed_)), nullptr);
        ASSERT_TRUE(drawn.ok()) << host << ": " << drawn.text;
        expect_unchanged(before, host + " after draw");
        Picture picture;
        context_->read_rgb(picture);
        EXPECT_EQ(picture, calm[number % 6]) << host;
        renderer->destroy();
        expect_unchanged(before, host + " after destroy");
        ASSERT_EQ(host_->GetError(), 0u) << host;
    }
}

TEST_F(Torture, OfEachSwitchInTurnSpoilsNoPicture)
{
    const auto renderer = make_renderer_of(posed_);
    const auto list = list_of(posed_, whole_view(posed_));
    const Picture calm = draw(*context_, *renderer, list);
    for (size_t i = 0; i < switch_count; ++i) {
        const gl::Enum name = all_switches[i].name;
        const bool was = host_->IsEnabled(name);
        was ? host_->Disable(name) : host_->Enable(name);
        ASSERT_EQ(host_->GetError(), 0u) << name;
        const Picture picture = draw(*context_, *renderer, list);
        EXPECT_EQ(picture != calm, all_switches[i].inherited_and_seen) << "switch " << name;
        EXPECT_EQ(host_->IsEnabled(name) != 0, !was) << "switch " << name;
        was ? host_->Enable(name) : host_->Disable(name);
    }
}

}  // namespace
}  // namespace gltest
