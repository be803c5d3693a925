#include "samples/hosts/osg/crowd_node.h"

#include <cmath>
#include <limits>

#include <osg/Drawable>

#include "samples/hosts/osg/bindings.h"

namespace osg_host
{

// Foreign GL in OSG's draw traversal.
class CrowdNode::People : public osg::Drawable
{
public:
    People(clq_renderer *renderer, clq_view *view) : renderer_(renderer), view_(view)
    {
        setSupportsDisplayList(false);
        setUseVertexBufferObjects(false);
        setCullingActive(false);  // claque has culled them
    }

    void drawImplementation(osg::RenderInfo &info) const override
    {
        clear_bindings(*info.getState());
        if (clq_renderer_draw(renderer_, view_, &drawn) != CLQ_OK) failure = clq_last_error();
    }

    mutable std::string failure;
    mutable clq_draw_stats drawn = clq_draw_stats_init();

private:
    clq_renderer *renderer_;
    clq_view *view_;
};

// Called for nodes that OSG has not culled.
class CrowdNode::Gate : public osg::NodeCallback
{
public:
    Gate(clq_group of, osg::Node &node) : group(of) { node.addCullCallback(this); }
    void operator()(osg::Node *node, osg::NodeVisitor *visitor) override
    {
        open = true;
        osg::NodeCallback::traverse(node, visitor);
    }
    clq_group group;
    bool open = false;
};

CrowdNode::CrowdNode(clq_crowd *crowd, clq_renderer *renderer) : crowd_(crowd)
{
    note(clq_view_create(crowd, &view_));
    people_ = new People(renderer, view_);
    addChild(people_);
    setCullingActive(false);
}

CrowdNode::~CrowdNode() { clq_view_destroy(view_); }

void CrowdNode::gate(osg::Node &node, clq_group group) { gates_.push_back(new Gate(group, node)); }

void CrowdNode::hold(clq_actor actor, const char *joint, osg::Node &object, float radius_m)
{
    clq_actor_info info = clq_actor_info_init();
    note(clq_actor_get_info(crowd_, actor, &info));
    clq_attachment_def def = clq_attachment_def_init();
    def.node = clq_template_find_node(info.tmpl, joint);
    def.radius = radius_m;
    note(clq_actor_attach(crowd_, actor, &def, nullptr));
    held_.push_back({actor, def.node, new osg::MatrixTransform, false});
    held_.back().place->addChild(&object);
    addChild(held_.back().place);
}

void CrowdNode::set_height(float height_px) { note(clq_view_set_height(view_, height_px)); }
void CrowdNode::set_cull_scale(float scale) { note(clq_view_set_cull_scale(view_, scale)); }
const std::string &CrowdNode::failure() const { return failure_.empty() ? people_->failure : failure_; }
const clq_draw_stats &CrowdNode::drawn() const { return people_->drawn; }

void CrowdNode::note(clq_status status)
{
    if (status != CLQ_OK) failure_ = clq_last_error();
}

bool CrowdNode::is_shown(clq_actor actor) const
{
    clq_actor_info info = clq_actor_info_init();
    return clq_actor_get_info(crowd_, actor, &info) == CLQ_OK && info.visible;
}

void CrowdNode::traverse(osg::NodeVisitor &visitor)
{
    osgUtil::CullVisitor *cull = visitor.asCullVisitor();
    if (!cull) return osg::Group::traverse(visitor);
    update(*cull, visitor.getFrameStamp()->getSimulationTime());
    people_->accept(visitor);
    cull_held(*cull);
}

// Runs in the cull traversal, after all gating nodes were visited or culled.
void CrowdNode::update(osgUtil::CullVisitor &visitor, double time_s)
{
    for (const osg::ref_ptr<Gate> &gate : gates_) {
        note(clq_group_set_enabled(crowd_, gate->group, gate->open));
        gate->open = false;
    }
    clq_camera camera = {};
    const osg::Matrixd &to_eye = *visitor.getModelViewMatrix(), &projection = *visitor.getProjectionMatrix();
    const osg::Vec3d eye = osg::Matrixd::inverse(to_eye).getTrans();
    const osg::Quat turn = to_eye.getRotate();
    for (int i = 0; i < 3; ++i) camera.eye[i] = eye[i];
    for (int i = 0; i < 4; ++i) camera.rotation_xyzw[i] = static_cast<float>(turn[i]);
    for (int i = 0; i < 16; ++i) camera.projection[i] = static_cast<float>(projection.ptr()[i]);
    note(clq_view_set_camera(view_, &camera));
    note(clq_crowd_update(crowd_, time_s, &view_, 1));
}

// A culled actor takes its held objects along.
void CrowdNode::cull_held(osgUtil::CullVisitor &visitor)
{
    constexpr double now_shown = std::numeric_limits<double>::quiet_NaN();
    for (Held &held : held_) {
        double joint[16];
        held.shown = is_shown(held.actor);
        if (!held.shown) continue;
        note(clq_actor_get_node(crowd_, held.actor, held.joint, now_shown, joint));
        held.place->setMatrix(osg::Matrixd::translate(joint[12], joint[13], joint[14]));
        held.place->accept(visitor);
    }
}

}  // namespace osg_host
