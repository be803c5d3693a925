// Functions with the same bits on every processor: they use only +, -, *, /, sqrt, floor and fmod, which IEEE 754 fixes
// to the last bit. The C library's sin, acos and pow choose their code by processor, and change with its version.
#pragma once

namespace claque::math
{

constexpr double pi = 3.14159265358979323846;

double sin(double x);              // error below 0.9 units in the last place for |x| < 1e6; NaN for infinity
double cos(double x);              // as sin
double tan(double x);              // sin / cos
double atan(double x);             // error below 1e-15
double atan2(double y, double x);  // in (-pi, pi]; 0 for (0, 0)
double acos(double x);             // x is clamped to [-1, 1]; error below 1e-15
double pow(double x, double y);    // relative error below 1e-14 for |y| < 16; 0 for x <= 0

float sin(float x);  // error below 0.6 units in the last place for |x| < 1e6
float cos(float x);  // as sin
// Rounded from double.
inline float pow(float x, float y) { return static_cast<float>(pow(double(x), double(y))); }

}  // namespace claque::math
