// The market of a town gives people their places. It answers a machine's call by an event: its place is where to go,
// its value the heading there, in degrees.
//   call = "post"     -> "post": behind the nearest stall, to its customers
//   call = "stall"    -> "stall": a free place before a stall; where none was found, "stroll"
//   call = "company"  -> "company", for the caller and another one who seeks some: places face to face. It is sent when
//                        there is another one
//   call = "here"     -> "talk", for both as soon as both are there: from the place of the other one, with the value 1
//                        for the one that speaks first, else 0. When one of them leaves: "parted", for the other one
//   call = "stroll"   -> "stroll": somewhere on the square
//   call = "free"        gives up the place that one had
#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"
#include "samples/scenes/town/landmarks.h"
#include "samples/stage/run.h"

namespace staged
{
namespace
{

using scenes::Purpose;
using scenes::town::Point;
using scenes::town::Site;

constexpr double before_m = 1.32, behind_m = -0.45;  // of a stall's middle
constexpr double beside_m[] = {-1.05, -0.35, 0.35, 1.05};
constexpr double apart_m = 0.95;         // of two who talk
constexpr double hearing_m = 25;         // how far one goes for company
constexpr double between_pairs_m = 1.9;  // and from those at stalls
constexpr int tries = 16;

struct Stand {
    Point at;
    double heading_deg;
};

double heading_of(double x, double z) { return std::atan2(x, z) / scenes::radians; }

class Market final : public Service
{
public:
    enum Action { post, stall, company, here, stroll, give_up };

    explicit Market(const scenes::ScenarioTown &described)
    {
        const scenes::town::Plan plan(described.seed);
        const auto trade = described.market_day ? scenes::town::Trade::market_day : scenes::town::Trade::ordinary;
        for (const Site &site : scenes::town::stall_sites(plan, trade)) {
            const Point out = site.out();
            posts_.push_back({site.ground(0, behind_m), heading_of(out.x, out.z)});
            for (const double beside : beside_m)
                stands_.push_back({site.ground(beside, before_m), heading_of(-out.x, -out.z)});
        }
        taken_.assign(stands_.size(), false);
        const scenes::town::SquarePlan square = scenes::town::square_plan(plan);
        for (const double u : {-33.0, 33.0})
            for (const double v : {-14.0, 15.0})
                corners_.push_back(plan.at(square.fountain_u + u, square.fountain_v + v));
    }

    std::vector<std::string> actions() const override { return {"post", "stall", "company", "here", "stroll", "free"}; }

    void serve(Run &run, size_t action, const Call &call) override
    {
        const uint32_t person = call.person;
        if (people_.size() <= person) people_.resize(person + 1);
        if (action == here) return begin_to_talk(run, person);
        leave(run, person);
        if (action == post) send_to_post(run, person);
        if (action == stall && !send_to_stall(run, person)) send_anywhere(run, person);
        if (action == company) find_company(run, person);
        if (action == stroll) send_anywhere(run, person);
    }

    void gone(Run &run, uint32_t person) override
    {
        if (person < people_.size()) leave(run, person);
    }

    void put(BytesOut &out) const override
    {
        out.put<uint64_t>(people_.size());
        for (const Person &one : people_) {
            out.put(one.stand), out.put(one.asked), out.put(one.other), out.put<uint8_t>(one.is_there);
            out.put(one.at.x), out.put(one.at.z);
        }
        out.put<uint64_t>(seekers_.size());
        for (const uint32_t one : seekers_) out.put(one);
    }

    void take(Run &, BytesIn &in) override
    {
        people_.assign(in.count(16000), {});
        taken_.assign(stands_.size(), false);
        for (Person &one : people_) {
            one.stand = in.take<uint32_t>(), one.asked = in.take<uint32_t>();
            one.other = in.take<uint32_t>(), one.is_there = in.take<uint8_t>() != 0;
            one.at.x = in.take<double>(), one.at.z = in.take<double>();
            if (one.stand > stands_.size() || one.other > people_.size())
                throw scenes::Failure("the saved run has a place or a person that does not exist");
            if (one.stand > 0) taken_[one.stand - 1] = true;
        }
        seekers_.assign(in.count(people_.size()), 0);
        for (uint32_t &one : seekers_) {
            one = in.take<uint32_t>();
            if (one >= people_.size()) throw scenes::Failure("the saved run has a person who does not exist");
        }
    }

private:
    struct Person {
        uint32_t stand = 0;  // of stands_, from 1 on; 0: none
        uint32_t asked = 0;  // so often
        uint32_t other = 0;  // the one it talks with, from 1 on; 0: none
        bool is_there = false;
        Point at = {0, 0};  // in the middle of the two
    };

    double draw(const Run &run, uint32_t person, Purpose purpose)
    {
        return scenes::random_unit(run.seed(), person * 4096ull + ++people_[person].asked, purpose);
    }

    void leave(Run &run, uint32_t person)
    {
        Person &one = people_[person];
        if (one.stand > 0) taken_[one.stand - 1] = false;
        if (one.other > 0) {
            people_[one.other - 1].other = 0;
            if (run.is_here(one.other - 1)) run.send(one.other - 1, "parted", run.place_of(one.other - 1).data());
        }
        one.stand = one.other = 0;
        seekers_.erase(std::remove(seekers_.begin(), seekers_.end(), person), seekers_.end());
    }

    static void answer(Run &run, uint32_t person, const char *event, Point to, double heading_deg)
    {
        double place[3];
        if (on_ground(run, person, to, 0.3, place)) run.send(person, event, place, heading_deg);
    }

