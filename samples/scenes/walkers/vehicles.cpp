#include "samples/scenes/walkers/vehicles.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::walkers
{

namespace
{

constexpr Rgb paints[] = {
    {0.55f, 0.20f, 0.16f}, {0.24f, 0.34f, 0.46f}, {0.72f, 0.70f, 0.64f}, {0.30f, 0.40f, 0.30f}, {0.66f, 0.54f, 0.30f}};
constexpr Rgb dark = {0.16f, 0.16f, 0.17f};
constexpr float skirt_m = 0.22f, post_m = 0.09f, roof_m = 0.06f;

// SUMO's defaults of the classes passenger and bus, metres, and the heights of floor and window sill.
struct Size {
    double length, width, height, floor, sill;
};
constexpr Size car = {5.0, 1.8, 1.5, 0.04, 0.82}, bus = {12.0, 2.5, 3.4, 0.35, 1.05};

// Seats: metres behind the front and to the right of the middle. Nobody is known to drive: the driver's is the last.
struct Seat {
    double behind, right;
};
constexpr Seat car_seats[] = {{2.3, 0.4}, {3.3, -0.4}, {3.3, 0.4}, {2.3, -0.4}};
constexpr double bus_rows_from_m = 2.6, bus_row_m = 0.85, bus_rear_m = 0.6;
constexpr double bus_across_m[] = {-0.95, 0.95, -0.45, 0.45};
constexpr double hips_behind_feet_m = 0.40, seat_m = 0.40, back_m = 0.85;
// A rider that the file has beside a vehicle is at most half a bus away from its front.
constexpr double beside_m = 6;

Seat seat_of(bool is_bus, size_t seat)
{
    if (!is_bus) return car_seats[seat % 4];
    return {bus_rows_from_m + bus_row_m * static_cast<double>(seat / 4), bus_across_m[seat % 4]};
}

// A box along a direction: from and to metres ahead of a place, to its right, and above it.
class Along
{
public:
    Along(Geometry &out, const Vehicles::Stand &stand) : out_(out), at_(stand) {}

    Vec3 point(double ahead, double right, double up) const
    {
        return {static_cast<float>(at_.position[0] + ahead * at_.ahead_x - right * at_.ahead_z),
                static_cast<float>(at_.position[1] + up),
                static_cast<float>(at_.position[2] + ahead * at_.ahead_z + right * at_.ahead_x)};
    }
    void box(double ahead0, double ahead1, double right0, double right1, double up0, double up1, Rgb colour)
    {
        sides(ahead0, ahead1, right0, right1, up0, up1, colour);
        lid(ahead0, ahead1, right0, right1, up1, colour);
    }
    // Without a top.
    void sides(double ahead0, double ahead1, double right0, double right1, double up0, double up1, Rgb colour)
    {
        const double corners[][2] = {{ahead0, right0}, {ahead0, right1}, {ahead1, right1}, {ahead1, right0}};
        for (int i = 0; i < 4; ++i) {
            const double *a = corners[i], *b = corners[(i + 1) % 4];
            out_.quad({point(a[0], a[1], up0), point(b[0], b[1], up0), point(b[0], b[1], up1), point(a[0], a[1], up1)},
                      colour);
        }
    }
    void lid(double ahead0, double ahead1, double right0, double right1, double up, Rgb colour)
    {
        out_.quad({point(ahead0, right0, up), point(ahead0, right1, up), point(ahead1, right1, up),
                   point(ahead1, right0, up)},
                  colour);
    }

private:
    Geometry &out_;
    const Vehicles::Stand &at_;
};

}  // namespace

Vehicles::Vehicles(const clq_trajectories *trajectories, const Plan &plan, const std::vector<Person> &people)
    : trajectories_(trajectories), plan_(plan), people_(people), ride_of_(people.size(), SIZE_MAX)
{
    for (size_t i = 0; i < people.size(); ++i) {
        if (people[i].kind == Person::Kind::vehicle) vehicles_.push_back({i, 0});
        if (people[i].kind == Person::Kind::rides) rides_.push_back({i, 0, SIZE_MAX});
    }
    std::stable_sort(rides_.begin(), rides_.end(),
                     [&](const Ride &a, const Ride &b) { return people[a.person].start_s < people[b.person].start_s; });
    std::vector<std::vector<double>> left_at(vehicles_.size());  // by vehicle and seat: when it was left
    for (size_t k = 0; k < rides_.size(); ++k) {
        seat(rides_[k], left_at);
        ride_of_[rides_[k].person] = k;
    }
    for (size_t i = 0; i < vehicles_.size(); ++i) vehicles_[i].most = left_at[i].size();
}

// The first free seat of the vehicle whose front is nearest.
void Vehicles::seat(Ride &ride, std::vector<std::vector<double>> &left_at) const
{
    const Person &rider = people_[ride.person];
    const Stand own = front(ride.person, rider.start_s);
    double least = beside_m;
    for (size_t i = 0; i < vehicles_.size(); ++i) {
        const Person &vehicle = people_[vehicles_[i].person];
        if (rider.start_s < vehicle.start_s || rider.start_s > vehicle.end_s) continue;
        const Stand there = front(vehicles_[i].person, rider.start_s);
        const double away = std::hypot(there.position[0] - own.position[0], there.position[2] - own.position[2]);
        if (away < least) least = away, ride.vehicle = i;
    }
    if (ride.vehicle == SIZE_MAX) return;
    std::vector<double> &seats = left_at[ride.vehicle];
    const auto free = std::find_if(seats.begin(), seats.end(), [&](double left_s) { return left_s < rider.start_s; });
    ride.seat = static_cast<size_t>(free - seats.begin());
    if (free == seats.end()) seats.push_back(rider.end_s);
    else *free = rider.end_s;
}

double Vehicles::length_m(const Vehicle &vehicle) const
{
    if (!vehicle.is_bus()) return car.length;
    return std::max(bus.length, seat_of(true, vehicle.most - 1).behind + bus_rear_m);
}

// On straight lines between the samples.
Vehicles::Stand Vehicles::front(size_t person, double time_s) const
{
    const clq_trajectory_person read = person_of(trajectories_, static_cast<uint32_t>(person));
    const clq_trajectory_sample *first = clq_trajectories_get_samples(trajectories_) + read.first_sample;
    const clq_trajectory_sample *end = first + read.sample_count;
    const double at_s = time_s + plan_.start_s;
    const auto *after =
        std::upper_bound(first, end, at_s, [](double t, const auto &sample) { return t < sample.time_s; });
    const clq_trajectory_sample &b = after == end ? end[-1] : *after, &a = after == first ? *first : after[-1];
    const double between = b.time_s - a.time_s;
    const double part = between > 0 ? std::clamp((at_s - a.time_s) / between, 0.0, 1.0) : 0;
    Stand out = {};
    plan_.to_scene(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z), out.position);
    double turn = static_cast<double>(a.heading_rad), more = static_cast<double>(b.heading_rad) - turn;
    if (std::isnan(turn + more)) turn = std::atan2(b.y - a.y, b.x - a.x), more = 0;
    more -= two_pi * std::round(more / two_pi);
    // As floats: processors may round the last bit of the functions differently.
    out.ahead_x = double(float(std::cos(turn + part * more))),
    out.ahead_z = -double(float(std::sin(turn + part * more)));
    return out;
}

