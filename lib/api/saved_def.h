// Converts restored mechanisms and paths to public descriptions, so that they are checked by the same rules as a
// host's.
#pragma once

#include <claque/behave.h>

#include "lib/crowd/mechanism.h"

namespace claque::api
{

// A description and the arrays that it points at.
class MechanismDef
{
public:
    // For a mechanism of any content; throws base::Error (CLQ_FORMAT) if no description can express it.
    MechanismDef(const crowd::Mechanism &mechanism, std::pmr::memory_resource *memory);
    MechanismDef(const MechanismDef &) = delete;
    MechanismDef &operator=(const MechanismDef &) = delete;

    clq_mechanism_def def;

private:
    void describe(const crowd::Gaze &gaze);
    void describe(const crowd::Expression &expression);
    void describe(const crowd::Blink &blink);
    void describe(const crowd::Phrase &phrase);
    void describe(const crowd::Idle &idle);
    void describe(const crowd::HostMechanism &host);
    void copy_values(const model::Array<crowd::DofValue> &values);
    void copy_poses(const model::Array<crowd::DofPose> &shapes, const model::Array<crowd::DofValue> &values);

    model::Array<clq_dof_value> values_;
    model::Array<clq_dof_pose> poses_;
    model::Array<clq_phrase_key> keys_;
};

class RootPathDef
{
public:
    RootPathDef(const crowd::RootPath &path, std::pmr::memory_resource *memory);
    RootPathDef(const RootPathDef &) = delete;
    RootPathDef &operator=(const RootPathDef &) = delete;

    clq_root_path_def def;

private:
    model::Array<float> positions_, rotations_;
};

}  // namespace claque::api
