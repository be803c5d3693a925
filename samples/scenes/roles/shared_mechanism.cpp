#include "samples/scenes/roles/shared_mechanism.h"

#include <dlfcn.h>

#include "samples/scenes/check.h"

namespace scenes::roles
{

SharedMechanism::SharedMechanism(const MechanismFile &file, const clq_template *tmpl)
{
    const std::string &path = file.path();
    object_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!object_) throw Failure("the mechanism cannot be loaded: " + std::string(dlerror()));
    const auto refuse = [&](const std::string &sentence) {
        dlclose(object_);
        throw Failure("the mechanism " + path + " " + sentence);
    };
    const auto entry = reinterpret_cast<claque_mechanism_entry>(dlsym(object_, CLAQUE_MECHANISM_ENTRY));
    if (!entry) refuse("exports no function " CLAQUE_MECHANISM_ENTRY " (samples/scenes/roles/mechanism.h)");
    described_ = entry();
    if (!described_ || described_->struct_bytes != sizeof *described_)
        refuse("is of another version: its description has " +
               std::to_string(described_ ? described_->struct_bytes : 0) + " bytes, " +
               std::to_string(sizeof *described_) + " are wanted");
    if (!described_->name || !described_->open || !described_->run || !described_->close)
        refuse("lacks its name or one of open, run and close");
    const char *why = nullptr;
    opened_ = described_->open(tmpl, clq_template_find_dof, &why);
    if (!opened_) refuse(why ? why : "does not fit this character");
}

SharedMechanism::~SharedMechanism()
{
    described_->close(opened_);
    dlclose(object_);
}

void SharedMechanism::run(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    const auto &self = *static_cast<SharedMechanism *>(user);
    self.described_->run(self.opened_, call, writer, clq_dof_write);
}

clq_host_mechanism_def SharedMechanism::host() { return {run, this, described_->has_memory}; }

}  // namespace scenes::roles
