#include "samples/hosts/osg/plugin/scenario_node.h"

#include <algorithm>
#include <cmath>

#include <osg/GL>
#include <osg/Geode>
#include <osg/Viewport>
#include <osgUtil/CullVisitor>

#include "samples/hosts/osg/bindings.h"
#include "samples/hosts/osg/plugin/company.h"
#include "samples/hosts/osg/plugin/up_axis.h"
#include "samples/hosts/osg/plugin/warning.h"
#include "samples/scenes/scenario/scenario.h"

namespace osg_plugin
{
namespace
{

using scenes::check;

// osg::State believes that GL is as it left it.
class Kept
{
public:
    Kept()
    {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
        for (const GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) glMatrixMode(mode), glPushMatrix();
    }
    ~Kept()
    {
        for (const GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) glMatrixMode(mode), glPopMatrix();
        glPopClientAttrib();
        glPopAttrib();
    }
    Kept(const Kept &) = delete;
    Kept &operator=(const Kept &) = delete;
};

constexpr float around_m = 1000;  // that can be seen; a viewer's near plane is then at half a metre

// The ground and the sky reach beyond the bounds by which viewers choose where they begin.
struct SeesAround : osg::DrawableCullCallback {
    bool cull(osg::NodeVisitor *visitor, osg::Drawable *, osg::RenderInfo *) const override
    {
        osgUtil::CullVisitor *cull = visitor->asCullVisitor();
        if (cull && cull->getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR)
            cull->updateCalculatedNearFar(*cull->getModelViewMatrix(), osg::BoundingBox(-around_m, -around_m, -around_m,
                                                                                        around_m, around_m, around_m));
        return false;
    }
};

class ScenarioDrawable : public osg::Drawable
{
public:
    explicit ScenarioDrawable(const std::string &path)
        : company_(Company::shared()), scenario_(scenes::load_scenario(path))
    {
        setSupportsDisplayList(false);
        setUseVertexBufferObjects(false);
        setDataVariance(DYNAMIC);
        setCullingActive(false);  // its scenery culls itself, or is all round
        setCullCallback(new SeesAround);
        make();
        place_bounds();
    }

    void drawImplementation(osg::RenderInfo &info) const override
    {
        const std::lock_guard<std::mutex> lock(company_.mutex());
        try {
            draw(*info.getState());
        } catch (const scenes::Failure &failure) {
            warning_.give(failure);
        }
    }

    void releaseGLObjects(osg::State *state) const override
    {
        if (!state) return;
        company_.release(*state);
        const std::lock_guard<std::mutex> lock(company_.mutex());
        if (state == state_.get()) scene_.reset(), state_ = nullptr;
    }

private:
    void make() const
    {
        scenes::CrowdOptions options;
        options.count = 0;
        options.lod = scenes::Lod::on;
        prepared_ = false;
        scene_ = scenes::make_scenario(company_.library(), options, scenario_);
        check(clq_view_create(scene_->crowd(), &view_));
    }

    // Viewers begin where they see these, looking along +y: about what the scene's own camera looks at.
    void place_bounds()
    {
        const clq_camera camera = scene_->camera(scenes::Shot::overview, 4.0 / 3, scene_->busiest_s());
        const scenes::Eye eye = scenes::eye_of(camera);
        const osg::Vec3d from(eye.position[0], -eye.position[2], eye.position[1]);
        const osg::Vec3d ahead(-eye.rotation[2], eye.rotation[10], -eye.rotation[6]);
        const double way = ahead.z() < -0.05 ? std::min(200.0, from.z() / -ahead.z()) : 20;
        const osg::Vec3d at = from + ahead * way;
        // A viewer's angle of 30 degrees holds a sphere of this size from nearly as far as the scene's camera is, and
        // sees the ground in its middle from this height.
        const double far = std::hypot(at.x() - from.x(), at.y() - from.y()), half = 0.145 * far;
        const osg::Vec3d centre(at.x(), at.y(), at.z() + std::min(0.5 * (from.z() - at.z()), 0.19 * far));
        const osg::Vec3d corner(half, half, half);
        setInitialBound(osg::BoundingBox(centre - corner, centre + corner));
    }

    void draw(osg::State &state) const
    {
        if (!scene_ || (prepared_ && !state_.valid())) make();
        const scenes::GetProcAddress get = get_gl_function;
        if (!state_.valid()) {
            std::string missing;
            if (!scenes::load(gl_, get, nullptr, missing)) throw scenes::Failure("this GL has no " + missing);
            const Kept kept;
            scene_->prepare(gl_);
            state_ = &state;
            prepared_ = true;
        }
        if (state_.get() != &state)
            throw scenes::Failure("the scenario '" + scenario_.name + "' is drawn in one window alone");
        osg_host::clear_bindings(state);
        clq_renderer *renderer = company_.renderer(state);
        for (clq_template *tmpl : scene_->templates()) check(clq_renderer_prepare(renderer, tmpl));
        const double time_s = state.getFrameStamp() ? state.getFrameStamp()->getSimulationTime() : 0;
        const clq_camera camera = camera_of(state.getModelViewMatrix(), state.getProjectionMatrix());
        scene_->place(time_s);
        check(clq_view_set_camera(view_, &camera));
        if (const osg::Viewport *viewport = state.getCurrentViewport())
            check(clq_view_set_height(view_, static_cast<float>(viewport->height())));
        check(clq_crowd_update(scene_->crowd(), time_s, &view_, 1));
        const scenes::Eye eye = scenes::eye_of(camera);
        const Kept kept;
        scene_->set_light(gl_, eye);
        check(clq_renderer_draw(renderer, view_, nullptr));
        scene_->draw_environment(gl_, eye);
        scene_->draw_things(gl_, eye);
    }

    Company &company_;
    scenes::Scenario scenario_;
    mutable std::unique_ptr<scenes::Scene> scene_;
    mutable clq_view *view_ = nullptr;
    mutable scenes::Gl gl_;
    mutable bool prepared_ = false;
    mutable osg::observer_ptr<osg::State> state_;  // of the context that has its textures
    mutable Warning warning_;
};

}  // namespace

osg::ref_ptr<osg::Node> scenario_node(const std::string &path)
{
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(new ScenarioDrawable(path));
    return node;
}

}  // namespace osg_plugin
