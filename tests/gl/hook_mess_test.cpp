// GL state that a host's callbacks leave behind affects no later individual (S0 7.1).
#include "passes/guard.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/mess.h"
#include "tests/gl/support/spy.h"
#include "tests/gl/support/state_dump.h"

namespace gltest
{
namespace
{

using passes::Guard;
using DisruptiveHooks = HooksTest;

std::set<gl::Enum> documented(Guard guard)
{
    std::set<gl::Enum> names;
    for (const passes::Left &left : passes::left_by_minimal) names.insert(left.name);
    for (const passes::Left &left : passes::left_by_none)
        if (guard == Guard::none) names.insert(left.name);
    return names;
}

TEST_F(DisruptiveHooks, ThatChangeWhatClaqueSetsLeaveNoTraceInThePicture)
{
    for (const passes::Strategy strategy : all_strategies)
        for (const Guard guard : {Guard::full, Guard::minimal, Guard::none}) {
            const passes::RendererOptions options = options_of(strategy, guard);
            const Picture expected = calm(options);
            for (const auto &[first, last] : {std::pair(true, false), {false, true}, {true, true}})
                for (size_t place = 0; place < 3; ++place) {
                    SetUp();
                    Mess mess(*host_);
                    const auto make = [&] { return mess.with_what_claque_sets(), 0; };
                    const Callbacks hooks(first ? make : std::function<int32_t()>(),
                                          last ? make : std::function<void()>());
                    const auto renderer = make_renderer_of(posed_, options);
                    DrawList list = trio();
                    list.items[place].hooks = &hooks.hooks;
                    EXPECT_TRUE(draw(*context_, *renderer, list) == expected)
                        << int(strategy) << " " << int(guard) << " " << place;
                    EXPECT_TRUE(draw(*context_, *renderer, list) == expected) << "once more";
                    EXPECT_EQ(host_->GetError(), 0u);
                }
            SetUp();
        }
}

TEST_F(DisruptiveHooks, ThatChangeEverythingDoNotReachTheNeighbours)
{
    for (const passes::Strategy strategy : all_strategies) {
        const Picture expected = calm(options_of(strategy));
        for (const auto &[first, last] : {std::pair(true, false), {false, true}, {true, true}}) {
            SetUp();
            Mess mess(*host_);
            const auto make = [&] { return mess.with_everything(), 0; };
            const Callbacks hooks(first ? make : std::function<int32_t()>(), last ? make : std::function<void()>());
            const Picture messed = draw(*context_, *make_renderer_of(posed_, options_of(strategy)), trio(hooks));
            expect_same_neighbours(messed, expected);
            EXPECT_EQ(same_middle(messed, expected), !first) << "what claque inherits acts on it";
        }
        SetUp();
    }
}

TEST_F(DisruptiveHooks, LeaveTheHostsStateAsItWasInGuardModeFull)
{
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(posed_, options_of(strategy));
        const HostileHost hostile(*host_);
        Mess mess(*host_);
        const auto make = [&] { return mess.with_everything(), 0; };
        const Callbacks both(make, make);
        const State before = dump_state(*host_);
        const Status status = renderer->draw(trio(both), nullptr);
        EXPECT_TRUE(status.ok()) << status.text;
        const State after = dump_state(*host_);
        for (const std::string &name : differences(before, after))
            ADD_FAILURE() << name << " was " << text_of(before.at(name)) << ", is now " << text_of(after.at(name));
        SetUp();
    }
}

// NVIDIA's driver 580.159.04 leaves GL_MULTISAMPLE as it is at a pop. In guard mode none the frame of the hooks alone
// can restore it.
TEST_F(DisruptiveHooks, LeaveTheHostsMultisamplingWhereGlForgetsToPopIt)
{
    for (const bool on : {true, false}) {
        Spy spy(*context_);
        spy.forgets_samples = true;
        passes::RendererOptions options = options_of(passes::Strategy::fused, Guard::none);
        options.multisample = true;
        passes::Renderer renderer(std::pmr::get_default_resource(), options);
        ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed_.tmpl).ok());
        const auto set = [&](bool to) { to ? host_->Enable(gl::multisample) : host_->Disable(gl::multisample); };
        set(on);
        const Callbacks both([&] { return set(!on), 0; }, nullptr);
        ASSERT_TRUE(renderer.draw(trio(both), nullptr).ok());
        EXPECT_EQ(host_->IsEnabled(gl::multisample) != 0, on);
        renderer.destroy();
    }
}

