// The cost of a collapse: the distance of the result from the original planes, and the difference of corner attributes
// (texture coordinates, influences) from those at the same point before. Area-weighted sums of squares, after Garland
// and Heckbert for planes and Hoppe 1999 for attributes that are linear over each triangle.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace claque::lod
{

// Sum of w (n p + d)^2, as a function of p.
class PlaneQuadric
{
public:
    void add_plane(glm::dvec3 n, glm::dvec3 on, double w) { add(n, -glm::dot(n, on), w); }
    void add(glm::dvec3 n, double d, double w)
    {
        xx_ += w * n.x * n.x, xy_ += w * n.x * n.y, xz_ += w * n.x * n.z;
        yy_ += w * n.y * n.y, yz_ += w * n.y * n.z, zz_ += w * n.z * n.z;
        b_ += w * d * n;
        c_ += w * d * d;
    }
    PlaneQuadric &operator+=(const PlaneQuadric &o)
    {
        xx_ += o.xx_, xy_ += o.xy_, xz_ += o.xz_, yy_ += o.yy_, yz_ += o.yz_, zz_ += o.zz_;
        b_ += o.b_;
        c_ += o.c_;
        return *this;
    }
    double at(glm::dvec3 p) const
    {
        return p.x * p.x * xx_ + p.y * p.y * yy_ + p.z * p.z * zz_ +
               2 * (p.x * p.y * xy_ + p.x * p.z * xz_ + p.y * p.z * yz_) + 2 * glm::dot(b_, p) + c_;
    }
    // Finds the minimum. Returns false if the planes leave a direction open, or nearly so.
    bool find_minimum(glm::dvec3 near, glm::dvec3 &out) const;

private:
    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0, c_ = 0;
    glm::dvec3 b_ = glm::dvec3(0);
};

// The function g p + d over a triangle.
struct Linear {
    glm::dvec3 g = glm::dvec3(0);
    double d = 0;
};

// The frame of a triangle, which turns corner values into a Linear.
struct TriangleFrame {
    glm::dvec3 origin, a, b, normal;  // unit normal; a and b dual to the edges
    double area = 0;                  // 0: no frame
    TriangleFrame(glm::dvec3 p0, glm::dvec3 p1, glm::dvec3 p2);
    Linear linear(double s0, double s1, double s2) const
    {
        const glm::dvec3 g = (s1 - s0) * a + (s2 - s0) * b;
        return {g, s0 - glm::dot(g, origin)};
    }
};

// The attributes of a wedge: pairs of attribute id and value, ascending by id. An absent attribute is 0.
struct Attribute {
    uint32_t id = 0;
    double value = 0;
};
using Attributes = std::vector<Attribute>;

// The sum over triangles of area times the squared differences of all attributes from the triangle's linear function.
class AttributeQuadric
{
public:
    void add_triangle(const TriangleFrame &frame, const Attributes &a0, const Attributes &a1, const Attributes &a2);
    AttributeQuadric &operator+=(const AttributeQuadric &o);
    double at(glm::dvec3 p, const Attributes &values) const;

private:
    struct Term {
        uint32_t id = 0;
        PlaneQuadric square;           // of g p + d
        glm::dvec3 g = glm::dvec3(0);  // sum of area g
        double d = 0;                  // sum of area d
    };
    Term &term(uint32_t id);
    std::vector<Term> terms_;  // ascending by id
    double area_ = 0;
};

}  // namespace claque::lod
