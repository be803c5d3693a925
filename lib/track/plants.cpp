// When each foot stands, and where: the mean of the places at which its clip has it meanwhile.
#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "lib/math/trig.h"
#include "lib/track/footing.h"
#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

constexpr uint32_t min_plant = 4;  // samples: shorter contacts are no steps
constexpr uint32_t min_swing = 3;
constexpr double least_relief_m = 0.01;  // of a path whose ground is not level
// Of a straight leg's reach, and of how far a foot may be moved: clips to stand with move hips and feet.
constexpr double leg_share = 0.97, shift_share = 0.8;

struct Contact {
    uint32_t first, last;
};

// Places of the ball of a foot, metres from the track's origin.
struct Foot {
    explicit Foot(std::pmr::memory_resource *memory)
        : x(memory),
          z(memory),
          hip_x(memory),
          hip_z(memory),
          reach(memory),
          node_x(memory),
          node_z(memory),
          yaw(memory),
          down(memory)
    {
    }
    Array<double> x, z;
    Array<double> hip_x, hip_z, reach;  // GaitCell::reach in the world
    Array<double> node_x, node_z;       // of the foot, from its sole, in the space of the body
    Array<double> yaw;                  // to which it points in the world
    Array<uint8_t> down;
    const Footing *footing = nullptr;
    double leg_m = 0;           // its length
    bool follows_path = false;  // the ground is known from the path alone
};

Foot feet_of(const Locomotion &locomotion, const FinePath &path, double scale_m, int f)
{
    Foot foot(path.x.get_allocator().resource());
    const uint32_t count = path.count();
    for (Array<double> *column :
         {&foot.x, &foot.z, &foot.hip_x, &foot.hip_z, &foot.reach, &foot.node_x, &foot.node_z, &foot.yaw})
        column->resize(count);
    foot.down.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        const GaitCell cell = cell_at(locomotion, path.gait[i], path.turning[i], path.phase[i]);
        const double c = math::cos(path.heading[i]), s = math::sin(path.heading[i]);
        const double x = double(cell.x[f]) * scale_m, z = double(cell.z[f]) * scale_m;
        foot.x[i] = path.x[i] + x * c + z * s;
        foot.z[i] = path.z[i] - x * s + z * c;
        const double hip_x = double(cell.hip_x[f]) * scale_m, hip_z = double(cell.hip_z[f]) * scale_m;
        foot.hip_x[i] = path.x[i] + hip_x * c + hip_z * s;
        foot.hip_z[i] = path.z[i] - hip_x * s + hip_z * c;
        foot.reach[i] = double(cell.reach[f]) * scale_m;
        foot.node_x[i] = double(cell.node_x[f]) * scale_m, foot.node_z[i] = double(cell.node_z[f]) * scale_m;
        foot.yaw[i] = path.heading[i] + double(cell.yaw[f]);
        foot.down[i] = path.stands[i] || cell.supports[f] > 0.5f;
    }
    return foot;
}

Array<Contact> contacts_of(const Array<uint8_t> &down)
{
    Array<Contact> contacts(down.get_allocator().resource());
    const uint32_t count = static_cast<uint32_t>(down.size());
    for (uint32_t i = 0; i < count; ++i) {
        if (!down[i]) continue;
        Contact contact{i, i};
        while (contact.last + 1 < count && down[contact.last + 1]) ++contact.last;
        i = contact.last;
        if (!contacts.empty() && contact.first - contacts.back().last <= min_swing) contacts.back().last = contact.last;
        else contacts.push_back(contact);
    }
    contacts.erase(
        std::remove_if(contacts.begin(), contacts.end(), [](const Contact &c) { return c.last - c.first < min_plant; }),
        contacts.end());
    return contacts;
}

double mean(const Array<double> &values, const Contact &contact)
{
    double sum = 0;
    for (uint32_t i = contact.first; i <= contact.last; ++i) sum += values[i] - values[contact.first];
    return values[contact.first] + sum / (contact.last - contact.first + 1);
}