Vehicles::Stand Vehicles::at(size_t person, double time_s) const
{
    const size_t number = ride_of_[person];
    if (number == SIZE_MAX || rides_[number].vehicle == SIZE_MAX) return front(person, time_s);
    const Ride &ride = rides_[number];
    const Vehicle &vehicle = vehicles_[ride.vehicle];
    Stand out = front(vehicle.person, time_s);
    const Seat seat = seat_of(vehicle.is_bus(), ride.seat);
    const double ahead = hips_behind_feet_m - seat.behind;
    out.position[0] += ahead * out.ahead_x - seat.right * out.ahead_z;
    out.position[1] += (vehicle.is_bus() ? bus : car).floor;
    out.position[2] += ahead * out.ahead_z + seat.right * out.ahead_x;
    return out;
}

Vehicles::Stand Vehicles::rear(size_t person, double time_s) const
{
    const size_t ride = ride_of_[person];
    const auto own = std::find_if(vehicles_.begin(), vehicles_.end(), [&](const Vehicle &vehicle) {
        return ride == SIZE_MAX ? vehicle.person == person
                                : rides_[ride].vehicle == size_t(&vehicle - vehicles_.data());
    });
    Stand out = front(own == vehicles_.end() ? person : own->person, time_s);
    const double length = own == vehicles_.end() ? 0 : length_m(*own);
    out.position[0] -= length * out.ahead_x, out.position[2] -= length * out.ahead_z;
    return out;
}

