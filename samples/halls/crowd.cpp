#include "samples/halls/crowd.h"

#include <algorithm>

#include "samples/scenes/check.h"

namespace halls
{

using scenes::check;

Crowd::Crowd(const Floor &floor, const Trial &trial) : navigation_(floor.make()), random_(trial.seed)
{
    clq_walkers_def def = clq_walkers_def_init();
    def.max_count = 1500, def.tick_s = trial.tick_s;
    clq_walkers *made = nullptr;
    check(clq_walkers_create(navigation_.get(), &def, &made));
    walkers_.reset(made);
}

bool Crowd::add(double x, double z, float speed_m_s)
{
    clq_walker_def def = clq_walker_def_init();
    const double apart_m = 2 * static_cast<double>(def.radius_m) + 0.01;
    for (const Person &other : people)
        if (std::hypot(other.x - x, other.z - z) < apart_m) return false;
    def.position[0] = x, def.position[2] = z;
    def.speed_m_s =
        speed_m_s > 0 ? speed_m_s : std::clamp(std::normal_distribution<float>(1.34f, 0.26f)(random_), 0.8f, 1.9f);
    Person made{{0, 0}, x, z};
    check(clq_walkers_add(walkers_.get(), &def, &made.id));
    people.push_back(made);
    return true;
}

void Crowd::go(const Person &one, double x, double z, float near_m, double y)
{
    const double goal[3] = {x, y, z};
    check(clq_walker_go(walkers_.get(), one.id, goal, near_m, 0));
}

void Crowd::remove(size_t i)
{
    check(clq_walkers_remove(walkers_.get(), people[i].id));
    people[i] = people.back();
    people.pop_back();
}

void Crowd::step()
{
    check(clq_walkers_step(walkers_.get()));
    for (Person &one : people) {
        clq_walker_info info = clq_walker_info_init();
        check(clq_walkers_get_walker(walkers_.get(), one.id, &info));
        one.moved_x = info.position[0] - one.x, one.moved_z = info.position[2] - one.z;
        one.x = info.position[0], one.z = info.position[2];
    }
    for (size_t i = 0; i < people.size(); ++i)
        for (size_t k = 0; k < i; ++k) {
            const double x = people[i].x - people[k].x, z = people[i].z - people[k].z;
            nearest_m2_ = std::min(nearest_m2_, x * x + z * z);
        }
}

double weidmann_m_s(double people_per_m2) { return 1.34 * (1 - std::exp(-1.913 * (1 / people_per_m2 - 1 / 5.4))); }

}  // namespace halls
