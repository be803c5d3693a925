// The law of zones over four views of a character.
#pragma once

#include "tests/gl/support/pictures.h"

namespace gltest
{

// A context in which the law is tested.
struct Target {
    contexts::Kind kind;
    contexts::PixelFormat format;
    const char *name;
};
constexpr Target all_targets[] = {
    {contexts::Kind::osmesa, contexts::PixelFormat::rgba8888, "OsmesaRgba8888"},
    {contexts::Kind::osmesa, contexts::PixelFormat::rgb565, "OsmesaRgb565"},
    {contexts::Kind::egl, contexts::PixelFormat::rgba8888, "EglRgba8888"},
    {contexts::Kind::egl, contexts::PixelFormat::rgb565, "EglRgb565"},
};
constexpr Target two_targets[] = {all_targets[0], all_targets[1]};

// The plain and id pictures of four views, drawn once per character: near, whole, far, edge-on. With a source the plain
// picture is drawn from that (source_picture.h), else from the template, which a splitter may have got wrong.
class Law
{
public:
    Law(contexts::Offscreen &context, const PosedModel &posed, const model::Model *source = nullptr);

    // Adds test failures where a renderer's pictures differ or have holes.
    void hold(const passes::RendererOptions &options) const;

    uint64_t covered() const { return covered_; }  // pixels of all views
    uint64_t ties() const { return ties_; }        // of them, excluded because different triangles tie in depth

private:
    struct View {
        const char *name;
        Camera camera;
        Picture plain, forwards, backwards;
    };
    contexts::Offscreen &context_;
    const PosedModel &posed_;
    std::vector<uint8_t> colours_;
    std::vector<View> views_;
    uint64_t covered_ = 0, ties_ = 0;
};

}  // namespace gltest
