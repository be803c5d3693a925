// A second opinion on converted characters: Assimp's scene, posed and skinned in double precision, apart from the
// converter and from the library.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>

namespace convert_test
{

using Point = std::array<double, 3>;
using Matrix = std::array<double, 16>;  // by row

class Reference
{
public:
    explicit Reference(const aiScene &scene);

    // All vertices of meshes with triangles: nodes depth first, their meshes in order. Animation -1: the rest pose.
    // Times are in ticks.
    std::vector<Point> pose(int animation, double ticks);

    // Animations that move a node of the scene.
    const std::vector<int> &animations() const { return animations_; }
    // Of the clip in the GLB: its rate and the tick of its second 0.
    double rate_of(int animation) const;
    double first_of(int animation) const;

private:
    void place(const aiNode &node, const Matrix &above, int animation, double ticks);
    void skin(const aiNode &node, const aiMesh &mesh, std::vector<Point> &out) const;
    void walk(const aiNode &node, std::vector<Point> &out) const;

    const aiScene &scene_;
    std::vector<int> animations_;
    std::map<const aiNode *, Matrix> globals_;
    std::map<std::string, const aiNode *> first_named_;
};

}  // namespace convert_test
