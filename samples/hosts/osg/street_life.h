// The moving objects: omnibuses that drive through the town with people in them, people on its square, some of them
// under parasols, and the shadows of all.
#pragma once

#include <vector>

#include <osg/Geometry>
#include <osg/MatrixTransform>

#include "samples/hosts/osg/crowd_node.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/town/passengers.h"

namespace osg_host
{

class StreetLife
{
public:
    static constexpr size_t parasol_count = 9;

    // `crowd` is of these passengers; it becomes the last child of root().
    StreetLife(scenes::town::Passengers &passengers, CrowdNode &crowd);

    osg::Group &root() const { return *root_; }
    const std::vector<osg::ref_ptr<osg::Node>> &omnibuses() const { return omnibuses_; }  // one for each group
    // The actor that holds parasol `number`.
    clq_actor holder(size_t number) const;

    void move(double time_s);  // in the update traversal, or before the frame

private:
    struct Moving {
        osg::ref_ptr<osg::MatrixTransform> body, wheels[4];
    };
    void build_omnibuses(CrowdNode &crowd);
    void open_parasols(CrowdNode &crowd);
    void lay_shadows();

    scenes::town::Passengers &passengers_;
    osg::ref_ptr<osg::Group> root_;
    std::vector<osg::ref_ptr<osg::Node>> omnibuses_;
    std::vector<Moving> moving_;
    osg::ref_ptr<osg::Group> shadows_;
    scenes::Shadows cast_;
};

}  // namespace osg_host