    // As high as the person is, and a little to the side if it must be.
    static bool on_ground(Run &run, uint32_t person, Point to, double aside_m, double place[3])
    {
        const double point[3] = {to.x, run.place_of(person)[1], to.z};
        bool found = false;
        scenes::check(clq_navigation_find_nearest(run.navigation(), point, 3.0, place, &found));
        return found && std::hypot(place[0] - to.x, place[2] - to.z) <= aside_m;
    }

    void send_to_post(Run &run, uint32_t person)
    {
        const std::array<double, 3> at = run.place_of(person);
        const auto distance = [&](const Stand &one) { return std::hypot(one.at.x - at[0], one.at.z - at[2]); };
        const auto nearest = std::min_element(
            posts_.begin(), posts_.end(), [&](const Stand &a, const Stand &b) { return distance(a) < distance(b); });
        answer(run, person, "post", nearest->at, nearest->heading_deg);
    }

    bool send_to_stall(Run &run, uint32_t person)
    {
        for (int i = 0; i < tries; ++i) {
            const auto which =
                static_cast<size_t>(draw(run, person, Purpose::seat) * static_cast<double>(stands_.size()));
            if (taken_[which] || is_near_a_pair(stands_[which].at, 0.8)) continue;
            taken_[which] = true;
            people_[person].stand = static_cast<uint32_t>(which + 1);
            answer(run, person, "stall", stands_[which].at, stands_[which].heading_deg);
            return true;
        }
        return false;
    }

    void find_company(Run &run, uint32_t person)
    {
        const std::array<double, 3> at = run.place_of(person);
        for (const uint32_t other : seekers_) {
            const std::array<double, 3> from = run.place_of(other);
            if (std::hypot(from[0] - at[0], from[2] - at[2]) > hearing_m) continue;
            if (bring_together(run, person, at, other, from)) return;
        }
        seekers_.push_back(person);
    }

    void begin_to_talk(Run &run, uint32_t person)
    {
        Person &one = people_[person];
        if (one.other == 0) return run.send(person, "parted", run.place_of(person).data());
        one.is_there = true;
        const uint32_t other = one.other - 1;
        if (!people_[other].is_there) return;
        run.send(person, "talk", run.place_of(other).data(), 0);
        run.send(other, "talk", run.place_of(person).data(), 1);
    }

    // Half-way between them, where two can stand face to face and are in no other's way.
    bool bring_together(Run &run, uint32_t a, const std::array<double, 3> &from_a, uint32_t b,
                        const std::array<double, 3> &from_b)
    {
        for (int i = 0; i < tries; ++i) {
            const double reach = 1.0 + 0.5 * i;
            const Point middle = {(from_a[0] + from_b[0]) / 2 + reach * (2 * draw(run, a, Purpose::place_x) - 1),
                                  (from_a[2] + from_b[2]) / 2 + reach * (2 * draw(run, a, Purpose::place_z) - 1)};
            if (is_near_a_pair(middle, between_pairs_m) || is_near_a_stand(middle, between_pairs_m)) continue;
            // The first one stands on the side from which it comes.
            double x = from_a[0] - from_b[0], z = from_a[2] - from_b[2];
            const double length = std::hypot(x, z);
            if (length < 1e-6) x = 1, z = 0;
            else x /= length, z /= length;
            const Point at_a = {middle.x + x * apart_m / 2, middle.z + z * apart_m / 2};
            const Point at_b = {middle.x - x * apart_m / 2, middle.z - z * apart_m / 2};
            double place[3];
            if (!on_ground(run, a, at_a, 0.02, place) || !on_ground(run, b, at_b, 0.02, place)) continue;
            seekers_.erase(std::remove(seekers_.begin(), seekers_.end(), b), seekers_.end());
            people_[a].other = b + 1, people_[b].other = a + 1;
            for (const uint32_t one : {a, b}) people_[one].is_there = false, people_[one].at = middle;
            answer(run, a, "company", at_a, heading_of(-x, -z));
            answer(run, b, "company", at_b, heading_of(x, z));
            return true;
        }
        return false;
    }

    void send_anywhere(Run &run, uint32_t person)
    {
        for (int i = 0; i < tries; ++i) {
            const double u = draw(run, person, Purpose::place_x), v = draw(run, person, Purpose::place_z);
            const auto mixed = [&](double Point::*part) {
                return (1 - u) * ((1 - v) * corners_[0].*part + v * corners_[1].*part) +
                       u * ((1 - v) * corners_[2].*part + v * corners_[3].*part);
            };
            const Point to = {mixed(&Point::x), mixed(&Point::z)};
            double place[3];
            if (is_near_a_pair(to, 1.2) || is_near_a_stand(to, 1.2) || !on_ground(run, person, to, 0.02, place))
                continue;
            run.send(person, "stroll", place);
            return;
        }
        run.send(person, "stroll", run.place_of(person).data());
    }

    bool is_near_a_pair(Point p, double reach_m) const
    {
        return std::any_of(people_.begin(), people_.end(), [&](const Person &one) {
            return one.other > 0 && std::hypot(one.at.x - p.x, one.at.z - p.z) < reach_m;
        });
    }

    bool is_near_a_stand(Point p, double reach_m) const
    {
        const auto near = [&](const Stand &one) { return std::hypot(one.at.x - p.x, one.at.z - p.z) < reach_m; };
        return std::any_of(stands_.begin(), stands_.end(), near) || std::any_of(posts_.begin(), posts_.end(), near);
    }

    std::vector<Stand> stands_, posts_;
    std::vector<bool> taken_;
    std::vector<Point> corners_;
    std::vector<Person> people_;
    std::vector<uint32_t> seekers_;  // of company, by time
};

}  // namespace

std::unique_ptr<Service> make_market(const scenes::ScenarioTown &town) { return std::make_unique<Market>(town); }

}  // namespace staged
