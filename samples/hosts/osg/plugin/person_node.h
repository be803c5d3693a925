// The node that a description of people becomes. Hang it below as many transforms as there are people: each path to it
// is an individual of its own, and all of them are drawn together.
#pragma once

#include <osg/Node>

#include "samples/hosts/osg/plugin/person_file.h"

namespace osg_plugin
{

// Throws scenes::Failure. z is up, the face is towards -y, and the node's bounds are those of a person of 1.72 m.
osg::ref_ptr<osg::Node> person_node(const PersonFile &file);

}  // namespace osg_plugin
