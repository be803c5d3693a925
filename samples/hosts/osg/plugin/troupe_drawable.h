// A troupe as a drawable, which one leaf of each view draws.
#pragma once

#include <mutex>

#include <osg/Drawable>

#include "samples/hosts/osg/plugin/renderers.h"
#include "samples/hosts/osg/plugin/troupe.h"
#include "samples/hosts/osg/plugin/warning.h"

namespace osg_plugin
{

class Company;

class TroupeDrawable : public osg::Drawable
{
public:
    explicit TroupeDrawable(Company &company);  // which must outlive it

    // Once for each individual and traversal, from the cull traversal.
    void report(osgUtil::CullVisitor &visitor, const Member &member);
    void drawImplementation(osg::RenderInfo &info) const override;

private:
    Company &company_;
    mutable Troupe troupe_;
    mutable Warning warning_;
};

// The root of a path is the first node below its last camera.
osg::Node *root_of(const osg::NodePath &nodes);

}  // namespace osg_plugin
