#include "tests/parity/peer.h"

#include <algorithm>

#include "tests/parity/normal_matrix.h"

namespace parity_test
{
namespace
{

constexpr size_t atlas_rows = 1024, atlas_columns = 256;

const void *offset(size_t bytes) { return reinterpret_cast<const void *>(bytes); }

}  // namespace

Peer::Peer(const contexts::Offscreen &context, const SceneIn &scene, const PeerOptions &options)
    : gl_(context), scene_(scene), options_(options)
{
    for (const Individual &person : scene.individuals)
        most_joints_ = std::max<size_t>(most_joints_, person.palette_count);
    int components = 0;
    gl_.GetIntegerv(gl::max_vertex_uniform_components, &components);
    const bool inverse =
        std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh &mesh) { return mesh.normals_by_inverse; });
    const size_t wanted = (inverse ? 24 : 12) * most_joints_ + 128;
    if (wanted > static_cast<size_t>(components))
        throw Failure(std::to_string(most_joints_) + " joints want " + std::to_string(wanted) +
                      " components of uniforms, and this OpenGL has " + std::to_string(components));
    upload_textures();
    upload_meshes();
    gl_.GenBuffers(1, &morphed_);
    gl_.expect_no_error("bringing the scene to OpenGL");
}

Peer::~Peer()
{
    gl_.UseProgram(0);
    for (const auto &[variant, program] : programs_) gl_.DeleteProgram(program.name);
    gl_.DeleteTextures(static_cast<int>(textures_.size()), textures_.data());
    gl_.DeleteTextures(static_cast<int>(atlases_.size()), atlases_.data());
    for (const Buffers &mesh : meshes_) gl_.DeleteBuffers(1, &mesh.shape), gl_.DeleteBuffers(1, &mesh.indices);
    gl_.DeleteBuffers(1, &morphed_);
}

void Peer::upload_textures()
{
    gl_.PixelStorei(gl::unpack_alignment, 1);
    gl_.ActiveTexture(gl::texture0);
    const auto upload = [&](int wrap_s, int wrap_t, int width, int height, unsigned inside, unsigned format,
                            const uint8_t *texels) {
        unsigned name = 0;
        gl_.GenTextures(1, &name);
        gl_.BindTexture(gl::texture_2d, name);
        for (const unsigned filter : {gl::min_filter, gl::mag_filter})
            gl_.TexParameteri(gl::texture_2d, filter, static_cast<int>(gl::nearest));
        gl_.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_s);
        gl_.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_t);
        gl_.TexImage2D(gl::texture_2d, 0, static_cast<int>(inside), width, height, 0, format, gl::unsigned_byte,
                       texels);
        return name;
    };
    for (const Texture &texture : scene_.textures)
        textures_.push_back(upload(texture.wrap_s, texture.wrap_t, texture.width, texture.height, gl::rgba8, gl::rgba,
                                   texture.rgba.data()));
    const int edge = static_cast<int>(gl::clamp_to_edge);
    constexpr size_t plate = atlas_rows * atlas_columns * 3;
    for (size_t first = 0; first < scene_.atlas.size(); first += plate)
        atlases_.push_back(
            upload(edge, edge, atlas_columns, atlas_rows, gl::rgb8, gl::rgb, scene_.atlas.data() + first));
}

void Peer::upload_meshes()
{
    for (const Mesh &mesh : scene_.meshes) {
        Buffers out;
        std::vector<float> shape;
        const auto append = [&](int attribute, const std::vector<float> &values) {
            out.offsets[attribute] = 4 * shape.size();
            shape.insert(shape.end(), values.begin(), values.end());
        };
        append(at_position, mesh.positions);
        append(at_normal, mesh.normals);
        append(at_uv, mesh.uvs);
        for (size_t set = 0; set < mesh.joints.size(); ++set) {
            append(at_joints + static_cast<int>(set), mesh.joints[set]);
            append(at_weights + static_cast<int>(set), mesh.weights[set]);
        }
        std::vector<float> colours;
        for (const uint8_t c : mesh.colours) colours.push_back(static_cast<float>(c) / 255);
        append(at_colour, colours);
        gl_.GenBuffers(1, &out.shape);
        gl_.BindBuffer(gl::array_buffer, out.shape);
        gl_.BufferData(gl::array_buffer, static_cast<ptrdiff_t>(4 * shape.size()), shape.data(), gl::static_draw);
        gl_.GenBuffers(1, &out.indices);
        gl_.BindBuffer(gl::element_array_buffer, out.indices);
        gl_.BufferData(gl::element_array_buffer, static_cast<ptrdiff_t>(4 * mesh.indices.size()), mesh.indices.data(),
                       gl::static_draw);
        meshes_.push_back(out);
    }
}

