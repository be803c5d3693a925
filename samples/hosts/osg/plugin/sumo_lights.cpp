#include "samples/hosts/osg/plugin/sumo_lights.h"

#include <osg/Geode>
#include <osg/Sequence>
#include <osg/Switch>
#include <osg/Transform>

namespace osg_plugin
{
namespace
{

// The tail lights; two indicators that blink, and the brake lights.
bool carries_lights(const osg::Group &group)
{
    if (group.getNumChildren() != 2 || !group.getChild(0)->asGeode()) return false;
    const osg::Switch *lights = group.getChild(1)->asSwitch();
    return lights && lights->getNumChildren() == 3 && dynamic_cast<const osg::Sequence *>(lights->getChild(0)) &&
           dynamic_cast<const osg::Sequence *>(lights->getChild(1)) && lights->getChild(2)->asGeode();
}

}  // namespace

void hide_lights(const osg::NodePath &person)
{
    constexpr size_t below = 4;  // the transforms of place and of size, the geode, its drawable
    osg::Group *place = person.size() > below ? person[person.size() - below]->asGroup() : nullptr;
    for (unsigned i = 0; place && i < place->getNumChildren(); ++i) {
        osg::Transform *beside = place->getChild(i)->asTransform();
        if (beside && beside->getNodeMask() != 0 && carries_lights(*beside)) beside->setNodeMask(0);
    }
}

}  // namespace osg_plugin
