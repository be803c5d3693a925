#include "tests/parity/shaders.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace parity_test
{

const char *const attribute_names[attribute_count] = {"position", "normal",  "uv",       "colour",
                                                      "joints0",  "joints1", "weights0", "weights1"};

bool Variant::operator<(const Variant &o) const
{
    return std::tie(what, joints, sets, normals_by_inverse, double_sided, holes, limiting, unlit, subpixel_bits) <
           std::tie(o.what, o.joints, o.sets, o.normals_by_inverse, o.double_sided, o.holes, o.limiting, o.unlit,
                    o.subpixel_bits);
}

double most_light(const Lighting &lighting)
{
    if (!lighting.enabled) return 1;
    double most = 0;
    // A normal gets most light from the lights on its side: the length of their sum, if they are directions.
    for (size_t channel = 0; channel < 3; ++channel) {
        double always = double(lighting.ambient[channel]);
        std::vector<std::array<double, 3>> directions;
        for (const Light &light : lighting.lights) {
            const double strength = double(light.diffuse[channel]);
            const double x = double(light.position[0]), y = double(light.position[1]), z = double(light.position[2]);
            const double length = std::sqrt(x * x + y * y + z * z);
            always += double(light.ambient[channel]);
            if (light.position[3] != 0 || !(length > 0)) always += strength;
            else directions.push_back({x / length * strength, y / length * strength, z / length * strength});
        }
        double longest = 0;
        for (size_t set = 1; set < size_t(1) << directions.size(); ++set) {
            double sum[3] = {0, 0, 0};
            for (size_t i = 0; i < directions.size(); ++i)
                for (size_t k = 0; k < 3; ++k) sum[k] += set >> i & 1 ? directions[i][k] : 0;
            longest = std::max(longest, std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]));
        }
        most = std::max(most, always + longest);
    }
    return most;
}

Limiting limiting_for(const Lighting &lighting)
{
    constexpr double most_for_knots = 1.3;
    return most_light(lighting) > most_for_knots ? Limiting::zones : Limiting::knots;
}

namespace
{

constexpr const char *vertex_text = R"(
attribute vec3 position, normal;
attribute vec2 uv;
attribute vec4 colour, joints0, joints1, weights0, weights1;
uniform vec4 palette[3 * JOINTS];  // three rows a joint
#ifdef NORMALS_BY_INVERSE
uniform vec4 normal_palette[3 * JOINTS];
#endif
#if LIGHTS > 0
uniform vec4 light_position[LIGHTS];
uniform vec3 light_ambient[LIGHTS], light_diffuse[LIGHTS], light_attenuation[LIGHTS];
uniform vec4 light_spot[LIGHTS];       // the direction, and the cosine of the cutoff
uniform float light_exponent[LIGHTS];  // below 0: no spot
#endif
uniform vec3 scene_ambient;
uniform vec3 zone_colour, emission;
uniform vec2 half_picture;
#ifdef VERTICES
varying vec3 out_position, out_normal;
#endif
varying vec3 front[KNOTS];
#ifdef DOUBLE_SIDED
varying vec3 behind[KNOTS];
#endif
varying vec2 at;
varying float distance_to_eye;

vec4 rows[3], normal_rows[3];

void follow(float joint, float weight)
{
    int first = 3 * int(joint + 0.5);
    for (int row = 0; row < 3; ++row) {
        rows[row] += weight * palette[first + row];
#ifdef NORMALS_BY_INVERSE
        normal_rows[row] += weight * normal_palette[first + row];
#endif
    }
}

vec3 light(vec3 n, vec3 eye)
{
#ifndef LIT
    return vec3(1.0);
#else
    vec3 sum = scene_ambient;
#if LIGHTS > 0
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = light_position[i].xyz;
        float strength = 1.0;
        if (light_position[i].w != 0.0) {
            to_light = to_light / light_position[i].w - eye;
            float d = length(to_light);
            strength = 1.0 / dot(light_attenuation[i], vec3(1.0, d, d * d));
        }
        if (light_exponent[i] >= 0.0) {
            float along = dot(-normalize(to_light), normalize(light_spot[i].xyz));
            strength *= along < light_spot[i].w ? 0.0 : pow(max(along, 0.0), light_exponent[i]);
        }
        sum += strength * (light_ambient[i] + max(dot(n, normalize(to_light)), 0.0) * light_diffuse[i]);
    }
#endif
    return sum;
#endif
}

