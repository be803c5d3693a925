// Gives the crowd's calls for a role: what one individual is told to do (role.h).
#pragma once

#include "samples/scenes/roles/kit.h"
#include "samples/scenes/roles/objects.h"

namespace scenes::roles
{

class Performer
{
public:
    // `present`: what the individual does already, and what was not told by this performer. `kit` is that of its
    // template.
    Performer(clq_crowd *crowd, clq_actor actor, Kit &kit, const Role &present);

    // Makes the crowd's calls for what differs from the role performed last. Call it in each frame, before
    // clq_crowd_update with the same time. Throws Failure; the part that failed then stays as it was.
    void perform(const Role &role, double time_s);
    const Role &given() const { return given_; }

    Treadmill *treadmill() { return treadmill_; }          // null: it is not on one
    const clq_transform &place() const { return place_; }  // where it stands when nothing moves it

    // What it stands on; what it carries, in the pose of the last update.
    void draw_ground(const Gl &gl, const Eye &eye, double time_s) const;
    void draw_load(const Gl &gl, const Eye &eye) const;

private:
    void move(const Motion &motion, double time_s);
    void step_off(double time_s);
    void play(const Motion &motion);
    void drop_layers();
    void add_layers(const std::vector<Layer> &layers);
    Treadmill &treadmill_at(double speed_m_s);
    void face(const Face &face);
    void look(const Face &face);
    void fly(const Flight &flight);
    clq_root_path path_of(const Flight &flight);
    void carry(const std::vector<Carried> &load);
    void use_own(const MechanismFile &file);
    void hold(const std::map<std::string, float> &dofs);
    void attach(clq_mechanism mechanism, float priority) const;
    void detach(clq_mechanism mechanism) const;
    clq_play play_of(const Clip &clip) const;

    clq_crowd *crowd_;
    clq_actor actor_;
    Kit &kit_;
    Role given_;
    Home home_;
    clq_transform place_ = {};
    bool follows_own_ = false;                              // its clips come from the scene, as on a track
    std::map<int, std::unique_ptr<Treadmill>> treadmills_;  // by cm/s
    Treadmill *treadmill_ = nullptr;
    // The root paths of the corners flown last, by cm/s: a crowd keeps its root paths, and a speed may be dragged.
    std::vector<double> flown_;
    std::map<long, clq_root_path> flights_;
    int64_t lap_ = 0;
    std::vector<clq_layer> layers_;
    std::vector<clq_attachment> attached_;
};

// What the crowd says of an individual, as a role.
Role present_role(clq_crowd *crowd, clq_actor actor);
Home home_of(const clq_transform &place);
// Where an individual stands: as it was put, or where a track has it.
clq_transform place_of(const clq_actor_info &info);

}  // namespace scenes::roles
