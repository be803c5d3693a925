// The crowd's triangles as a scene of rays, for range sensors. Embree finds the triangle that a ray meets; claque
// names its individual and zone.
#pragma once

#include <claque/visibility.h>

#include <array>
#include <memory>
#include <vector>

namespace range
{

// What one ray of a sensor meets.
struct Return {
    float distance = -1;  // world units along the ray; negative: nothing
    uint32_t actor = 0;   // index1; 0: the ground, or nothing
    uint32_t zone = CLQ_NONE;
    std::array<float, 3> normal = {0, 0, 0};  // of the triangle, of length 1
};

// A ray from the sensor, in the world's axes. The direction has length 1.
struct Ray {
    std::array<float, 3> direction;
    float max_distance = 100;
};

// A view of the last update, and the camera that it has.
struct Look {
    const clq_view *view;
    clq_camera camera;
};

// All individuals that the sensor's views list, as they are posed now. Views of one sensor have the same eye and
// together look wherever its rays go: a sensor is a view, so what it sees is neither frozen nor culled.
class RayScene
{
public:
    // ground_y: the height of level ground in the world; NaN: none. Throws scenes::Failure.
    RayScene(const std::vector<Look> &looks, double ground_y);
    ~RayScene();
    RayScene(const RayScene &) = delete;
    RayScene &operator=(const RayScene &) = delete;

    // One return for each ray.
    std::vector<Return> cast(const std::vector<Ray> &rays) const;
    size_t triangle_count() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace range
