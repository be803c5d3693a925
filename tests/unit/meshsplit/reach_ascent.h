// Where a character's vertices can get to, a second time: in double, climbing from many starts, with nothing of what
// meshsplit makes of it. What it finds is reached; the Sklsroot Bsphere must hold it and be little larger.
#pragma once

#include "lib/model/template.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace claque::test
{

struct ClipTime {
    uint32_t clip = model::none;
    double time_s = 0;
};

// The rest pose and every clip, `per_s` times a second and at its end.
std::vector<ClipTime> clip_times(const model::Rig &rig, double per_s);

class Reacher
{
public:
    explicit Reacher(const model::Template &tmpl);

    std::vector<double> dofs;       // one each
    void pose(const ClipTime &at);  // the clip's own part; degrees of freedom stay as they are
    void shuffle(uint64_t start);   // degrees of freedom anywhere in their ranges, some at their ends

    // The largest distance from `centre` of any vertex of any level; which one that is stays known for climb().
    double farthest(const glm::dvec3 &centre);
    // One degree of freedom after the other to where the farthest vertex is farthest, until none gains; then again for
    // the vertex that is farthest then.
    double climb(const glm::dvec3 &centre);
    glm::dvec3 node_origin(uint32_t node) const { return frame(node).move; }

private:
    struct Frame {
        glm::dmat3 turn = glm::dmat3(1);
        glm::dvec3 move = glm::dvec3(0);
    };
    // Of any level: what moves it and what its shape may become.
    struct Vertex {
        glm::dvec3 bind = glm::dvec3(0);
        std::vector<std::pair<uint32_t, double>> influences;  // palette entry, weight
        std::vector<std::pair<uint32_t, glm::dvec3>> morphs;  // weight of the pose, delta
    };
    void add_level(const model::Level &level);
    Frame local(uint32_t node) const;
    Frame frame(uint32_t node) const;
    glm::dvec3 shaped(const Vertex &vertex) const;
    double distance(const glm::dvec3 &centre) const;
    double best_turn(size_t dof, const glm::dvec3 &centre);

    const model::Template &tmpl_;
    std::vector<math::Trs> locals_;
    std::vector<float> weights_;
    std::vector<Vertex> vertices_;
    size_t farthest_ = 0;
};

// The largest distance found from 100 starts: from the poses of the clips that reach farthest with the degrees of
// freedom at rest, and from any.
double found_reach(const model::Template &tmpl, const glm::dvec3 &centre);

}  // namespace claque::test
