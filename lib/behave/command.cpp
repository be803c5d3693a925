#include "lib/behave/command.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

using base::fail;

namespace
{

// [radians] A point that has moved by less, as its actor sees it, is the same one: the turn to it goes on.
constexpr double same_point = 0.09;

template <class Kind>
const Kind &kind_of(const crowd::Crowd &crowd, uint32_t mechanism, const char *name)
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    if (mechanism >= behaviours.mechanism_count())
        fail(CLQ_ARGUMENT, "mechanism %u of %u", mechanism + 1, behaviours.mechanism_count());
    const Kind *kind = std::get_if<Kind>(&behaviours.mechanism(mechanism).kind);
    if (!kind) fail(CLQ_ARGUMENT, "mechanism %u is no %s", mechanism + 1, name);
    return *kind;
}

void check_time(double at_s)
{
    if (!std::isfinite(at_s)) fail(CLQ_ARGUMENT, "a command begins at %g s: a finite time is wanted", at_s);
}

const crowd::Use &use_of(const crowd::Behaviours &behaviours, uint32_t row, uint32_t mechanism)
{
    for (uint32_t i = behaviours.first_use(row); i != model::none; i = behaviours.use_at(i).next)
        if (behaviours.use_at(i).mechanism == mechanism) return behaviours.use_at(i);
    fail(CLQ_ARGUMENT, "the actor does not use mechanism %u", mechanism + 1);
}

// What is told for a time before the last order replaces that one.
void tell(crowd::Command &told, const crowd::Order &order)
{
    if (order.at_s > told.at_s) told.before = told;
    if (order.at_s <= told.before.at_s) told.before = crowd::Order();
    static_cast<crowd::Order &>(told) = order;
}

glm::vec3 point_of(const crowd::Place &place, const glm::dvec3 &world)
{
    crowd::Place target;
    target.position = world;
    const glm::dvec3 p = crowd::relative(place, target).position;
    if (!(std::fabs(p.x) < 1e30 && std::fabs(p.y) < 1e30 && std::fabs(p.z) < 1e30))
        fail(CLQ_ARGUMENT, "a point to look at is (%g, %g, %g) from the actor: finite and less than 1e30 is wanted",
             p.x, p.y, p.z);
    return glm::vec3(p);
}

}  // namespace

void look(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, const glm::dvec3 *point, double at_s)
{
    const uint32_t row = crowd.row_of(id);
    const crowd::Gaze &gaze = kind_of<crowd::Gaze>(crowd, mechanism, "gaze");
    check_time(at_s);
    crowd::Order order;
    order.at_s = at_s;
    if (point) {
        order.choice = 0;
        order.point = point_of(crowd.place_of(row), *point);
    }
    const double clock = clock_of(use_of(crowd.behaviours(), row, mechanism), at_s);
    const Lot lot = lot_of(crowd, row, mechanism, base::Purpose::gaze);
    crowd::Command &told = crowd.command(id, mechanism);
    const Look from = look_at(gaze, lot, clock, told, crowd, row, at_s);
    order.from_yaw = static_cast<float>(from.yaw), order.from_pitch = static_cast<float>(from.pitch);
    if (point && told.choice == 0 && at_s >= told.at_s) {
        const Look last = target_of(gaze, lot, clock, told, crowd, row, at_s);
        order.side = static_cast<float>(last.yaw);
        const Look next = target_of(gaze, lot, clock, order, crowd, row, at_s);
        if (std::fabs(next.yaw - last.yaw) < same_point && std::fabs(next.pitch - last.pitch) < same_point) {
            told.point = order.point;
            told.side = order.side;
            return;
        }
    }
    order.side = order.from_yaw;
    tell(told, order);
}

void express(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, uint32_t shape, double at_s)
{
    crowd.row_of(id);
    const crowd::Expression &expression = kind_of<crowd::Expression>(crowd, mechanism, "expression");
    check_time(at_s);
    if (shape != model::none && shape >= expression.shapes.size())
        fail(CLQ_ARGUMENT, "shape %u of %zu of an expression", shape, expression.shapes.size());
    crowd::Command &told = crowd.command(id, mechanism);
    crowd::Order order;
    order.at_s = at_s;
    order.choice = shape;
    order.choice_before = at_s > told.at_s ? told.choice : told.choice_before;
    tell(told, order);
}

void say(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, double at_s)
{
    crowd.row_of(id);
    kind_of<crowd::Phrase>(crowd, mechanism, "phrase");
    check_time(at_s);
    crowd::Order order;
    order.at_s = at_s;
    order.choice = 0;
    tell(crowd.command(id, mechanism), order);
}

}  // namespace claque::behave