// Where a foot stands: the mean of its contact, or where the piece before has put it.
Stance stance_of(const Foot &foot, const FinePath &path, const Contact &contact, const Plant *held)
{
    if (!held) {
        Stance stance{mean(foot.x, contact), mean(foot.z, contact), mean(foot.yaw, contact)};
        const uint32_t middle = contact.first + (contact.last - contact.first) / 2;
        foot.footing->settle(stance, path.y[middle]);
        if (foot.follows_path) Footing::follow_path(path, middle, stance);
        return stance;
    }
    const double heading = foot.yaw[contact.first];
    return {double(held->x), double(held->z), nearest_turn(double(held->heading_rad), heading), double(held->y),
            double(held->slope)};
}

// How much of what its leg can do a foot needs at a sample to be at a place: the distance from where the clips have it,
// the straight leg, the turn against the body, and how far the hips would have to sink.
double strain(const Foot &foot, const FinePath &path, const Stance &place, uint32_t i, double max_shift_m)
{
    const double turn = place.heading_rad - path.heading[i];
    // The place of the body if the foot is turned against it by an angle.
    const auto node = [&](double foot_turn) {
        const double heading = path.heading[i] + foot_turn, c = math::cos(heading), s = math::sin(heading);
        return glm::dvec2(foot.node_x[i] * c + foot.node_z[i] * s, -foot.node_x[i] * s + foot.node_z[i] * c);
    };
    // The foot's node goes round the sole as the foot is turned.
    const glm::dvec2 wanted =
        glm::dvec2(place.x, place.z) +
        node(std::clamp(turn, -max_foot_turn_rad, max_foot_turn_rad) - (foot.yaw[i] - path.heading[i]));
    const glm::dvec2 clip = glm::dvec2(foot.x[i], foot.z[i]) + node(0), hip(foot.hip_x[i], foot.hip_z[i]);
    const double shift = glm::length(wanted - clip) / max_shift_m;
    // A clip may stretch a leg farther than that by itself.
    const double own_leg = glm::length(hip - clip);
    const double allowed = std::max(leg_share * foot.reach[i], 1.02 * own_leg);
    const double flat = glm::length(hip - wanted);
    const double below = path.y[i] - place.y;
    const double sink = below > 0 ? sink_wanted(foot.leg_m, foot.reach[i], flat, below) / (max_sink * foot.leg_m) : 0;
    return std::max({flat / allowed, shift, std::fabs(turn) / max_foot_turn_rad, sink});
}

// Adds what is left of a contact where the leg can hold the foot. A foot that the body leaves too far behind is lifted
// earlier, or comes down later; one round which the body turns is lifted in between.
void add_held(const Foot &foot, const FinePath &path, double max_shift_m, Contact contact, Array<Contact> &out)
{
    Array<Contact> left(out.get_allocator().resource());
    left.push_back(contact);
    while (!left.empty()) {
        Contact &now = left.back();
        if (now.last < now.first + min_plant) {
            left.pop_back();
            continue;
        }
        const Stance place = stance_of(foot, path, now, nullptr);
        double worst = 0;
        uint32_t at = now.first;
        for (uint32_t i = now.first; i <= now.last; ++i) {
            const double here = strain(foot, path, place, i, max_shift_m);
            if (here > worst) worst = here, at = i;
        }
        if (worst < 1) {
            out.push_back(now);
            left.pop_back();
        } else if (at - now.first <= min_plant) {
            now.first = at + 1;
        } else if (now.last - at <= min_plant) {
            now.last = at - 1;
        } else {
            const Contact before{now.first, at - min_swing};
            now.first = at + min_swing;
            left.push_back(before);
        }
    }
}

// The first contact of a piece if the piece before has begun or planned it.
struct Begun {
    const Plant *plant = nullptr;  // null: there is none
    bool ends = false;             // as it was planned, because the ground lets go of the foot at the border already
    uint32_t fixed = 0;            // samples that it lasts at least
};

// As add_held, of a contact that the piece before has begun.
void shorten(const Foot &foot, const FinePath &path, double max_shift_m, const Begun &begun, Contact &contact)
{
    const Stance place = stance_of(foot, path, contact, begun.plant);
    for (uint32_t i = contact.first + begun.fixed; i <= contact.last; ++i)
        if (!(strain(foot, path, place, i, max_shift_m) < 1)) contact.last = std::max(i, contact.first + 1) - 1;
    contact.last = std::max(contact.last, contact.first + begun.fixed);
}

