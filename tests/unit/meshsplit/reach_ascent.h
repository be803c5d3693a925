// The reach of a character's vertices, found independently: in double, by hill climbing from many starts, without any
// data of meshsplit. Every result is reachable; the Sklsroot Bsphere must hold it and be little larger.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include "lib/model/template.h"

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
    void pose(const ClipTime &at);  // the clip's own part; degrees of freedom stay unchanged
    void shuffle(uint64_t start);   // random degrees of freedom, some at the ends of their ranges

    // The largest distance from `centre` of any vertex of any level; climb() continues with that vertex.
    double farthest(const glm::dvec3 &centre);
    // Moves one degree of freedom after the other to where the farthest vertex is farthest, until none gains; then
    // repeats with the vertex that is farthest then.
    double climb(const glm::dvec3 &centre);
    glm::dvec3 node_origin(uint32_t node) const { return frame(node).move; }

private:
    struct Frame {
        glm::dmat3 turn = glm::dmat3(1);
        glm::dvec3 move = glm::dvec3(0);
    };
    // A vertex of any level: its influences and its morph targets.
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

// The largest distance found from 100 starts: from the clip poses that reach farthest with degrees of freedom at rest,
// and from random poses.
double found_reach(const model::Template &tmpl, const glm::dvec3 &centre);

}  // namespace claque::test
