// A claque crowd in a Coin scenegraph: an SoCallback, with which Coin's manual tells programs to draw by themselves.
// Transforms above it may move and turn the crowd's world, and must not scale it.
#pragma once

#include <claque/claque.h>

#include <map>
#include <string>
#include <vector>

#include <Inventor/SbBox3f.h>
#include <Inventor/nodes/SoCallback.h>

class SoGLRenderAction;

namespace coin_host
{

class CrowdCallback
{
public:
    // None is owned; all must outlive this. `bounds` holds all people, for near and far planes and for viewAll.
    CrowdCallback(clq_context *context, clq_crowd *crowd, std::vector<clq_template *> templates, const SbBox3f &bounds);
    ~CrowdCallback();
    CrowdCallback(const CrowdCallback &) = delete;
    CrowdCallback &operator=(const CrowdCallback &) = delete;

    SoCallback *node() const { return node_; }                          // must not outlive this
    void set_time(double time_s) { time_s_ = time_s, node_->touch(); }  // Coin draws anew
    const std::string &failure() const { return failure_; }             // of the last frame, or ""
    const clq_draw_stats &drawn() const { return drawn_; }

private:
    static void called(void *self, SoAction *action);
    void draw(SoGLRenderAction &action);
    clq_renderer *renderer_of(uint32_t context_id);

    clq_context *context_;
    clq_crowd *crowd_;
    std::vector<clq_template *> templates_;
    clq_view *view_ = nullptr;
    SoCallback *node_ = new SoCallback;
    SbBox3f bounds_;
    double time_s_ = 0;
    std::map<uint32_t, clq_renderer *> renderers_;  // by Coin's number of the GL context
    std::string failure_;
    clq_draw_stats drawn_ = clq_draw_stats_init();
};

}  // namespace coin_host
