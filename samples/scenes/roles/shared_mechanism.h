// A host's own mechanism, loaded from a shared object (mechanism.h).
#pragma once

#include <memory>
#include <string>

#include "samples/scenes/roles/mechanism.h"
#include "samples/scenes/roles/mechanism_file.h"

namespace scenes::roles
{

// Must live as long as the crowd that uses it.
class SharedMechanism
{
public:
    // Throws Failure with one sentence if the file is missing, is no such object, or does not fit the template.
    SharedMechanism(const MechanismFile &file, const clq_template *tmpl);
    ~SharedMechanism();
    SharedMechanism(const SharedMechanism &) = delete;
    SharedMechanism &operator=(const SharedMechanism &) = delete;

    const char *name() const { return described_->name; }
    clq_host_mechanism_def host();

private:
    static void run(void *user, const clq_behaviour_call *call, clq_dof_writer *writer);

    void *object_ = nullptr;
    const claque_mechanism *described_ = nullptr;
    void *opened_ = nullptr;
};

}  // namespace scenes::roles
