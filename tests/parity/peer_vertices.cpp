// The vertex shader's output for each vertex, captured by transform feedback.
#include "tests/parity/peer.h"

namespace parity_test
{

bool Peer::skin(std::vector<float> &positions, std::vector<float> &normals)
{
    if (!gl_.has_feedback()) return false;
    what_ = What::vertices;
    mesh_ = SIZE_MAX, program_ = nullptr;
    unsigned caught = 0;
    gl_.GenBuffers(1, &caught);
    gl_.Enable(gl::rasterizer_discard);
    std::vector<float> both;
    for (const Individual &person : scene_.individuals) {
        const Mesh &mesh = scene_.meshes[person.mesh];
        use_mesh(person, scene_.weights.data() + person.first_weight);
        palette_is_set_ = false;
        use_program(person, {What::vertices, most_joints_, mesh.joints.size(), mesh.normals_by_inverse}, 0,
                    scene_.palettes.data() + 12 * static_cast<size_t>(person.first_palette));
        const ptrdiff_t size = static_cast<ptrdiff_t>(24 * mesh.vertices);
        gl_.BindBuffer(gl::transform_feedback_buffer, caught);
        gl_.BufferData(gl::transform_feedback_buffer, size, nullptr, gl::stream_draw);
        gl_.BindBufferBase(gl::transform_feedback_buffer, 0, caught);
        gl_.BeginTransformFeedback(gl::points);
        gl_.DrawArrays(gl::points, 0, static_cast<int>(mesh.vertices));
        gl_.EndTransformFeedback();
        both.resize(6 * mesh.vertices);
        gl_.GetBufferSubData(gl::transform_feedback_buffer, 0, size, both.data());
        for (size_t v = 0; v < mesh.vertices; ++v) {
            positions.insert(positions.end(), &both[6 * v], &both[6 * v] + 3);
            normals.insert(normals.end(), &both[6 * v + 3], &both[6 * v + 3] + 3);
        }
    }
    gl_.Disable(gl::rasterizer_discard);
    gl_.BindBufferBase(gl::transform_feedback_buffer, 0, 0);
    gl_.DeleteBuffers(1, &caught);
    gl_.expect_no_error("reading skinned vertices back");
    return true;
}

}  // namespace parity_test
