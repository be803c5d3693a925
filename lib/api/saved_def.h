// Mechanisms and paths that bytes brought, as a host would describe them: so that they meet the rules that a host's meet.
#pragma once

#include <claque/behave.h>

#include "lib/crowd/mechanism.h"

namespace claque::api
{

// A description and the arrays that it points at.
class MechanismDef
{
public:
    // Of a mechanism that may hold anything; throws base::Error (CLQ_FORMAT) where no description says the same.
    MechanismDef(const crowd::Mechanism &mechanism, std::pmr::memory_resource *memory);
    MechanismDef(const MechanismDef &) = delete;
    MechanismDef &operator=(const MechanismDef &) = delete;

    clq_mechanism_def def;

private:
    void tell(const crowd::Gaze &gaze);
    void tell(const crowd::Expression &expression);
    void tell(const crowd::Blink &blink);
    void tell(const crowd::Phrase &phrase);
    void tell(const crowd::Idle &idle);
    void tell(const crowd::HostMechanism &host);
    void take_values(const model::Array<crowd::DofValue> &values);
    void take_shapes(const model::Array<crowd::Shape> &shapes, const model::Array<crowd::DofValue> &values);

    model::Array<clq_dof_value> values_;
    model::Array<clq_shape> shapes_;
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
