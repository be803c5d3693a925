// The agents of a stage that walk, as bytes.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/movement.h"

namespace claque::walk
{

using stage::bad_save;
using stage::numbers;

void Walking::walk_pieces(stage::SaveWriter &out, Person &person)
{
    out.count(person.pieces.size(), 19);
    for (Shown &piece : person.pieces) {
        numbers(out, piece.begin_s, piece.end_s, piece.given, piece.rises);
        std::vector<uint8_t> bytes = bytes_of(piece.track.get());
        out.count(bytes.size(), 1);
        out.raw(bytes);
    }
}

void Walking::walk_pieces(stage::SaveReader &in, Person &person)
{
    const size_t count = in.count(0, 19);
    for (size_t k = 0; k < count; ++k) {
        Shown piece;
        numbers(in, piece.begin_s, piece.end_s, piece.given, piece.rises);
        std::vector<uint8_t> bytes(in.count(0, 1));
        in.raw(bytes);
        if (!person.walker.locomotion) bad_save("an agent without a gait has a track");
        piece.track = track_of(person.walker.locomotion, bytes);
        const double before_s = person.pieces.empty() ? -1e300 : person.pieces.back().end_s - 1e-6;
        if (!(piece.begin_s >= before_s && piece.end_s > piece.begin_s)) bad_save("an agent's pieces have no order");
        person.pieces.push_back(std::move(piece));
    }
}

template <class Archive>
void Walking::walk_person(Archive &archive, Person &one, const Locomotions &locomotions)
{
    stage::number_of_enum(archive, one.is, Person::Is::settled);
    if (one.is == Person::Is::away) return;
    auto number = static_cast<uint32_t>(std::find(locomotions.begin(), locomotions.end(), one.walker.locomotion) -
                                        locomotions.begin());
    archive.number(number);
    if (number >= locomotions.size()) bad_save("an agent has a gait that is not given");
    one.walker.locomotion = locomotions[number];
    numbers(archive, one.walker.seed, one.walker.position[0], one.walker.position[1], one.walker.position[2],
            one.walker.heading_rad, one.walker.scale, one.walker.radius_m, one.at_s, one.id.index1, one.id.generation,
            one.goes);
    numbers(archive, one.goal.position[0], one.goal.position[1], one.goal.position[2], one.goal.near_m,
            one.goal.speed_m_s, one.goal.heading_rad, one.goal.request, one.goal.settles);
    numbers(archive, one.settled_s, one.leaves_s, one.rises);
    bool good = std::isfinite(one.walker.heading_rad) && (!one.goal.settles || std::isfinite(one.goal.heading_rad)) &&
                one.walker.scale > 0 && one.goal.near_m > 0 && std::isfinite(one.at_s);
    for (int k = 0; k < 3; ++k)
        good = good && std::isfinite(one.walker.position[k]) && std::isfinite(one.goal.position[k]);
    if (!good) bad_save("an agent that walks has a number that none has");
    walk_pieces(archive, one);
}

void Walking::save(std::vector<uint8_t> &out) const
{
    stage::SaveWriter writer;
    auto &self = const_cast<Walking &>(*this);  // one list of fields for both directions, which changes nothing here
    walkers_->save(writer, locomotions_);
    stage::list(writer, self.people_, 1, [&](Person &one) { walk_person(writer, one, locomotions_); });
    stage::list(writer, self.arrivals_, 21,
                [&](stage::Arrival &one) { numbers(writer, one.agent, one.request, one.time_s, one.reached); });
    out.insert(out.end(), writer.bytes.begin(), writer.bytes.end());
}

void Walking::restore(const uint8_t *bytes, size_t size_bytes)
{
    stage::SaveReader reader(bytes, size_bytes);
    auto walkers = std::make_unique<Walkers>(navigation_, def_);
    std::vector<Person> people;
    std::vector<stage::Arrival> arrivals;
    std::vector<stage::AgentIndex> agent_of(def_.max_count);
    const Walkers::Doors doors = walkers->restore(reader, locomotions_);
    stage::list(reader, people, 1, [&](Person &one) { walk_person(reader, one, locomotions_); });
    stage::list(reader, arrivals, 21, [&](stage::Arrival &one) {
        numbers(reader, one.agent, one.request, one.time_s, one.reached);
        if (one.agent >= people.size()) bad_save("an agent that arrived does not walk");
    });
    if (reader.left() != 0) bad_save("there are bytes too many");
    for (stage::AgentIndex i = 0; i < people.size(); ++i) {
        if (people[i].is != Person::Is::here) continue;
        if (!walkers->knows(people[i].id)) bad_save("an agent is no walker");
        agent_of[people[i].id.index1 - 1] = i;
    }
    // Nothing below throws.
    walkers->set_doors(doors);
    walkers_ = std::move(walkers);
    people_.swap(people), arrivals_.swap(arrivals), agent_of_.swap(agent_of);
}

}  // namespace claque::walk
