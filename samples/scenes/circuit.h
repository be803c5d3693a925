// A way round a rectangle with rounded corners, walked at a steady pace. Where a walker is depends on the time alone.
#pragma once

namespace scenes
{

struct Step {
    double x, z;    // metres
    double dx, dz;  // the way it goes, length 1
};

class Circuit
{
public:
    // Centred on the origin; half_x and half_z to the straight sides, which are at least twice the corner radius long.
    Circuit(double half_x, double half_z, double corner);

    double length() const { return length_; }
    // `metres` along it, any number; from the middle of the near side (+z), first towards +x.
    Step at(double metres) const;

private:
    double half_x_, half_z_, corner_, length_;
};

}  // namespace scenes