void main()
{
    for (int row = 0; row < 3; ++row) rows[row] = normal_rows[row] = vec4(0.0);
    follow(joints0.x, weights0.x);
    follow(joints0.y, weights0.y);
    follow(joints0.z, weights0.z);
    follow(joints0.w, weights0.w);
#if SETS > 1
    follow(joints1.x, weights1.x);
    follow(joints1.y, weights1.y);
    follow(joints1.z, weights1.z);
    follow(joints1.w, weights1.w);
#endif
    vec4 v = vec4(position, 1.0);
    vec3 skinned;  // summed in claque's order, which dot() does not promise
    for (int row = 0; row < 3; ++row)
        skinned[row] = ((rows[row].x * v.x + rows[row].y * v.y) + rows[row].z * v.z) + rows[row].w;
#ifdef NORMALS_BY_INVERSE
    vec3 n = vec3(dot(normal_rows[0].xyz, normal), dot(normal_rows[1].xyz, normal), dot(normal_rows[2].xyz, normal));
#else
    vec3 n = vec3(dot(rows[0].xyz, normal), dot(rows[1].xyz, normal), dot(rows[2].xyz, normal));
#endif
#ifdef VERTICES
    out_position = skinned;
    out_normal = n;
#endif
    v = vec4(skinned, 1.0);
    gl_Position = gl_ModelViewProjectionMatrix * v;
#ifdef SUBPIXELS
    if (gl_Position.w > 0.0) {
        vec2 at_picture = gl_Position.xy / gl_Position.w * half_picture + half_picture;
        at_picture = floor(at_picture * SUBPIXELS + 0.5) / SUBPIXELS;
        gl_Position.xy = (at_picture - half_picture) / half_picture * gl_Position.w;
    }
#endif
    at = uv;
#ifdef COLOUR
    vec3 eye = (gl_ModelViewMatrix * v).xyz;
    n = normalize(gl_NormalMatrix * n);
#ifdef BY_ZONE
    vec3 own = colour.rgb * zone_colour;
#else
    vec3 own = colour.rgb;
#endif
#ifdef BY_ZONE
    vec3 more = emission;
#else
    vec3 more = vec3(0.0);
#endif
    vec3 lit = light(n, eye) * own + more;
    for (int k = 0; k < KNOTS; ++k) front[k] = min(lit, LIMIT(k));
#ifdef DOUBLE_SIDED
    lit = light(-n, eye) * own + more;
    for (int k = 0; k < KNOTS; ++k) behind[k] = min(lit, LIMIT(k));
#endif
    distance_to_eye = abs(eye.z);
#endif
}
)";

constexpr const char *fragment_text = R"(
uniform sampler2D texels, atlas;
uniform float row, key;
uniform vec3 id, fog_colour, emission;
uniform float fog_density, fog_start, fog_end;
varying vec3 front[KNOTS];
#ifdef DOUBLE_SIDED
varying vec3 behind[KNOTS];
#endif
varying vec2 at;
varying float distance_to_eye;

// The light, limited at the vertices so that light times this colour is at most 1.
vec3 limited(vec3 zone, vec3 light[KNOTS])
{
    vec3 sum = light[0];
#if KNOTS > 1
    vec3 place = (1.0 / max(zone, 0.001) - 1.0) * KNOTS_A_UNIT;
    for (int k = 1; k < KNOTS; ++k) sum += clamp(place - float(k - 1), 0.0, 1.0) * (light[k] - light[k - 1]);
#endif
    return sum;
}

