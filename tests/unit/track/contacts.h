// The feet of a person as the ground knows them: when a foot is down, how far it slips, how deep it goes and how high
// it rises between two places. The meter sees vertices of soles alone; plants, cells and measures of lib/track are not
// asked.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace claque::test
{

// The vertices of a sole at a time: x and z in metres of the world, y the height over the ground below each.
struct Soleprint {
    double time_s = 0;
    glm::dvec2 body = glm::dvec2(0);  // where the person is
    std::vector<glm::dvec3> points;
};

// The parts of a sole, by vertex. Its front third is neither heel nor ball.
enum class Part : uint8_t { heel, waist, ball, toes };

struct Spread {
    std::vector<double> each;
    double mean() const;
    double at_share(double share) const;  // such as the 95th percentile
    double max() const { return at_share(1); }
    double min() const { return at_share(0); }
    void add(const Spread &other) { each.insert(each.end(), other.each.begin(), other.each.end()); }
};

// Metres. A foot is down while a vertex of its sole is lower than 5 mm; a contact is one unbroken time down.
struct Contacts {
    Spread slips;     // of each contact: the way of the vertex that is lower than the others at both of two samples
    Spread holds;     // of each vertex that is down for 0.12 s: how far it gets from where it came down
    Spread flats;     // likewise of the vertices of heel and ball while both are down
    Spread lifts;     // how high the sole rises between two contacts at different places
    Spread turns;     // degrees that what is down of a foot turns by in a contact
    Spread depths;    // of the lowest vertex of each foot below the ground
    int dragged = 0;  // feet never down, and contacts in which the person moves for over 3 s and by over 0.3 m
    void add(const Contacts &other);
    // One row of a table: mean, 95th percentile and maximum of the slips, and the worst of the others.
    std::string row() const;
};

// Prints of one foot, in the order of their times.
Contacts contacts_of(const std::vector<Soleprint> &prints, const std::vector<Part> &parts);

}  // namespace claque::test
