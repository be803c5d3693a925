// The people of one description: their template, their steps measured, and what colours them.
#pragma once

#include "samples/hosts/osg/plugin/person_file.h"
#include "samples/scenes/colours.h"
#include "samples/scenes/walkers/cast.h"

namespace osg_plugin
{

class Member
{
public:
    // Throws scenes::Failure, with the place in the description.
    Member(scenes::Library &library, const PersonFile &file);

    clq_template *tmpl() const { return cast_.tmpl; }
    double scale() const { return cast_.scale; }           // to the size of a person
    double stride() const { return stride_; }              // model units of a cycle of its gait
    clq_play gait_at(double phase) const;                  // [0, 1), held there
    clq_play idle(uint64_t seed) const;                    // to stand with
    void colour(clq_crowd *crowd, clq_actor actor) const;  // by the seed of the actor

private:
    scenes::walkers::Member cast_;
    uint32_t clip_ = CLQ_NONE;
    double clip_s_ = 0, stride_ = 1;
    std::vector<uint32_t> idles_;
    std::vector<clq_hsb_range> ranges_;
    scenes::ColourMap map_;  // in place of the ranges
    uint32_t colour_class_ = CLQ_NONE;
};

}  // namespace osg_plugin
