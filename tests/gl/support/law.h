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

// OSMesa with 8888 and 565 and EGL with 8888 and 565. Where the variable CLAQUE_CONTEXT names a kind, GLX perhaps, only
// those of that kind.
std::vector<Target> targets();

// The first `most` of them whose libraries are here; if none are, of all. For what is drawn on some targets only.
std::vector<Target> targets_here(size_t most = 4);

// The plain and id pictures of four views, drawn once per character: near, whole, far, edge-on. With a source the plain
// picture is drawn from that (source_picture.h), else from the template, which a splitter may have got wrong.
class Law
{
public:
    Law(contexts::Offscreen &context, const PosedModel &posed, const model::Model *source = nullptr);

    // Judges a renderer's pictures.
    void hold(const passes::RendererOptions &options, Verdict &verdict) const;

private:
    struct View {
        const char *name;
        double least_share;  // of the picture
        Camera camera;
        Wanted wanted;
    };
    contexts::Offscreen &context_;
    const PosedModel &posed_;
    std::vector<uint8_t> colours_;
    std::vector<View> views_;
};

}  // namespace gltest
