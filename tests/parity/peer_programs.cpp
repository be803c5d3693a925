// Compiles shaders to programs and uploads the data that all individuals of a scene share.
#include <cmath>

#include "tests/parity/peer.h"

namespace parity_test
{

unsigned Peer::compile(unsigned kind, const std::string &text)
{
    const unsigned shader = gl_.CreateShader(kind);
    const char *source = text.c_str();
    gl_.ShaderSource(shader, 1, &source, nullptr);
    gl_.CompileShader(shader);
    int done = 0;
    gl_.GetShaderiv(shader, gl::compile_status, &done);
    if (done) return shader;
    char log[2048] = "";
    gl_.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    gl_.DeleteShader(shader);
    throw Failure(std::string("a shader does not compile: ") + log);
}

const Peer::Program &Peer::program_for(const Variant &variant)
{
    const auto known = programs_.find(variant);
    if (known != programs_.end()) return known->second;
    Program out;
    out.name = gl_.CreateProgram();
    const unsigned vertex = compile(gl::vertex_shader, vertex_shader(variant, scene_.lighting));
    gl_.AttachShader(out.name, vertex);
    gl_.DeleteShader(vertex);
    if (variant.what != What::vertices) {
        const unsigned fragment = compile(gl::fragment_shader, fragment_shader(variant, scene_.lighting, scene_.fog));
        gl_.AttachShader(out.name, fragment);
        gl_.DeleteShader(fragment);
    } else {
        const char *const caught[] = {"out_position", "out_normal"};
        gl_.TransformFeedbackVaryings(out.name, 2, caught, gl::interleaved_attribs);
    }
    for (unsigned i = 0; i < attribute_count; ++i) gl_.BindAttribLocation(out.name, i, attribute_names[i]);
    gl_.LinkProgram(out.name);
    int done = 0;
    gl_.GetProgramiv(out.name, gl::link_status, &done);
    if (!done) {
        char log[2048] = "";
        gl_.GetProgramInfoLog(out.name, sizeof log, nullptr, log);
        throw Failure(std::string("the shaders do not link: ") + log);
    }
    out.palette = gl_.GetUniformLocation(out.name, "palette");
    out.normal_palette = gl_.GetUniformLocation(out.name, "normal_palette");
    out.row = gl_.GetUniformLocation(out.name, "row");
    out.id = gl_.GetUniformLocation(out.name, "id");
    out.emission = gl_.GetUniformLocation(out.name, "emission");
    out.key = gl_.GetUniformLocation(out.name, "key");
    out.zone_colour = gl_.GetUniformLocation(out.name, "zone_colour");
    set_scene_uniforms(out.name);
    program_ = nullptr;
    return programs_[variant] = out;
}

void Peer::set_scene_uniforms(unsigned program)
{
    gl_.UseProgram(program);
    const auto place = [&](const std::string &name) { return gl_.GetUniformLocation(program, name.c_str()); };
    gl_.Uniform1i(place("texels"), 0);
    gl_.Uniform1i(place("atlas"), 1);
    gl_.Uniform3fv(place("scene_ambient"), 1, scene_.lighting.ambient.data());
    for (size_t i = 0; i < scene_.lighting.lights.size(); ++i) {
        const Light &light = scene_.lighting.lights[i];
        const std::string at = "[" + std::to_string(i) + "]";
        gl_.Uniform4fv(place("light_position" + at), 1, light.position.data());
        gl_.Uniform3fv(place("light_ambient" + at), 1, light.ambient.data());
        gl_.Uniform3fv(place("light_diffuse" + at), 1, light.diffuse.data());
        gl_.Uniform3fv(place("light_attenuation" + at), 1, light.attenuation.data());
        constexpr double radians = 0.017453292519943295;
        const float spot[4] = {light.spot_direction[0], light.spot_direction[1], light.spot_direction[2],
                               static_cast<float>(std::cos(static_cast<double>(light.spot_cutoff_deg) * radians))};
        gl_.Uniform4fv(place("light_spot" + at), 1, spot);
        gl_.Uniform1f(place("light_exponent" + at), light.spot ? light.spot_exponent : -1.0f);
    }
    const float half_picture[2] = {static_cast<float>(scene_.width) / 2, static_cast<float>(scene_.height) / 2};
    gl_.Uniform2fv(place("half_picture"), 1, half_picture);
    gl_.Uniform3fv(place("fog_colour"), 1, scene_.fog.colour.data());
    gl_.Uniform1f(place("fog_density"), scene_.fog.density);
    gl_.Uniform1f(place("fog_start"), scene_.fog.start);
    gl_.Uniform1f(place("fog_end"), scene_.fog.end);
}

}  // namespace parity_test
