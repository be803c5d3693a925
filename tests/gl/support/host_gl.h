// A host's own GL, for tests: the table that claque uses plus functions that only a host calls. Nothing is linked.
#pragma once

#include "passes/gl11.h"
#include "samples/contexts/offscreen.h"

namespace gltest
{

namespace gl = claque::passes::gl;

struct HostGl : claque::passes::Gl11 {
    explicit HostGl(const contexts::Offscreen &context);

    void (*Clear)(Bits buffers) = nullptr;
    void (*ClearColor)(float r, float g, float b, float a) = nullptr;
    void (*Viewport)(int32_t x, int32_t y, int32_t width, int32_t height) = nullptr;
    Enum (*GetError)() = nullptr;
    void (*Finish)() = nullptr;
    void (*Color4ub)(uint8_t r, uint8_t g, uint8_t b, uint8_t a) = nullptr;
    void (*Lightfv)(Enum light, Enum name, const float *values) = nullptr;
    void (*LightModelfv)(Enum name, const float *values) = nullptr;
    void (*Materialfv)(Enum face, Enum name, const float *values) = nullptr;
    void (*Fogfv)(Enum name, const float *values) = nullptr;
    void (*Fogi)(Enum name, int32_t value) = nullptr;
    void (*TexGeni)(Enum coordinate, Enum name, int32_t value) = nullptr;
    void (*BlendFunc)(Enum source, Enum destination) = nullptr;
    void (*LogicOp)(Enum operation) = nullptr;
    void (*PolygonMode)(Enum face, Enum mode) = nullptr;
    void (*NewList)(uint32_t list, Enum mode) = nullptr;
    void (*SelectBuffer)(int32_t size, uint32_t *buffer) = nullptr;
    uint8_t (*IsTexture)(uint32_t name) = nullptr;

    // Any other function, by name.
    template <class Function>
    Function ask(const char *name) const
    {
        return reinterpret_cast<Function>(get_(user_, name));
    }

    // clears colour and depth whatever the masks, in a context without errors
    void clear(float r, float g, float b) const;

private:
    contexts::Offscreen::GetProcAddress get_;
    void *user_;
};

}  // namespace gltest
