// The people of a run: their characters, and one actor for each, which appears when its agent does.
#pragma once

#include "samples/scenes/scenario/scenario.h"
#include "samples/scenes/walkers/cast.h"

namespace staged
{

struct Person {
    size_t agents = 0;  // of Staging::agents
    size_t member = 0;  // of the cast
    clq_actor actor = {};
    uint64_t seed = 0;
    float scale = 1;
    clq_mechanism gaze = {};  // {0}: its character has nothing to turn
};

class People
{
public:
    // `walk`: they are away until their first piece of a track; otherwise they are there from the beginning.
    People(scenes::Library &library, const scenes::CrowdOptions &crowd_options, const scenes::Scenario &scenario,
           bool walk);

    clq_crowd *crowd() const { return crowd_.crowd(); }
    const std::vector<clq_actor> &actors() const { return crowd_.actors(); }
    const std::vector<Person> &all() const { return all_; }
    const scenes::walkers::Member &member(const Person &person) const { return cast_[person.member]; }
    const std::vector<scenes::walkers::Member> &cast() const { return cast_; }
    std::vector<clq_template *> templates() const;
    // The actor of a person is nowhere from now on.
    void send_away(size_t person);
    // The crowd as clq_crowd_save wrote it.
    void restore(const std::vector<uint8_t> &crowd, const std::vector<clq_template *> &all);

private:
    void enter(Person &person, bool walk);
    void let_look(scenes::Library &library);

    std::vector<scenes::walkers::Member> cast_;
    scenes::SceneCrowd crowd_;
    std::vector<scenes::walkers::OwnTrack> away_;  // by member
    std::vector<Person> all_;
};

}  // namespace staged
