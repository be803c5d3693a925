// Trigonometry with the same bits on every processor: it uses only +, -, *, / and sqrt, which IEEE 754 fixes to the
// last bit. The C library's acos, atan2 and tan choose their code by processor.
#pragma once

namespace claque::math
{

constexpr double pi = 3.14159265358979323846;

double atan(double x);             // error below 1e-15
double atan2(double y, double x);  // in (-pi, pi]; 0 for (0, 0)
double acos(double x);             // x is clamped to [-1, 1]; error below 1e-15
double tan(double x);              // for |x| < 1e6, by sin and cos

}  // namespace claque::math
