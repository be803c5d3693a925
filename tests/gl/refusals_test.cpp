// A renderer refuses state that would spoil its picture, by name and without changing anything.
#include <functional>
#include <thread>

#include "tests/gl/support/fixture.h"
#include "tests/gl/support/spy.h"
#include "tests/gl/support/state_dump.h"
#include "tests/gl/support/unpack_buffer.h"

namespace gltest
{
namespace
{

class Refusals : public GlTest
{
protected:
    // Sets a state, draws, expects CLQ_GL_STATE with `word` and an unchanged host and picture; undoes it.
    void expect_refusal(const char *word, const std::function<void()> &set, const std::function<void()> &undo)
    {
        const PosedModel posed = small_posed();
        const auto renderer = make_renderer_of(posed);
        host_->clear(0, 0, 0);
        set();
        const bool readable = std::string(word) != "render mode";
        const State before = readable ? dump_state(*host_) : State();
        const Status status = renderer->draw(list_of(posed, whole_view(posed)), nullptr);
        EXPECT_EQ(status.code, CLQ_GL_STATE) << word;
        EXPECT_NE(std::string(status.text).find(word), std::string::npos) << status.text;
        if (readable) {
            EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>()) << word;
        }
        undo();
        EXPECT_EQ(host_->GetError(), 0u) << word;
        Picture picture;
        context_->read_rgb(picture);
        EXPECT_EQ(picture, Picture(picture.size(), 0)) << word;
        EXPECT_TRUE(renderer->draw(list_of(posed, whole_view(posed)), nullptr).ok()) << word;
        renderer->destroy();
    }

