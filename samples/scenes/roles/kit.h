// What the performers of one template in one crowd share: masks, mechanisms, its locomotion. A crowd keeps masks and
// mechanisms as long as it lives, so each is made once.
#pragma once

#include <map>
#include <memory>

#include "samples/scenes/roles/faces.h"
#include "samples/scenes/roles/role.h"
#include "samples/scenes/roles/shared_mechanism.h"
#include "samples/scenes/roles/treadmill.h"

namespace scenes::roles
{

class Kit
{
public:
    Kit(Library &library, clq_crowd *crowd, clq_template *tmpl);

    Library &library() { return library_; }
    clq_template *tmpl() const { return tmpl_; }
    const Faces &faces() const { return faces_; }

    // Each throws Failure if the template has nothing for it.
    uint32_t clip(const std::string &name) const;  // CLQ_NONE for ""
    uint32_t node(const std::string &name) const;
    clq_mask mask(const std::string &joint, bool inverted);
    clq_mechanism gaze();
    clq_mechanism blink();
    clq_mechanism expression();
    uint32_t expression_named(const std::string &name) const;
    clq_mechanism phrase(const std::string &text);
    clq_mechanism own(const MechanismFile &file);
    const char *own_name(const MechanismFile &file);
    const clq_locomotion *walk();
    // Its values are those of by_hand.
    clq_mechanism hand();
    std::map<uint32_t, std::vector<float>> by_hand;  // by actor and degree of freedom; NaN: left alone

private:
    clq_mechanism add(const clq_mechanism_def &def) const;
    clq_mechanism_def def_of(clq_mechanism_kind kind) const;

    Library &library_;
    clq_crowd *crowd_;
    clq_template *tmpl_;
    Faces faces_;
    std::map<std::pair<std::string, bool>, clq_mask> masks_;
    std::map<std::string, clq_mechanism> phrases_, owns_;
    std::map<std::string, std::unique_ptr<SharedMechanism>> loaded_;
    clq_mechanism gaze_ = {}, blink_ = {}, expression_ = {}, hand_ = {};
    walkers::Member member_;
};

}  // namespace scenes::roles
