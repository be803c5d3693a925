// One screen: a GL context of its own, as for each projector's computer or window, with a renderer and a view of the
// shared crowd.
#pragma once

#include <optional>

#include "samples/contexts/offscreen.h"
#include "samples/hosts/multichannel/forum.h"
#include "samples/hosts/multichannel/people.h"

namespace multichannel
{

// The columns of a surface that a channel draws, in pixels: all of them, or with glScissor some columns of a surface
// that spans the wall.
struct Pane {
    int surface_width, left, width, height;
};

class Channel
{
public:
    // No context is current on this thread afterwards.
    Channel(scenes::Library &library, const People &people, const Forum &forum, const Pane &pane);
    ~Channel();
    Channel(const Channel &) = delete;
    Channel &operator=(const Channel &) = delete;

    // Draws other columns of the surface from now on. Call it as set_camera(); no context is current afterwards.
    void show_columns(int left, int width);
    // Call this before clq_crowd_update, on the crowd's thread. The camera is that of the whole surface.
    void set_camera(const clq_camera &camera);
    clq_view *view() const { return view_.get(); }

    // Call this after the update, on any one thread. Returns the pane, three bytes a pixel, top row first, valid until
    // the next call. No context is current afterwards.
    const std::vector<uint8_t> &draw();

    int width() const { return pane_.width; }
    int height() const { return pane_.height; }
    clq_view_stats stats() const;
    const std::string &context_name() const { return offscreen_->name(); }

private:
    void keep_to_pane();
    void cull_by_pane();

    const People &people_;
    const Forum &forum_;
    Pane pane_;
    std::unique_ptr<contexts::Offscreen> offscreen_;
    scenes::Gl gl_;
    std::optional<Forum::Pictures> pictures_;
    scenes::Own<clq_renderer> renderer_;
    scenes::Own<clq_view> view_;
    scenes::Eye eye_ = {};
    std::vector<uint8_t> surface_, rgb_;
};

}  // namespace multichannel