    using Bind = void (*)(gl::Enum, uint32_t);
    using Gen = void (*)(int32_t, uint32_t *);
    using One = void (*)(uint32_t);
};

TEST_F(Refusals, NameAnOpenDisplayList)
{
    expect_refusal(
        "display list", [&] { host_->NewList(7, 0x1300); }, [&] { host_->EndList(); });
}

TEST_F(Refusals, NameSelectionAndFeedback)
{
    uint32_t buffer[64];
    host_->SelectBuffer(64, buffer);
    expect_refusal(
        "render mode", [&] { host_->RenderMode(0x1C02); }, [&] { host_->RenderMode(gl::render); });
}

TEST_F(Refusals, NameFullStacks)
{
    int32_t most = 0;
    host_->GetIntegerv(gl::max_attrib_stack_depth, &most);
    expect_refusal(
        "glPushAttrib",
        [&] {
            for (int32_t i = 0; i < most; ++i) host_->PushAttrib(gl::current_bit);
        },
        [&] {
            for (int32_t i = 0; i < most; ++i) host_->PopAttrib();
        });
    host_->GetIntegerv(gl::max_client_attrib_stack_depth, &most);
    expect_refusal(
        "glPushClientAttrib",
        [&] {
            for (int32_t i = 0; i < most; ++i) host_->PushClientAttrib(gl::client_vertex_array_bit);
        },
        [&] {
            for (int32_t i = 0; i < most; ++i) host_->PopClientAttrib();
        });
}

TEST_F(Refusals, NameBoundBuffersAndVertexArrays)
{
    uint32_t buffer = 0, array = 0;
    host_->ask<Gen>("glGenBuffers")(1, &buffer);
    host_->ask<Gen>("glGenVertexArrays")(1, &array);
    const auto bind = host_->ask<Bind>("glBindBuffer");
    const auto bind_array = host_->ask<One>("glBindVertexArray");
    expect_refusal(
        "GL_ARRAY_BUFFER", [&] { bind(0x8892, buffer); }, [&] { bind(0x8892, 0); });
    expect_refusal(
        "GL_ELEMENT_ARRAY_BUFFER", [&] { bind(0x8893, buffer); }, [&] { bind(0x8893, 0); });
    expect_refusal(
        "vertex array object", [&] { bind_array(array); }, [&] { bind_array(0); });
}

TEST_F(Refusals, NameOtherTextureUnits)
{
    const auto active = host_->ask<One>("glActiveTexture"), client = host_->ask<One>("glClientActiveTexture");
    expect_refusal(
        "active texture unit", [&] { active(0x84C1); }, [&] { active(0x84C0); });
    expect_refusal(
        "client's active texture unit", [&] { client(0x84C1); }, [&] { client(0x84C0); });
}

TEST_F(Refusals, NameSwitchesNewerThanGl11)
{
    struct Switch {
        const char *name;
        gl::Enum value;
        bool client;
    };
    constexpr Switch switches[] = {
        {"GL_TEXTURE_3D", 0x806F, false},           {"GL_TEXTURE_CUBE_MAP", 0x8513, false},
        {"GL_TEXTURE_RECTANGLE", 0x84F5, false},    {"GL_VERTEX_PROGRAM_ARB", 0x8620, false},
        {"GL_FRAGMENT_PROGRAM_ARB", 0x8804, false}, {"GL_PRIMITIVE_RESTART", 0x8F9D, false},
        {"GL_FOG_COORD_ARRAY", 0x8457, true},       {"GL_SECONDARY_COLOR_ARRAY", 0x845E, true}};
    for (const Switch &s : switches)
        expect_refusal(
            s.name, [&] { s.client ? host_->EnableClientState(s.value) : host_->Enable(s.value); },
            [&] { s.client ? host_->DisableClientState(s.value) : host_->Disable(s.value); });
}

TEST_F(Refusals, NameAProgramInUse)
{
    const char *source = "void main() { gl_Position = ftransform(); }";
    const uint32_t shader = host_->ask<uint32_t (*)(gl::Enum)>("glCreateShader")(0x8B31);
    const uint32_t program = host_->ask<uint32_t (*)()>("glCreateProgram")();
    host_->ask<void (*)(uint32_t, int32_t, const char **, const int32_t *)>("glShaderSource")(shader, 1, &source,
                                                                                              nullptr);
    host_->ask<One>("glCompileShader")(shader);
    host_->ask<void (*)(uint32_t, uint32_t)>("glAttachShader")(program, shader);
    host_->ask<One>("glLinkProgram")(program);
    const auto use = host_->ask<One>("glUseProgram");
    expect_refusal(
        "program is in use", [&] { use(program); }, [&] { use(0); });
}

TEST_F(Refusals, NameTrianglesThatTakeTheirColourFromTheFirstVertex)
{
    const auto provoke = host_->ask<One>("glProvokingVertex");
    expect_refusal(
        "glProvokingVertex", [&] { provoke(0x8E4D); }, [&] { provoke(0x8E4E); });
}

TEST_F(Refusals, NameASamplerObject)
{
    uint32_t sampler = 0;
    host_->ask<Gen>("glGenSamplers")(1, &sampler);
    const auto bind = host_->ask<void (*)(uint32_t, uint32_t)>("glBindSampler");
    expect_refusal(
        "sampler", [&] { bind(0, sampler); }, [&] { bind(0, 0); });
}

TEST_F(Refusals, OfAnUploadNameAnUnpackBuffer)
{
    const UnpackBuffer buffer(*host_);
    buffer.bind();
    const PosedModel posed = small_posed();
    const auto renderer = make_renderer();
    const Status status = renderer->prepare(*posed.tmpl);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_NE(std::string(status.text).find("GL_PIXEL_UNPACK_BUFFER"), std::string::npos) << status.text;
    buffer.unbind();
    EXPECT_TRUE(renderer->prepare(*posed.tmpl).ok());
}

TEST_F(Refusals, NameTheLackOfACurrentContext)
{
    const PosedModel posed = small_posed();
    const auto renderer = make_renderer_of(posed);
    context_->release();
    EXPECT_EQ(renderer->draw(list_of(posed, whole_view(posed)), nullptr).code, CLQ_GL_MISSING);
    EXPECT_EQ(renderer->prepare(*small_posed().tmpl).code, CLQ_GL_MISSING);
    passes::Renderer late(std::pmr::get_default_resource(), {});
    const Status status = late.open(context_->get_proc_address(), context_->user());
    EXPECT_EQ(status.code, CLQ_GL_MISSING);
    EXPECT_NE(std::string(status.text).find("no GL context"), std::string::npos) << status.text;

    context_->make_current();
    Status elsewhere;
    std::thread([&] { elsewhere = renderer->draw(list_of(posed, whole_view(posed)), nullptr); }).join();
    EXPECT_EQ(elsewhere.code, CLQ_GL_MISSING) << "drawn on a thread that has no context";
    EXPECT_TRUE(renderer->draw(list_of(posed, whole_view(posed)), nullptr).ok());
}

TEST_F(Refusals, NameACoreProfile)
{
    Spy spy(*context_);
    spy.answers[0x9126] = 1;  // GL_CONTEXT_PROFILE_MASK: core
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    const Status status = renderer.open(Spy::get_proc_address, spy.user());
    EXPECT_EQ(status.code, CLQ_GL_MISSING);
    EXPECT_NE(std::string(status.text).find("core profile"), std::string::npos) << status.text;
}

// claque asks an old GL for nothing that it does not know, so that no error is left behind.
TEST_F(Refusals, AskAnOldGlForNothingNew)
{
    Spy spy(*context_);
    spy.strings[gl::version] = "1.1 of old";
    spy.strings[gl::extensions] = "GL_EXT_bgra GL_ARB_multitexture_of_sorts";
    for (const gl::Enum newer : {0x84E0u, 0x84E1u, 0x8894u, 0x8895u, 0x85B5u, 0x8B8Du, 0x8919u, 0x8E4Fu})
        spy.answers[newer] = 5;
    const PosedModel posed = small_posed();
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
    spy.reset();
    EXPECT_TRUE(renderer.draw(list_of(posed, whole_view(posed)), nullptr).ok());
    EXPECT_EQ(spy.calls["glIsEnabled"], 0u);
}

TEST_F(Refusals, NameATextureThatIsTooLarge)
{
    Spy spy(*context_);
    spy.answers[gl::max_texture_size] = 64;
    const PosedModel posed = small_posed();
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    const Status status = renderer.prepare(*posed.tmpl);
    EXPECT_EQ(status.code, CLQ_LIMIT);
    EXPECT_NE(std::string(status.text).find("128 x 128"), std::string::npos) << status.text;
    EXPECT_NE(std::string(status.text).find("64"), std::string::npos) << status.text;
    EXPECT_EQ(spy.calls["glGenTextures"], 0u);
}

TEST_F(Refusals, NameTheTemplateThatIsNotPrepared)
{
    const PosedModel posed = small_posed(), other = small_posed();
    other.tmpl->name = "the other one";
    const auto renderer = make_renderer_of(posed);
    const Status status = renderer->draw(list_of(other, whole_view(other)), nullptr);
    EXPECT_EQ(status.code, CLQ_ARGUMENT);
    EXPECT_NE(std::string(status.text).find("the other one"), std::string::npos) << status.text;
}

TEST_F(Refusals, NameTheZonesThatCannotBeToldApart)
{
    PosedModel posed = make_posed(sheet(9, 0.2f), torture_map(128, 48, 3));
    model::Texture &texture = posed.tmpl->textures[0];
    texture.keys[47].key = texture.keys[46].key;
    const auto renderer = make_renderer();
    const Status status = renderer->prepare(*posed.tmpl);
    EXPECT_EQ(status.code, CLQ_KEY_RESOLUTION) << status.text;
    EXPECT_NE(std::string(status.text).find("48 zones"), std::string::npos) << status.text;
    EXPECT_EQ(renderer->draw(list_of(posed, whole_view(posed)), nullptr).code, CLQ_ARGUMENT);
}

TEST_F(Refusals, OfTheFusedStrategyAloneFallBackToBinned)
{
    const PosedModel posed = make_posed(sheet(9, 0.2f), torture_map(128, 120, 2));
    const auto renderer = make_renderer_of(posed);
    EXPECT_EQ(renderer->strategy_of(*posed.tmpl), passes::Strategy::binned);
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    const auto list = list_of(posed, whole_view(posed), colours.data());
    Verdict().hold(wanted_of(*context_, posed, whole_view(posed)), draw(*context_, *renderer, list), 0.2);
    EXPECT_EQ(renderer->strategy_of(*small_posed().tmpl), passes::Strategy::fused);
}

TEST_F(Refusals, NameTheEqualTestWithOtherStrategies)
{
    for (const passes::Strategy strategy : {passes::Strategy::fused, passes::Strategy::binned}) {
        passes::RendererOptions options = options_of(strategy);
        options.key_test = passes::KeyTest::equal;
        passes::Renderer renderer(std::pmr::get_default_resource(), options);
        EXPECT_EQ(renderer.open(context_->get_proc_address(), context_->user()).code, CLQ_ARGUMENT);
    }
}

}  // namespace
}  // namespace gltest
