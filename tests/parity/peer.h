// The GPU peer (S2 2.2, 2.5): a crowd drawn by matrix palettes in a vertex shader and one lookup in a colour atlas per
// fragment, one draw per individual and material. It reads a scene's folder and uses nothing of claque.
#pragma once

#include <map>

#include "tests/parity/gl20.h"
#include "tests/parity/scene_in.h"
#include "tests/parity/shaders.h"

namespace parity_test
{

struct PeerOptions {
    Limiting limiting = Limiting::knots;
    int subpixel_bits = 0;  // as Variant has it: what a coarse rasteriser would show
};

class Peer
{
public:
    // The context must be current, here and below. `scene` must outlive this object. Throws Failure, also if a palette
    // does not fit this OpenGL's uniforms.
    Peer(const contexts::Offscreen &context, const SceneIn &scene, const PeerOptions &options = {});
    ~Peer();
    Peer(const Peer &) = delete;
    Peer &operator=(const Peer &) = delete;

    // A cleared picture, and the state that all draws share.
    void begin(What what);
    // `palette`: three rows of four per joint; `weights`: of the morph targets; row: of the atlas.
    void draw(const Individual &person, size_t row, const float *palette, const float *weights);
    // The whole exported scene, in the order of its list.
    void draw_all(What what);

    // Positions and normals of all individuals from the vertex shader; false if this OpenGL cannot return them.
    bool skin(std::vector<float> &positions, std::vector<float> &normals);

    const Gl20 &gl() const { return gl_; }

private:
    struct Program {
        unsigned name = 0;
        int palette = -1, normal_palette = -1, row = -1, id = -1, key = -1, zone_colour = -1, emission = -1;
    };
    struct Buffers {
        unsigned shape = 0, indices = 0;  // names
        size_t offsets[attribute_count] = {};
    };

    const Program &program_for(const Variant &variant);
    unsigned compile(unsigned kind, const std::string &text);
    void set_scene_uniforms(unsigned program);
    void upload_textures();
    void upload_meshes();
    void use_mesh(const Individual &person, const float *weights);
    void bind_morphed(const Mesh &mesh, const float *weights);
    Variant variant_for(const Individual &person, const Range &range) const;
    void draw_range(const Individual &person, const Range &range, size_t row, const float *palette);
    void set_zone(size_t row, uint32_t zone);
    void use_program(const Individual &person, const Variant &variant, size_t row, const float *palette);

    Gl20 gl_;
    const SceneIn &scene_;
    PeerOptions options_;
    size_t most_joints_ = 1;
    std::map<Variant, Program> programs_;
    std::vector<unsigned> textures_, atlases_;
    std::vector<Buffers> meshes_;
    unsigned morphed_ = 0;  // buffer
    What what_ = What::colour;
    // The state that OpenGL has now.
    size_t mesh_ = SIZE_MAX, material_ = SIZE_MAX, atlas_ = SIZE_MAX;
    const Program *program_ = nullptr;
    bool palette_is_set_ = false;
};

}  // namespace parity_test
