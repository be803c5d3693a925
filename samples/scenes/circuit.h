// A path round a rectangle with rounded corners, walked at constant speed. A walker's position depends on the time
// alone.
#pragma once

namespace scenes
{

struct Step {
    double x, z;    // metres
    double dx, dz;  // direction of motion, length 1
};

class Circuit
{
public:
    // Centred on the origin. half_x and half_z reach to the straight sides, which must be at least twice the corner
    // radius long.
    Circuit(double half_x, double half_z, double corner);

    double length() const { return length_; }
    // The position after `metres`, any number; it starts at the centre of the near side (+z), towards +x.
    Step at(double metres) const;

private:
    double half_x_, half_z_, corner_, length_;
};

}  // namespace scenes
