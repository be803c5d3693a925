// Conversion of angles.
#pragma once

namespace scenes
{

constexpr double two_pi = 6.283185307179586;
constexpr double radians = 0.017453292519943295;  // times degrees

}  // namespace scenes