void Peer::begin(What what)
{
    what_ = what;
    mesh_ = material_ = atlas_ = SIZE_MAX;
    program_ = nullptr;
    gl_.Viewport(0, 0, scene_.width, scene_.height);
    gl_.ClearColor(0, 0, 0, what == What::colour ? 1.0f : 0.0f);
    gl_.DepthMask(1);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    gl_.Enable(gl::depth_test);
    gl_.DepthFunc(gl::lequal);
    gl_.Disable(gl::blend);
    gl_.CullFace(gl::back);
    // OpenGL 1.1's state for colours; id pictures must not be dithered.
    if (what != What::colour) gl_.Disable(gl::dither);
    gl_.MatrixMode(gl::projection);
    gl_.LoadMatrixf(scene_.projection.data());
    gl_.MatrixMode(gl::modelview);
}

void Peer::use_mesh(const Individual &person, const float *weights)
{
    const Mesh &mesh = scene_.meshes[person.mesh];
    const bool moved = std::any_of(mesh.targets.begin(), mesh.targets.end(),
                                   [&](const MorphTarget &t) { return weights[t.weight] != 0; });
    if (mesh_ == person.mesh && !moved) return;
    const Buffers &buffers = meshes_[person.mesh];
    mesh_ = moved ? SIZE_MAX : person.mesh;
    gl_.BindBuffer(gl::element_array_buffer, buffers.indices);
    gl_.BindBuffer(gl::array_buffer, buffers.shape);
    const auto point = [&](int attribute, int size, bool there) {
        const unsigned index = static_cast<unsigned>(attribute);
        if (!there) return gl_.DisableVertexAttribArray(index);
        gl_.EnableVertexAttribArray(index);
        gl_.VertexAttribPointer(index, size, gl::real, 0, 0, offset(buffers.offsets[attribute]));
    };
    point(at_position, 3, true);
    point(at_normal, 3, true);
    point(at_uv, 2, true);
    point(at_colour, 4, !mesh.colours.empty());
    if (mesh.colours.empty()) gl_.VertexAttrib4f(at_colour, 1, 1, 1, 1);
    for (int set = 0; set < 2; ++set) {
        point(at_joints + set, 4, static_cast<size_t>(set) < mesh.joints.size());
        point(at_weights + set, 4, static_cast<size_t>(set) < mesh.joints.size());
    }
    if (moved) bind_morphed(mesh, weights);
}

// Morph targets are added before the vertices reach the shader: S2 has none.
void Peer::bind_morphed(const Mesh &mesh, const float *weights)
{
    std::vector<float> both = mesh.positions;
    both.insert(both.end(), mesh.normals.begin(), mesh.normals.end());
    for (const MorphTarget &target : mesh.targets)
        for (size_t i = 0; i < target.vertices.size(); ++i)
            for (size_t k = 0; k < 3; ++k) {
                both[3 * target.vertices[i] + k] += weights[target.weight] * target.positions[3 * i + k];
                both[3 * (mesh.vertices + target.vertices[i]) + k] +=
                    weights[target.weight] * target.normals[3 * i + k];
            }
    gl_.BindBuffer(gl::array_buffer, morphed_);
    gl_.BufferData(gl::array_buffer, static_cast<ptrdiff_t>(4 * both.size()), both.data(), gl::stream_draw);
    gl_.VertexAttribPointer(at_position, 3, gl::real, 0, 0, offset(0));
    gl_.VertexAttribPointer(at_normal, 3, gl::real, 0, 0, offset(4 * mesh.positions.size()));
}

Variant Peer::variant_for(const Individual &person, const Range &range) const
{
    const Mesh &mesh = scene_.meshes[person.mesh];
    const Material &material = scene_.materials[range.material];
    return {what_,          most_joints_,      mesh.joints.size(), mesh.normals_by_inverse, material.double_sided,
            material.holes, options_.limiting, material.unlit,     options_.subpixel_bits};
}

