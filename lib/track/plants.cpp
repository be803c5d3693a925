// When each foot stands, and where: the mean of the places at which its clip has it meanwhile.
#include <algorithm>
#include <cmath>

#include "lib/track/build.h"

namespace claque::track
{

namespace
{

constexpr uint32_t min_plant = 4;  // samples: shorter contacts are no steps
constexpr uint32_t min_swing = 3;

struct Contact {
    uint32_t first, last;
};

// Places of the ball of a foot, metres from the track's origin.
struct Foot {
    explicit Foot(std::pmr::memory_resource *memory)
        : x(memory), z(memory), hip_x(memory), hip_z(memory), reach(memory), down(memory)
    {
    }
    Array<double> x, z;
    Array<double> hip_x, hip_z, reach;  // GaitCell::reach in the world
    Array<uint8_t> down;
};

Foot feet_of(const Locomotion &locomotion, const FinePath &path, double scale_m, int f)
{
    Foot foot(path.x.get_allocator().resource());
    const uint32_t count = path.count();
    for (Array<double> *column : {&foot.x, &foot.z, &foot.hip_x, &foot.hip_z, &foot.reach}) column->resize(count);
    foot.down.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        const GaitCell cell = cell_at(locomotion, path.gait[i], path.phase[i]);
        const double c = std::cos(path.heading[i]), s = std::sin(path.heading[i]);
        const double x = double(cell.x[f]) * scale_m, z = double(cell.z[f]) * scale_m;
        foot.x[i] = path.x[i] + x * c + z * s;
        foot.z[i] = path.z[i] - x * s + z * c;
        const double hip_x = double(cell.reach_x[f]) * scale_m, hip_z = double(cell.reach_z[f]) * scale_m;
        foot.hip_x[i] = path.x[i] + hip_x * c + hip_z * s;
        foot.hip_z[i] = path.z[i] - hip_x * s + hip_z * c;
        foot.reach[i] = double(cell.reach[f]) * scale_m;
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

double mean(const Array<double> &values, const Contact &contact);

// How much of what its leg can do a foot needs at a sample to be at the mean of its contact: the distance from where
// the clips have it, the straight leg, and the turn against the body.
double strain(const Foot &foot, const FinePath &path, const Contact &contact, uint32_t i, double max_shift_m)
{
    const double x = mean(foot.x, contact), z = mean(foot.z, contact);
    const double shift = std::hypot(foot.x[i] - x, foot.z[i] - z) / max_shift_m;
    const double leg = std::hypot(foot.hip_x[i] - x, foot.hip_z[i] - z) / foot.reach[i];
    const double turn = std::fabs(path.heading[i] - mean(path.heading, contact)) / max_foot_turn_rad;
    return std::max({leg, shift, turn});
}

// A foot that the body leaves too far behind is lifted earlier, or comes down later.
void shorten(const Foot &foot, const FinePath &path, double max_shift_m, Contact &contact)
{
    while (contact.last - contact.first > min_plant) {
        const double at_first = strain(foot, path, contact, contact.first, max_shift_m);
        const double at_last = strain(foot, path, contact, contact.last, max_shift_m);
        if (std::max(at_first, at_last) < 1) return;
        if (at_first > at_last) ++contact.first;
        else --contact.last;
    }
}

double mean(const Array<double> &values, const Contact &contact)
{
    double sum = 0;
    for (uint32_t i = contact.first; i <= contact.last; ++i) sum += values[i] - values[contact.first];
    return values[contact.first] + sum / (contact.last - contact.first + 1);
}

}  // namespace

void make_plants(const Locomotion &locomotion, const FinePath &path, Track &out)
{
    for (int f = 0; f < 2; ++f) {
        const Foot foot = feet_of(locomotion, path, out.scale, f);
        Array<Contact> contacts = contacts_of(foot.down);
        out.plants[f].clear();
        out.plants[f].reserve(contacts.size());
        const double max_shift_m = 0.9 * double(locomotion.legs[f].max_shift) * out.scale;
        for (Contact &contact : contacts) {
            shorten(foot, path, max_shift_m, contact);
            const double x = mean(foot.x, contact), z = mean(foot.z, contact);
            Plant plant;
            plant.begin_s = static_cast<float>(contact.first / path.hz);
            plant.end_s = static_cast<float>(contact.last / path.hz);
            plant.x = static_cast<float>(x), plant.z = static_cast<float>(z);
            plant.heading_rad = static_cast<float>(mean(path.heading, contact));
            plant.begin_x = static_cast<float>(x - foot.x[contact.first]);
            plant.begin_z = static_cast<float>(z - foot.z[contact.first]);
            plant.end_x = static_cast<float>(x - foot.x[contact.last]);
            plant.end_z = static_cast<float>(z - foot.z[contact.last]);
            out.plants[f].push_back(plant);
        }
    }
}

}  // namespace claque::track
