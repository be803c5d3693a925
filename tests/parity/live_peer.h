// The GPU peer on a running crowd: meshes, textures and colours as exported once, palettes from each update.
#pragma once

#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>

#include <map>
#include <optional>
#include <tuple>

#include "tests/parity/peer.h"

namespace parity_test
{

class LivePeer
{
public:
    // `folder` was exported from this view. The context must be current, here and below.
    LivePeer(const contexts::Offscreen &context, const std::string &folder, const clq_view *view);

    void begin();
    // Draws from the palettes of all individuals, and waits for OpenGL. Throws.
    void draw(const clq_view *view);

private:
    SceneIn scene_;
    std::optional<Peer> peer_;
    std::map<std::tuple<const clq_template *, uint32_t, uint32_t>, uint32_t> mesh_;  // by level and texture set
    std::map<uint32_t, size_t> row_;                                                 // of the atlas, by actor
    std::vector<float> columns_, rows_, weights_;
};

}  // namespace parity_test
