#include "samples/stage/people.h"

#include <algorithm>
#include <map>

#include "samples/scenes/random.h"
#include "samples/scenes/roles/gaze.h"

namespace staged
{

using namespace scenes;

namespace
{

// A track that was over before the run began: its actor is nowhere.
walkers::OwnTrack past(const walkers::Member &member)
{
    clq_track_point points[2] = {};
    points[0].time_s = -1001, points[1].time_s = -1000;
    clq_track_def def = clq_track_def_init();
    def.points = points, def.point_count = 2;
    clq_track *made = nullptr;
    check(clq_track_create(member.locomotion.get(), &def, &made));
    return walkers::OwnTrack(made);
}

}  // namespace

People::People(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario, bool walk)
    : crowd_(library, crowd_options)
{
    for (const SocialClass &one : scenario.characters)
        cast_.push_back(walkers::cast(library, one, crowd_options.lod, walkers::Heads::turn));
    for (const walkers::Member &member : cast_) away_.push_back(past(member));
    const std::vector<ScenarioAgents> &agents = scenario.stage->agents;
    for (size_t i = 0; i < agents.size(); ++i)
        for (uint32_t k = 0; k < agents[i].count; ++k) {
            const uint64_t number = all_.size();
            Person person;
            person.agents = i, person.member = agents[i].member;
            person.seed = random_bits(crowd_options.seed, number, Purpose::act);
            const double size = random_between(crowd_options.seed, number, Purpose::size, 0.95, 1.05);
            person.scale = static_cast<float>(cast_[person.member].scale * size);
            enter(person, walk);
        }
    let_look(library);
}

// A gaze for each character. It ends where a head is a few pixels high.
void People::let_look(Library &library)
{
    constexpr float heads_stop_m = 45;
    std::map<const clq_template *, clq_mechanism> gazes;
    for (Person &person : all_) {
        clq_template *tmpl = cast_[person.member].tmpl;
        if (gazes.count(tmpl) == 0) {
            const roles::Faces faces = roles::faces_of(tmpl);
            clq_mechanism made = {};
            if (faces.looks) {
                clq_mechanism_def def = clq_mechanism_def_init();
                def.kind = CLQ_MECHANISM_GAZE, def.tmpl = tmpl, def.off_m = heads_stop_m;
                def.gaze = roles::gaze_of(library, tmpl, faces);
                def.gaze.wander_s = 0;
                check(clq_crowd_add_mechanism(crowd_.crowd(), &def, &made));
            }
            gazes[tmpl] = made;
        }
        person.gaze = gazes[tmpl];
        if (person.gaze.index1 == 0) continue;
        clq_mechanism_attachment use = clq_mechanism_attachment_init();
        use.mechanism = person.gaze;
        check(clq_actor_attach_mechanism(crowd_.crowd(), person.actor, &use));
    }
}

void People::enter(Person &person, bool walk)
{
    const walkers::Member &member = cast_[person.member];
    clq_transform place = clq_transform_init();
    place.scale = person.scale;
    const SceneCrowd::Part part = {member.tmpl, place, clq_play_init()};
    if (member.described.palette.empty()) crowd_.enter(part);
    else crowd_.enter(part, person.seed, ranges_of(member.tmpl, member.described));
    person.actor = crowd_.actors().back();
    all_.push_back(person);
    if (walk) send_away(all_.size() - 1);
}

void People::send_away(size_t person)
{
    const Person &one = all_[person];
    check(clq_actor_follow_track(crowd_.crowd(), one.actor, away_[one.member].get(), 0));
}

void People::restore(const std::vector<uint8_t> &crowd, const std::vector<clq_template *> &all)
{
    for (const walkers::OwnTrack &track : away_) check(clq_crowd_add_track(crowd_.crowd(), track.get()));
    check(clq_crowd_restore(crowd_.crowd(), crowd.data(), crowd.size(), all.data(), static_cast<uint32_t>(all.size())));
}

std::vector<clq_template *> People::templates() const
{
    std::vector<clq_template *> all;
    for (const walkers::Member &member : cast_)
        if (std::find(all.begin(), all.end(), member.tmpl) == all.end()) all.push_back(member.tmpl);
    return all;
}

}  // namespace staged