TEST_F(DisruptiveHooks, LeaveNothingThatIsNotDocumentedInTheOtherGuardModes)
{
    for (const Guard guard : {Guard::minimal, Guard::none}) {
        const auto renderer = make_renderer_of(posed_, options_of(passes::Strategy::fused, guard));
        Mess mess(*host_);
        const auto make = [&] { return mess.with_everything(), 0; };
        const Callbacks both(make, make);
        DrawList list = trio(both);
        list.items[2].hooks = &both.hooks;
        const State before = dump_state(*host_);
        ASSERT_TRUE(renderer->draw(list, nullptr).ok());
        const State after = dump_state(*host_);
        const std::set<gl::Enum> left = documented(guard);
        for (const std::string &name : differences(before, after)) {
            if (name.rfind("GL_TEXTURE_2D GL_", 0) == 0) continue;  // of another texture
            EXPECT_TRUE(left.count(after.at(name).name)) << name << " is now " << text_of(after.at(name));
        }
        SetUp();
    }
}

// Modes that GL 1.1 alone can end are ended.
TEST_F(DisruptiveHooks, ThatLeaveADisplayListOrSelectionOpenAreClosed)
{
    const Picture expected = calm();
    uint32_t names[8];
    const Callbacks lists([&] { return host_->NewList(7, 0x1300), 0; }, [&] { host_->NewList(8, 0x1300); });
    const Callbacks selects([&] { return host_->SelectBuffer(8, names), host_->RenderMode(0x1C02), 0; },
                            [&] { host_->RenderMode(0x1C02); });
    for (const Callbacks *hooks : {&lists, &selects}) {
        EXPECT_EQ(draw(*context_, *make_renderer_of(posed_), trio(*hooks)), expected);
        EXPECT_EQ(host_->GetError(), 0u);
    }
}

// A program in use is newer than what claque can undo.
TEST_F(DisruptiveHooks, ThatLeaveWhatCannotBeUndoneAreNamed)
{
    using One = void (*)(uint32_t);
    const uint32_t shader = host_->ask<uint32_t (*)(gl::Enum)>("glCreateShader")(0x8B31);
    const uint32_t program = host_->ask<uint32_t (*)()>("glCreateProgram")();
    const char *source = "void main() { gl_Position = ftransform(); }";
    host_->ask<void (*)(uint32_t, int32_t, const char **, const int32_t *)>("glShaderSource")(shader, 1, &source,
                                                                                              nullptr);
    host_->ask<One>("glCompileShader")(shader);
    host_->ask<void (*)(uint32_t, uint32_t)>("glAttachShader")(program, shader);
    host_->ask<One>("glLinkProgram")(program);
    const auto use = host_->ask<One>("glUseProgram");
    const Picture expected = calm();
    const auto renderer = make_renderer_of(posed_);
    passes::DrawStats stats;

    const Callbacks between([&] { return use(program), 0; }, [&] { use(0); });
    host_->clear(0, 0, 0);
    Status status = renderer->draw(trio(between), &stats);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    for (const char *word : {"actor 12", "'before'", "program is in use"})
        EXPECT_NE(std::string(status.text).find(word), std::string::npos) << status.text;
    EXPECT_EQ(stats.individuals, 2u) << "its neighbours are drawn";

    const State before = dump_state(*host_);
    const Callbacks for_good(nullptr, [&] { use(program); });
    status = renderer->draw(trio(for_good), &stats);
    use(0);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_NE(std::string(status.text).find("'after'"), std::string::npos) << status.text;
    EXPECT_EQ(stats.individuals, 2u) << "no individual may be drawn by another's program";
    EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
    EXPECT_EQ(draw(*context_, *renderer, trio()), expected);
}

// The host must not pop below what it has pushed; if it does, it loses only its own state.
TEST_F(DisruptiveHooks, ThatPopTooMuchLeaveTheStacksBalanced)
{
    const Callbacks pops([&] { return host_->PopAttrib(), host_->PopAttrib(), 0; }, [&] { host_->PopClientAttrib(); });
    const auto renderer = make_renderer_of(posed_);
    host_->PushAttrib(gl::current_bit);
    host_->PushClientAttrib(gl::client_vertex_array_bit);
    EXPECT_EQ(draw(*context_, *renderer, trio(pops)), calm());
    int32_t depth = 0;
    host_->GetIntegerv(gl::attrib_stack_depth, &depth);
    EXPECT_EQ(depth, 1);
    host_->GetIntegerv(gl::client_attrib_stack_depth, &depth);
    EXPECT_EQ(depth, 1);
    EXPECT_EQ(host_->GetError(), 0u);
}

}  // namespace
}  // namespace gltest