// Behind the border, on which nothing changes for a moment: no new contact begins, and none ends.
Array<Contact> contacts_after(const CarriedFoot &carried, const FinePath &path, Foot &foot, Begun &begun)
{
    const auto samples = [&](double seconds) { return static_cast<uint32_t>(std::max(0.0, seconds) * path.hz + 0.5); };
    std::fill(foot.down.begin(), foot.down.begin() + path.first, uint8_t(0));
    Array<Contact> contacts = contacts_of(foot.down);
    uint32_t free = path.first + samples(landing_s);
    Contact first{};
    if (carried.planted || carried.lands_soon) {
        begun.plant = carried.planted ? &carried.held : &carried.next;
        begun.ends = carried.planted && double(begun.plant->end_s) <= landing_s;
        begun.fixed = samples(begun.ends ? double(begun.plant->end_s) : landing_s);
        first.first = path.first + samples(double(begun.plant->begin_s));
        first.last = first.first + begun.fixed;
        if (!begun.ends && !contacts.empty() && contacts[0].first <= first.first + min_swing)
            first.last = std::max(first.last, contacts[0].last);
        first.last = std::min(first.last, path.count() - 1);
        free = first.last + min_swing + 1;
    }
    for (Contact &contact : contacts) contact.first = std::max(contact.first, free);
    const auto is_short = [](const Contact &c) { return c.last < c.first + min_plant; };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), is_short), contacts.end());
    if (begun.plant) contacts.insert(contacts.begin(), first);
    return contacts;
}

Plant plant_of(const Foot &foot, const FinePath &path, const Contact &contact, const Begun &begun)
{
    const auto seconds = [&](uint32_t i) { return static_cast<float>((double(i) - path.first) / path.hz); };
    const Stance place = stance_of(foot, path, contact, begun.plant);
    Plant plant;
    plant.begin_s = seconds(contact.first);
    plant.end_s = seconds(contact.last);
    plant.x = static_cast<float>(place.x), plant.z = static_cast<float>(place.z);
    plant.heading_rad = static_cast<float>(place.heading_rad);
    plant.y = static_cast<float>(place.y), plant.slope = static_cast<float>(place.slope);
    plant.begin_x = static_cast<float>(place.x - foot.x[contact.first]);
    plant.begin_z = static_cast<float>(place.z - foot.z[contact.first]);
    plant.end_x = static_cast<float>(place.x - foot.x[contact.last]);
    plant.end_z = static_cast<float>(place.z - foot.z[contact.last]);
    if (begun.plant) plant.begin_s = begun.plant->begin_s, plant.heading_rad = begun.plant->heading_rad;
    if (begun.ends) plant.end_s = begun.plant->end_s;
    return plant;
}

}  // namespace

void make_plants(const Locomotion &locomotion, const BuildSettings &settings, const FinePath &path, Track &out)
{
    for (int f = 0; f < 2; ++f) {
        Foot foot = feet_of(locomotion, path, out.scale, f);
        const Footing footing(settings, locomotion, out, f);
        foot.follows_path = !settings.ground && out.height_step_m * 65535 > least_relief_m;
        foot.footing = &footing, foot.leg_m = double(locomotion.leg_length) * out.scale;
        const CarriedFoot carried = path.previous ? carried_foot(*path.previous, f) : CarriedFoot();
        Begun begun;
        Array<Contact> contacts = path.previous ? contacts_after(carried, path, foot, begun) : contacts_of(foot.down);
        out.plants[f].clear();
        out.plants[f].reserve(contacts.size() + 1);
        if (carried.has_before) out.plants[f].push_back(carried.before);
        const double max_shift_m = shift_share * double(locomotion.legs[f].max_shift) * out.scale;
        Array<Contact> held(contacts.get_allocator().resource());
        if (begun.plant) {
            if (!begun.ends) shorten(foot, path, max_shift_m, begun, contacts[0]);
            held.push_back(contacts[0]);
        }
        for (size_t i = begun.plant ? 1 : 0; i < contacts.size(); ++i)
            add_held(foot, path, max_shift_m, contacts[i], held);
        for (const Contact &contact : held) {
            out.plants[f].push_back(plant_of(foot, path, contact, begun));
            begun = Begun();
            // The next one behind the end of a piece is where a swing at that end leads to.
            if (contact.first > path.last) break;
        }
    }
}

}  // namespace claque::track
