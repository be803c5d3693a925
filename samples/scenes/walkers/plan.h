// A plan of the world in which people walk.
#pragma once

namespace scenes::walkers
{

// x to the east, y to the north, z up, metres; the scene has x, z to the south, y up, and its origin at the middle of
// the people or where the options say.
struct Plan {
    double x = 0, y = 0, z = 0;         // the scene's origin in the world
    double start_s = 0, end_s = 0;      // of the file
    double half_x = 1, half_z = 1;      // of the people, metres
    double middle_x = 0, middle_z = 0;  // of the people, in the scene
    double ground = 0;                  // its height in the scene
    void to_scene(double px, double py, double pz, double out[3]) const
    {
        out[0] = px - x, out[1] = pz - z, out[2] = -(py - y);
    }
};

}  // namespace scenes::walkers