// A skirt over the wheels, walls up to the windows, and a roof on posts: who sits inside is seen.
void Vehicles::build(const Vehicle &vehicle, const Stand &stand)
{
    const Size &size = vehicle.is_bus() ? bus : car;
    const Rgb paint = paints[vehicle.person % std::size(paints)];
    const double rear = -length_m(vehicle), half = size.width / 2, head = size.height - double(roof_m);
    const double bonnet = vehicle.is_bus() ? 0 : 1.3;  // metres without a cabin above
    Along along(boxes_, stand);
    along.sides(rear + 0.06, -0.06, 0.06 - half, half - 0.06, 0, double(skirt_m), dark);
    along.sides(rear, 0, -half, half, double(skirt_m), size.sill, paint);
    along.lid(rear + 0.06, -0.06, 0.06 - half, half - 0.06, size.floor + 0.02, dark);
    // The ledge between skirt and walls.
    for (const double side : {-half, half - 0.06}) along.lid(rear, 0, side, side + 0.06, double(skirt_m), dark);
    for (const double end : {rear, -0.06}) along.lid(end, end + 0.06, -half, half, double(skirt_m), dark);
    const size_t seats = vehicle.is_bus() ? vehicle.most : std::size(car_seats);
    for (size_t i = 0; i < seats; ++i) {
        const Seat seat = seat_of(vehicle.is_bus(), i);
        along.box(-seat.behind - 0.22, -seat.behind + 0.22, seat.right - 0.21, seat.right + 0.21, size.floor,
                  size.floor + seat_m, dark);
        along.box(-seat.behind - 0.30, -seat.behind - 0.22, seat.right - 0.21, seat.right + 0.21, size.floor,
                  size.floor + back_m, dark);
    }
    if (bonnet > 0) along.lid(-bonnet, 0, -half, half, size.sill, paint);
    along.box(rear, -bonnet, -half, half, head, size.height, paint);
    const double pace = vehicle.is_bus() ? 2.4 : 1.85, post = double(post_m);
    const int posts = std::max(1, static_cast<int>(std::lround((-bonnet - rear - post) / pace)));
    for (int i = 0; i <= posts; ++i) {
        const double from = rear + (-bonnet - rear - post) * i / posts;
        along.sides(from, from + post, -half, post - half, size.sill, head, paint);
        along.sides(from, from + post, half - post, half, size.sill, head, paint);
    }
    constexpr double margin = 0.9, lift = 0.012;
    const Along below(shade_, stand);
    const double corners[][4] = {{rear - margin, -half - margin, 0.5, 0},
                                 {rear - margin, half + margin, 1, 0},
                                 {margin, half + margin, 1, 1},
                                 {margin, -half - margin, 0.5, 1}};
    uint32_t made[4];
    for (int i = 0; i < 4; ++i)
        made[i] = shade_.add(below.point(corners[i][0], corners[i][1], lift), {0, 1, 0},
                             static_cast<float>(corners[i][2]), static_cast<float>(corners[i][3]), dark, 0.8f);
    shade_.triangle(made[0], made[1], made[2]);
    shade_.triangle(made[0], made[2], made[3]);
}

void Vehicles::place(double time_s)
{
    boxes_.clear(), shade_.clear();
    for (const Vehicle &vehicle : vehicles_) {
        const Person &there = people_[vehicle.person];
        if (time_s < there.start_s || time_s > there.end_s) continue;
        build(vehicle, front(vehicle.person, time_s));
    }
}

}  // namespace scenes::walkers
