#include "samples/hosts/osg/plugin/troupe_drawable.h"

#include <algorithm>

#include <osg/Camera>
#include <osg/Material>
#include <osg/Transform>

#include "samples/hosts/osg/bindings.h"
#include "samples/hosts/osg/plugin/company.h"
#include "samples/hosts/osg/plugin/sumo_lights.h"

namespace osg_plugin
{

TroupeDrawable::TroupeDrawable(Company &company) : company_(company), troupe_(company.library())
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(false);
    setDataVariance(DYNAMIC);  // what is drawn now must not meet the reports of the next frame
    // In place of materials and textures that a program gives to what it takes for a model.
    osg::StateSet &state = *getOrCreateStateSet();
    state.setAttributeAndModes(new osg::Material, osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    state.setMode(GL_BLEND, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
}

osg::Node *root_of(const osg::NodePath &nodes)
{
    size_t first = nodes.size() - 1;
    while (first > 0 && !nodes[first - 1]->asCamera()) --first;
    return nodes[first];
}

void TroupeDrawable::report(osgUtil::CullVisitor &visitor, const Member &member)
{
    const unsigned frame = visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
    const osg::Matrixd to_world = osg::computeLocalToWorld(visitor.getNodePath());
    const std::lock_guard<std::mutex> lock(company_.mutex());
    const osg::NodePath &nodes = visitor.getNodePath();
    const Troupe::Path path(std::find(nodes.begin(), nodes.end(), root_of(nodes)), nodes.end());
    troupe_.report(path, member, to_world, frame);
    hide_lights(nodes);
    if (!troupe_.begins(visitor, frame)) return;
    const osg::Matrixd world_to_eye = osg::Matrixd::inverse(to_world) * *visitor.getModelViewMatrix();
    visitor.pushStateSet(getStateSet());
    visitor.addDrawableAndDepth(this, new osg::RefMatrix(world_to_eye), 0);
    visitor.popStateSet();
}

void TroupeDrawable::drawImplementation(osg::RenderInfo &info) const
{
    const std::lock_guard<std::mutex> lock(company_.mutex());
    try {
        osg_host::clear_bindings(*info.getState());
        troupe_.draw(*info.getState(), company_.renderer(*info.getState()));
    } catch (const scenes::Failure &failure) {
        warning_.give(failure);
    }
}

}  // namespace osg_plugin