void main()
{
    vec4 texel = texture2D(texels, at);
#ifdef BY_ZONE
    if (abs(texel.a * 255.0 - key) > 0.5) discard;
#endif
#ifdef HOLES
    if (texel.a < 0.5 / 255.0) discard;
#endif
#ifdef COLOUR
#ifdef BY_ZONE
    vec3 zone = vec3(1.0);
#else
    vec3 zone = texture2D(atlas, vec2((texel.a * 255.0 + 0.5) / 256.0, row)).rgb;
#endif
#ifdef DOUBLE_SIDED
    vec3 lit = gl_FrontFacing ? limited(zone, front) : limited(zone, behind);
#else
    vec3 lit = limited(zone, front);
#endif
#ifdef BY_ZONE
    vec3 colour = min(zone * lit, 1.0) * texel.rgb;
#else
    vec3 colour = min(zone * lit + emission, 1.0) * texel.rgb;
#endif
#ifdef FOG
    colour = mix(fog_colour, colour, clamp(FOG, 0.0, 1.0));
#endif
    gl_FragColor = vec4(colour, 1.0);
#elif defined(ACTOR)
    gl_FragColor = vec4(id, 1.0);
#else
    gl_FragColor = vec4(texel.a, 0.0, 0.0, 1.0);
#endif
}
)";

// OpenGL 1.1 multiplies a vertex's light by its colour and limits the product to 1. Here the colour is known only per
// pixel, so the vertex shader passes on the light limited for each of a few values, and the fragment shader
// interpolates between them.
constexpr int most_knots = 4;

std::string defines_of(const Variant &variant, const Lighting &lighting)
{
    std::string out = "#version 120\n";
    const char *names[] = {"COLOUR", "ACTOR", "ZONE", "VERTICES"};
    out += std::string("#define ") + names[static_cast<int>(variant.what)] + "\n";
    if (variant.double_sided) out += "#define DOUBLE_SIDED\n";
    if (variant.normals_by_inverse) out += "#define NORMALS_BY_INVERSE\n";
    if (variant.holes) out += "#define HOLES\n";
    if (variant.limiting == Limiting::zones) out += "#define BY_ZONE\n";
    const double most = most_light(lighting);
    const int knots = most > 1 && variant.limiting == Limiting::knots ? most_knots : 1;
    const double step = knots > 1 ? (most - 1) / (knots - 1) : 1;
    const std::string last = variant.limiting == Limiting::zones ? "1.0" : "1.0e6";
    out += "#define KNOTS " + std::to_string(knots) + "\n#define KNOTS_A_UNIT " + std::to_string(1 / step) +
           "\n#define LIMIT(k) ((k) == KNOTS - 1 ? " + last + " : 1.0 + float(k) * " + std::to_string(step) + ")\n";
    return out;
}

}  // namespace

std::string vertex_shader(const Variant &variant, const Lighting &lighting)
{
    return defines_of(variant, lighting) + "#define JOINTS " + std::to_string(variant.joints) + "\n#define SETS " +
           std::to_string(variant.sets) + "\n#define LIGHTS " + std::to_string(lighting.lights.size()) +
           (lighting.enabled && !variant.unlit ? "\n#define LIT" : "") +
           (variant.subpixel_bits > 0 ? "\n#define SUBPIXELS " + std::to_string(1 << variant.subpixel_bits) + ".0"
                                      : "") +
           vertex_text;
}

std::string fragment_shader(const Variant &variant, const Lighting &lighting, const Fog &fog)
{
    std::string out = defines_of(variant, lighting);
    if (fog.mode == "exp") out += "#define FOG exp(-fog_density * distance_to_eye)\n";
    else if (fog.mode == "exp2")
        out += "#define FOG exp(-fog_density * fog_density * distance_to_eye * distance_to_eye)\n";
    else if (fog.mode == "linear") out += "#define FOG (fog_end - distance_to_eye) / (fog_end - fog_start)\n";
    return out + fragment_text;
}

}  // namespace parity_test
