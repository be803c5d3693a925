// The town as a scenegraph: each piece a node with a bounding sphere by which OSG culls, fine and coarse forms under
// an osg::LOD, materials as shared state sets.
#pragma once

#include <vector>

#include <osg/Group>

#include "samples/scenes/town/town.h"

namespace osg_host
{

struct TownGraph {
    osg::ref_ptr<osg::Group> root;  // sky and pieces
    std::vector<osg::ref_ptr<osg::Node>> pieces;
};

TownGraph graph_of(const scenes::town::Town &town);

// Light and haze for the whole scene, and materials that follow colours.
void light(osg::Group &root);

// In the order of scenes::town::SurfaceKind; people come between tiles and leaves.
constexpr int people_bin = 9;
int bin_of(scenes::town::SurfaceKind layer);

}  // namespace osg_host
