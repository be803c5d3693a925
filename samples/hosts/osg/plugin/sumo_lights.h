// SUMO hangs indicators, brake lights and tail lights on people, as on vehicles, and leaves them on.
#pragma once

#include <osg/Node>

namespace osg_plugin
{

// Hides those beside the person at the end of this path. Nothing else is built as they are, so the graphs of other
// programs stay as they are.
void hide_lights(const osg::NodePath &person);

}  // namespace osg_plugin
