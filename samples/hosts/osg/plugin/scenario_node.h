// The node that a scenario (docs/scenarios.md) becomes: its people and all that is round them, with z up.
#pragma once

#include <string>

#include <osg/Node>

namespace osg_plugin
{

// Throws scenes::Failure. One GL context draws it: other windows leave it out, and say so.
osg::ref_ptr<osg::Node> scenario_node(const std::string &path);

}  // namespace osg_plugin
