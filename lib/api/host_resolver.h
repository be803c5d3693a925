// What a saved or recorded crowd does not contain, from the host: templates, and the callbacks of host mechanisms.
#pragma once

#include <map>

#include "lib/api/crowd_handle.h"
#include "lib/crowd/save.h"

namespace claque::api
{

// Of host mechanisms, by number from 1.
using LentMechanisms = std::pmr::map<uint32_t, clq_host_mechanism_def>;

class HostResolver : public crowd::Resolver
{
public:
    // `lent` may be null. Mechanisms that are not lent take the callback of the crowd's own one of that number.
    HostResolver(const clq_crowd &crowd, clq_template *const *templates, uint32_t count,
                 const LentMechanisms *lent = nullptr);

    const model::Template &find_template(std::string_view name, uint64_t structure) override;
    void add(crowd::Behaviours &out, uint32_t index, crowd::Mechanism &&mechanism) override;
    void add(crowd::Behaviours &out, uint32_t index, crowd::RootPath &&path) override;

    const std::pmr::vector<clq_template *> &used() const { return used_; }

private:
    void lend(uint32_t index, crowd::HostMechanism &host) const;

    const clq_crowd &crowd_;
    const LentMechanisms *lent_;
    std::pmr::vector<clq_template *> left_, used_;
};

// Takes the first template of this name and structure out of `left`. Throws base::Error (CLQ_ARGUMENT).
clq_template *take_template(std::pmr::vector<clq_template *> &left, std::string_view name, uint64_t structure,
                            const char *whose);

// Throws base::Error (CLQ_ARGUMENT): NULL, of another context, twice.
void check_templates(const clq_context *context, clq_template *const *templates, uint32_t count);

// Replaces the crowd's state by a saved one; holds what that uses.
void restore_state(clq_crowd *crowd, const uint8_t *bytes, size_t size, HostResolver &resolver);

}  // namespace claque::api