void Peer::use_program(const Individual &person, const Variant &variant, size_t row, const float *palette)
{
    const Program &program = program_for(variant);
    if (program_ != &program) gl_.UseProgram(program.name), palette_is_set_ = false;
    program_ = &program;
    if (palette_is_set_) return;
    palette_is_set_ = true;
    gl_.Uniform4fv(program.palette, static_cast<int>(3 * person.palette_count), palette);
    if (variant.normals_by_inverse) {
        std::vector<float> normals(12 * static_cast<size_t>(person.palette_count));
        for (size_t joint = 0; joint < person.palette_count; ++joint)
            normal_matrix(palette + 12 * joint, normals.data() + 12 * joint);
        gl_.Uniform4fv(program.normal_palette, static_cast<int>(3 * person.palette_count), normals.data());
    }
    if (program.row >= 0)
        gl_.Uniform1f(program.row, (static_cast<float>(row % atlas_rows) + 0.5f) / static_cast<float>(atlas_rows));
    const float id[3] = {static_cast<float>(person.actor & 255) / 255,
                         static_cast<float>(person.actor >> 8 & 255) / 255,
                         static_cast<float>(person.actor >> 16 & 255) / 255};
    if (program.id >= 0) gl_.Uniform3fv(program.id, 1, id);
}

void Peer::draw(const Individual &person, size_t row, const float *palette, const float *weights)
{
    use_mesh(person, weights);
    palette_is_set_ = false;
    gl_.LoadMatrixf(person.model_view.data());
    gl_.FrontFace(person.mirrored ? gl::cw : gl::ccw);
    if (row / atlas_rows != atlas_) {
        atlas_ = row / atlas_rows;
        gl_.ActiveTexture(gl::texture0 + 1);
        gl_.BindTexture(gl::texture_2d, atlases_[atlas_]);
        gl_.ActiveTexture(gl::texture0);
    }
    const Mesh &mesh = scene_.meshes[person.mesh];
    if (options_.limiting != Limiting::zones) {
        for (const Range &range : mesh.ranges) draw_range(person, range, row, palette);
        return;
    }
    for (const ZoneRange &part : mesh.zone_ranges) {
        use_program(person, variant_for(person, part.range), row, palette);
        set_zone(row, part.zone);
        draw_range(person, part.range, row, palette);
    }
}

void Peer::draw_range(const Individual &person, const Range &range, size_t row, const float *palette)
{
    const Material &material = scene_.materials[range.material];
    use_program(person, variant_for(person, range), row, palette);
    if (program_->emission >= 0) {
        const std::array<float, 3> none{};
        gl_.Uniform3fv(program_->emission, 1, (scene_.lighting.enabled ? material.emission : none).data());
    }
    if (range.material != material_) {
        gl_.BindTexture(gl::texture_2d, textures_[material.texture]);
        material.double_sided ? gl_.Disable(gl::cull_face) : gl_.Enable(gl::cull_face);
        material_ = range.material;
    }
    gl_.DrawElements(gl::triangles, static_cast<int>(range.count), gl::unsigned_int, offset(4 * range.first));
}

// The colour that an atlas look-up would find for the zone.
void Peer::set_zone(size_t row, uint32_t zone)
{
    const size_t key = zone + 1;
    float rgb[3];
    for (size_t k = 0; k < 3; ++k) rgb[k] = static_cast<float>(scene_.atlas[3 * (row * atlas_columns + key) + k]) / 255;
    if (program_->key >= 0) gl_.Uniform1f(program_->key, static_cast<float>(key));
    if (program_->zone_colour >= 0) gl_.Uniform3fv(program_->zone_colour, 1, rgb);
}

void Peer::draw_all(What what)
{
    begin(what);
    std::vector<size_t> order(scene_.individuals.size());
    for (size_t i = 0; i < order.size(); ++i) order[scene_.individuals[i].draw_order] = i;
    for (const size_t i : order) {
        const Individual &person = scene_.individuals[i];
        draw(person, i, scene_.palettes.data() + 12 * static_cast<size_t>(person.first_palette),
             scene_.weights.data() + person.first_weight);
    }
    gl_.Finish();
    gl_.expect_no_error("drawing the scene");
}

}  // namespace parity_test
