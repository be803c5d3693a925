#include "lib/lod/surface/quadric.h"

#include <algorithm>

namespace claque::lod
{

TriangleFrame::TriangleFrame(glm::dvec3 p0, glm::dvec3 p1, glm::dvec3 p2) : origin(p0), a(0), b(0), normal(0)
{
    const glm::dvec3 e1 = p1 - p0, e2 = p2 - p0, n = glm::cross(e1, e2);
    const double square = glm::dot(n, n);
    if (!(square > 0)) return;
    const double length = glm::length(n);
    area = 0.5 * length;
    normal = n / length;
    a = glm::cross(e2, n) / square;
    b = glm::cross(n, e1) / square;
}

// Solves by Cramer's rule about a nearby point, so that rounding does not depend on the character's position.
bool PlaneQuadric::find_minimum(glm::dvec3 near, glm::dvec3 &out) const
{
    const glm::dvec3 x(xx_, xy_, xz_), y(xy_, yy_, yz_), z(xz_, yz_, zz_);
    const glm::dvec3 r(-(glm::dot(x, near) + b_.x), -(glm::dot(y, near) + b_.y), -(glm::dot(z, near) + b_.z));
    const double determinant = glm::dot(x, glm::cross(y, z)), trace = xx_ + yy_ + zz_;
    if (!(determinant > 1e-4 * trace * trace * trace)) return false;
    // The matrix is symmetric, so its columns are its rows.
    out =
        near + glm::dvec3(glm::dot(r, glm::cross(y, z)), glm::dot(x, glm::cross(r, z)), glm::dot(x, glm::cross(y, r))) /
                   determinant;
    return true;
}

namespace
{

double value_of(const Attributes &attributes, uint32_t id)
{
    for (const Attribute &attribute : attributes)
        if (attribute.id == id) return attribute.value;
    return 0;
}

}  // namespace

AttributeQuadric::Term &AttributeQuadric::term(uint32_t id)
{
    const auto at = std::lower_bound(terms_.begin(), terms_.end(), id,
                                     [](const Term &term, uint32_t wanted) { return term.id < wanted; });
    if (at != terms_.end() && at->id == id) return *at;
    Term fresh;
    fresh.id = id;
    return *terms_.insert(at, fresh);
}

void AttributeQuadric::add_triangle(const TriangleFrame &frame, const Attributes &a0, const Attributes &a1,
                                    const Attributes &a2)
{
    if (!(frame.area > 0)) return;
    area_ += frame.area;
    const auto add = [&](uint32_t id) {
        const Linear linear = frame.linear(value_of(a0, id), value_of(a1, id), value_of(a2, id));
        Term &to = term(id);
        to.square.add(linear.g, linear.d, frame.area);
        to.g += frame.area * linear.g;
        to.d += frame.area * linear.d;
    };
    const auto named = [](const Attributes &in, uint32_t id) {
        return std::any_of(in.begin(), in.end(), [id](const Attribute &attribute) { return attribute.id == id; });
    };
    for (const Attribute &attribute : a0) add(attribute.id);
    for (const Attribute &attribute : a1)
        if (!named(a0, attribute.id)) add(attribute.id);
    for (const Attribute &attribute : a2)
        if (!named(a0, attribute.id) && !named(a1, attribute.id)) add(attribute.id);
}

AttributeQuadric &AttributeQuadric::operator+=(const AttributeQuadric &o)
{
    for (const Term &from : o.terms_) {
        Term &to = term(from.id);
        to.square += from.square;
        to.g += from.g;
        to.d += from.d;
    }
    area_ += o.area_;
    return *this;
}

// Each term is the sum of area (g p + d - s)^2; triangles without the attribute count as g = 0, d = 0.
double AttributeQuadric::at(glm::dvec3 p, const Attributes &values) const
{
    double sum = 0;
    for (const Term &term : terms_) {
        const double s = value_of(values, term.id);
        sum += term.square.at(p) - 2 * s * (glm::dot(term.g, p) + term.d) + s * s * area_;
    }
    for (const Attribute &value : values) {
        const bool known = std::binary_search(terms_.begin(), terms_.end(), Term{value.id, {}, {}, 0},
                                              [](const Term &a, const Term &b) { return a.id < b.id; });
        if (!known) sum += value.value * value.value * area_;
    }
    return std::max(sum, 0.0);
}

}  // namespace claque::lod
