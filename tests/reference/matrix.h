// The arithmetic of the reference: double vectors, quaternions and 4x4 matrices, written out so that no mistake can be
// shared with the library's own (no GLM, no lib/math). Column vectors; entry (row, column) is at [4 * column + row].
#pragma once

#include <array>
#include <cmath>

namespace claque::reference
{

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(const Vec3 &a, const Vec3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3 &a, const Vec3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(const Vec3 &a, double factor) { return {a.x * factor, a.y * factor, a.z * factor}; }
inline double dot(const Vec3 &a, const Vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vec3 &a) { return std::sqrt(dot(a, a)); }

inline Vec3 cross(const Vec3 &a, const Vec3 &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Zero stays zero.
inline Vec3 normalized(const Vec3 &a)
{
    const double size = length(a);
    return size > 0 ? a * (1 / size) : Vec3{};
}

struct Quat {
    double x = 0, y = 0, z = 0, w = 1;
};

inline double dot(const Quat &a, const Quat &b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }

inline Quat scaled_sum(const Quat &a, double fa, const Quat &b, double fb)
{
    return {a.x * fa + b.x * fb, a.y * fa + b.y * fb, a.z * fa + b.z * fb, a.w * fa + b.w * fb};
}

// A zero quaternion means no rotation.
inline Quat normalized(const Quat &q)
{
    const double size = std::sqrt(dot(q, q));
    return size > 0 ? scaled_sum(q, 1 / size, q, 0) : Quat{};
}

// Great-circle interpolation of unit quaternions along the shorter arc.
inline Quat slerp(const Quat &a, const Quat &b, double t)
{
    const double sign = dot(a, b) < 0 ? -1 : 1;
    const double cosine = std::fmin(1.0, sign * dot(a, b));
    const double angle = std::acos(cosine);
    if (angle < 1e-9) return normalized(scaled_sum(a, 1 - t, b, sign * t));
    const double sine = std::sin(angle);
    return normalized(scaled_sum(a, std::sin((1 - t) * angle) / sine, b, sign * std::sin(t * angle) / sine));
}

struct Mat4 {
    std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double &at(int row, int column) { return m[static_cast<size_t>(4 * column + row)]; }
    double at(int row, int column) const { return m[static_cast<size_t>(4 * column + row)]; }
    Vec3 column(int c) const { return {at(0, c), at(1, c), at(2, c)}; }
};

inline Mat4 operator*(const Mat4 &a, const Mat4 &b)
{
    Mat4 product;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) sum += a.at(row, k) * b.at(k, column);
            product.at(row, column) = sum;
        }
    return product;
}

// sum += factor * a
inline void add_scaled(Mat4 &sum, const Mat4 &a, double factor)
{
    for (size_t i = 0; i < 16; ++i) sum.m[i] += factor * a.m[i];
}

inline Mat4 zero_matrix()
{
    Mat4 zero;
    zero.m.fill(0);
    return zero;
}

inline Vec3 transform_point(const Mat4 &a, const Vec3 &p)
{
    return a.column(0) * p.x + a.column(1) * p.y + a.column(2) * p.z + a.column(3);
}

// By the inverse transpose of the upper 3x3, to unit length; zero where that matrix is singular. The columns of an
// inverse transpose are the cross products of the others over the determinant, whose sign turns mirrored normals round.
inline Vec3 transform_normal(const Mat4 &a, const Vec3 &n)
{
    const Vec3 c0 = cross(a.column(1), a.column(2));
    const Vec3 c1 = cross(a.column(2), a.column(0));
    const Vec3 c2 = cross(a.column(0), a.column(1));
    const double determinant = dot(a.column(0), c0);
    const double volume = length(a.column(0)) * length(a.column(1)) * length(a.column(2));
    if (!(std::fabs(determinant) > 1e-9 * volume)) return {};
    return normalized((c0 * n.x + c1 * n.y + c2 * n.z) * (determinant < 0 ? -1.0 : 1.0));
}

// Ratio of the longest to the shortest stretch of the upper 3x3, at least 1: by the eigenvalues of its square, in
// closed form. Infinite where it is singular.
inline double condition_number(const Mat4 &a)
{
    const Vec3 x = a.column(0), y = a.column(1), z = a.column(2);
    const double xy = dot(x, y), xz = dot(x, z), yz = dot(y, z);
    const double mean = (dot(x, x) + dot(y, y) + dot(z, z)) / 3;
    const double dx = dot(x, x) - mean, dy = dot(y, y) - mean, dz = dot(z, z) - mean;
    const double p = std::sqrt((dx * dx + dy * dy + dz * dz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
    if (!(p > 1e-12 * mean)) return mean > 0 ? 1 : INFINITY;
    const double determinant = dx * (dy * dz - yz * yz) - xy * (xy * dz - yz * xz) + xz * (xy * yz - dy * xz);
    const double r = std::fmax(-1.0, std::fmin(1.0, determinant / (2 * p * p * p)));
    const double angle = std::acos(r) / 3;
    const double largest = mean + 2 * p * std::cos(angle);
    const double smallest = mean + 2 * p * std::cos(angle + 2.0943951023931957);
    return smallest > 1e-12 * largest ? std::sqrt(largest / smallest) : INFINITY;
}

// Translation * rotation * scale. The columns are the unit axes rotated by v + 2w(u x v) + 2u x (u x v), then scaled.
inline Mat4 compose(const Vec3 &translation, const Quat &rotation, const Vec3 &scale)
{
    const Quat q = normalized(rotation);
    const Vec3 u{q.x, q.y, q.z};
    const std::array<Vec3, 3> axes{Vec3{scale.x, 0, 0}, Vec3{0, scale.y, 0}, Vec3{0, 0, scale.z}};
    Mat4 result;
    for (int c = 0; c < 3; ++c) {
        const Vec3 &v = axes[static_cast<size_t>(c)];
        const Vec3 turned = v + cross(u, v) * (2 * q.w) + cross(u, cross(u, v)) * 2;
        result.at(0, c) = turned.x;
        result.at(1, c) = turned.y;
        result.at(2, c) = turned.z;
    }
    result.at(0, 3) = translation.x;
    result.at(1, 3) = translation.y;
    result.at(2, 3) = translation.z;
    return result;
}

}  // namespace claque::reference
