// What a renderer asks of GL and of a list, each on both sides of its bound, with a GL that answers as a test wants.
#include <functional>

#include "tests/gl/support/fixture.h"
#include "tests/gl/support/spy.h"

namespace gltest
{
namespace
{

using claque::draw::DrawList;

class Limits : public GlTest
{
protected:
    // A renderer of the small template on a GL that answers.
    std::unique_ptr<passes::Renderer> make(passes::Guard guard = passes::Guard::full)
    {
        auto renderer = std::make_unique<passes::Renderer>(std::pmr::get_default_resource(),
                                                           options_of(passes::Strategy::fused, guard));
        EXPECT_TRUE(renderer->open(Spy::get_proc_address, spy_->user()).ok());
        EXPECT_TRUE(renderer->prepare(*posed_.tmpl).ok());
        return renderer;
    }
    void SetUp() override
    {
        GlTest::SetUp();
        if (context_) spy_ = std::make_unique<Spy>(*context_);
    }
    DrawList list() const { return list_of(posed_, whole_view(posed_)); }

    using Call = std::function<Status()>;
    static void taken(const Call &call, int line)
    {
        const Status status = call();
        EXPECT_TRUE(status.ok()) << "line " << line << ": " << status.text;
    }
    static void refused(const Call &call, clq_status code, const std::string &sentence, int line)
    {
        const Status status = call();
        EXPECT_EQ(status.code, code) << "line " << line;
        EXPECT_NE(std::string(status.text).find(sentence), std::string::npos)
            << "line " << line << ": " << status.text << "\nand not: " << sentence;
    }

    PosedModel posed_ = small_posed();
    std::unique_ptr<Spy> spy_;
};

#define TAKEN(...) taken([&] { return __VA_ARGS__; }, __LINE__)
#define REFUSED(code, sentence, ...) refused([&] { return __VA_ARGS__; }, code, sentence, __LINE__)

struct Stack {
    gl::Enum depth, most;
    const char *name;
};
constexpr Stack stacks[] = {{gl::attrib_stack_depth, gl::max_attrib_stack_depth, "glPushAttrib"},
                            {gl::client_attrib_stack_depth, gl::max_client_attrib_stack_depth, "glPushClientAttrib"}};

TEST_F(Limits, OfTheHostsStacksAreThoseThatADrawNeeds)
{
    const claque::draw::Hooks none;
    DrawList hooked = list();
    hooked.items[0].hooks = &none;
    const auto renderer = make();
    passes::Renderer fresh(std::pmr::get_default_resource(), {});
    ASSERT_TRUE(fresh.open(Spy::get_proc_address, spy_->user()).ok());
    for (const Stack &stack : stacks) {
        spy_->answers[stack.depth] = 3;
        spy_->answers[stack.most] = 4;
        TAKEN(renderer->draw(list(), nullptr));
        TAKEN(renderer->draw_visibility(list(), {}, nullptr));
        TAKEN(renderer->draw_shadows(list(), {}, nullptr));
        const auto places = [&](int most, int needed) {
            return "the host has taken 3 of " + std::to_string(most) + " places of the " + stack.name +
                   " stack, claque needs " + std::to_string(needed);
        };
        REFUSED(CLQ_GL_STATE, places(4, 2), renderer->draw(hooked, nullptr));
        spy_->answers[stack.most] = 3;
        REFUSED(CLQ_GL_STATE, places(3, 1), renderer->draw(list(), nullptr));
        REFUSED(CLQ_GL_STATE, places(3, 1), renderer->draw_visibility(list(), {}, nullptr));
        REFUSED(CLQ_GL_STATE, places(3, 1), renderer->draw_shadows(list(), {}, nullptr));
        REFUSED(CLQ_GL_STATE, places(3, 1), fresh.prepare(*posed_.tmpl));
        spy_->answers[stack.most] = 5;
        TAKEN(renderer->draw(hooked, nullptr));
        spy_->answers.clear();
    }
    for (const Stack &stack : stacks) spy_->answers[stack.depth] = 3, spy_->answers[stack.most] = 4;
    TAKEN(fresh.prepare(*posed_.tmpl));
}

// A stack on which nothing is pushed is not asked for its depth.
TEST_F(Limits, OfStacksAreNotAskedOfADrawThatPushesNothing)
{
    uint32_t asked[2] = {0, 0};
    const auto of_draws = [&](passes::Guard guard) {
        const auto renderer = make(guard);
        asked[0] = asked[1] = 0;
        spy_->watch = [&](const std::string &name, const std::vector<double> &arguments) {
            for (int i = 0; i < 2 && name == "glGetIntegerv"; ++i) asked[i] += arguments[0] == double(stacks[i].depth);
        };
        TAKEN(renderer->draw(list(), nullptr));
        spy_->watch = nullptr;
        return std::pair(asked[0] > 0, asked[1] > 0);
    };
    EXPECT_EQ(of_draws(passes::Guard::none), std::pair(false, false));
    EXPECT_EQ(of_draws(passes::Guard::minimal), std::pair(false, true));
    EXPECT_EQ(of_draws(passes::Guard::full), std::pair(true, true));
}

TEST_F(Limits, OfTheTargetAreAskedOfEachDraw)
{
    const auto renderer = make();
    passes::Renderer fresh(std::pmr::get_default_resource(), {});
    ASSERT_TRUE(fresh.open(Spy::get_proc_address, spy_->user()).ok());
    const struct {
        gl::Enum name;
        int32_t answer;
        const char *sentence;
        bool of_uploads;
    } all[] = {{gl::rgba_mode, 0, "the target is in colour index mode", false},
               {gl::render_mode, 0x1C02, "the render mode is not GL_RENDER but selection or feedback", false},
               {gl::list_index, 7, "the display list 7 is being compiled", true}};
    for (const auto &one : all) {
        spy_->answers = {{one.name, one.answer}};
        REFUSED(CLQ_GL_STATE, one.sentence, renderer->draw(list(), nullptr));
        REFUSED(CLQ_GL_STATE, one.sentence, renderer->draw_visibility(list(), {}, nullptr));
        REFUSED(CLQ_GL_STATE, one.sentence, renderer->draw_shadows(list(), {}, nullptr));
        if (one.of_uploads) REFUSED(CLQ_GL_STATE, one.sentence, fresh.prepare(*posed_.tmpl));
    }
    spy_->answers = {{gl::rgba_mode, 0}};
    TAKEN(fresh.prepare(*posed_.tmpl));
}

TEST_F(Limits, OfBitsAreEightOfEachColourAndAnyOfDepth)
{
    const auto renderer = make();
    const auto drawn = [&] { return renderer->draw_visibility(list(), {}, nullptr); };
    constexpr gl::Enum red_bits = 0x0D52, green_bits = 0x0D53, blue_bits = 0x0D54, depth_bits = 0x0D56;
    for (const gl::Enum bits : {red_bits, green_bits, blue_bits}) {
        spy_->answers = {{bits, 8}};
        TAKEN(drawn());
        spy_->answers = {{bits, 7}};
        REFUSED(CLQ_GL_STATE, " bits of red, green and blue: numbers need 8 of each", drawn());
    }
    spy_->answers = {{depth_bits, 1}};
    TAKEN(drawn());
    spy_->answers = {{depth_bits, 0}};
    REFUSED(CLQ_GL_STATE, "the target has no depth buffer", drawn());
}

TEST_F(Limits, OfTheStencilAreTheBitsOfTheTarget)
{
    const auto renderer = make();
    const auto drawn = [&](int32_t bit) {
        passes::ShadowOptions options;
        options.stencil_bit = bit;
        return renderer->draw_shadows(list(), options, nullptr);
    };
    spy_->answers = {{gl::stencil_bits, 3}};
    TAKEN(drawn(0));
    TAKEN(drawn(2));
    REFUSED(CLQ_GL_STATE, "stencil bit 3 is lent to shadows, but the target has 3 stencil bits", drawn(3));
    spy_->answers = {{gl::stencil_bits, 0}};
    TAKEN(drawn(-1));
    REFUSED(CLQ_GL_STATE, "stencil bit 0 is lent to shadows, but the target has 0 stencil bits", drawn(0));
}

TEST_F(Limits, OfItemsAreTheLevelsOfTheirTemplates)
{
    const auto renderer = make();
    const std::string sentence = "actor 5: level 1 of template 'hand-made', which has 1";
    DrawList all = list();
    all.items[0].actor_index = 4, all.items[0].level = 1;
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw(all, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_visibility(all, {}, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_shadows(all, {}, nullptr));
    all.items[0].shadow_only = true;
    TAKEN(renderer->draw(all, nullptr));
    TAKEN(renderer->draw_visibility(all, {}, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_shadows(all, {}, nullptr));
    // One that GL's matrix stack cannot place, and that has no part in view.
    const claque::math::Affine local;
    DrawList placed = list();
    placed.items[0].locals = &local;
    REFUSED(CLQ_ARGUMENT, "GL's matrix stack cannot place the template", renderer->draw(placed, nullptr));
    placed.items[0].parts = 0;
    TAKEN(renderer->draw(placed, nullptr));
}

TEST_F(Limits, OfListsAreTemplatesThatArePrepared)
{
    const auto renderer = make();
    const PosedModel other = small_posed();
    DrawList all = list();
    all.items.push_back(list_of(other, whole_view(other)).items[0]);
    all.items.push_back(all.items[0]);
    const std::string sentence = "the template 'hand-made' has not been prepared for this renderer";
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw(all, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_visibility(all, {}, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_shadows(all, {}, nullptr));
    all.items[1].shadow_only = true;
    TAKEN(renderer->draw(all, nullptr));
    TAKEN(renderer->draw_visibility(all, {}, nullptr));
    REFUSED(CLQ_ARGUMENT, sentence, renderer->draw_shadows(all, {}, nullptr));
    for (const bool shadow_only : {true, false}) {
        all.items[1].tmpl = nullptr, all.items[1].shadow_only = shadow_only;
        REFUSED(CLQ_ARGUMENT, "the template '(none)' has not been prepared", renderer->draw_shadows(all, {}, nullptr));
    }
}

}  // namespace
}  // namespace gltest
