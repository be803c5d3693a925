#include "tests/gl/support/state_dump.h"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/gl/support/state_names.h"

namespace gltest
{
namespace
{

using GetFloats2 = void (*)(gl::Enum, gl::Enum, float *);

std::vector<double> numbers(const float *values, int count) { return std::vector<double>(values, values + count); }

// State that is queried by two names: an object and its property.
void dump_pairs(State &state, const HostGl &host, const char *function, gl::Enum thing, const std::string &thing_name,
                std::initializer_list<StateName> names)
{
    const auto get = host.ask<GetFloats2>(function);
    for (const StateName &name : names) {
        float values[4] = {-99, -99, -99, -99};
        get(thing, name.name, values);
        // Lights and materials share names: a light is queried by its own.
        const bool light = thing >= 0x4000 && thing < 0x4008;
        state[thing_name + " " + name.text] = {light ? thing : name.name, numbers(values, name.count)};
    }
}

void dump_lights(State &state, const HostGl &host)
{
    for (uint32_t light = 0; light < 8; ++light)
        dump_pairs(state, host, "glGetLightfv", 0x4000 + light, "GL_LIGHT" + std::to_string(light),
                   {{0x1200, 4, "GL_AMBIENT"},
                    {0x1201, 4, "GL_DIFFUSE"},
                    {0x1202, 4, "GL_SPECULAR"},
                    {0x1203, 4, "GL_POSITION"},
                    {0x1204, 3, "GL_SPOT_DIRECTION"},
                    {0x1205, 1, "GL_SPOT_EXPONENT"},
                    {0x1206, 1, "GL_SPOT_CUTOFF"},
                    {0x1207, 1, "GL_CONSTANT_ATTENUATION"},
                    {0x1208, 1, "GL_LINEAR_ATTENUATION"},
                    {0x1209, 1, "GL_QUADRATIC_ATTENUATION"}});
    for (const auto &[face, name] : {std::pair(0x0404u, "GL_FRONT"), std::pair(0x0405u, "GL_BACK")})
        dump_pairs(state, host, "glGetMaterialfv", face, name,
                   {{0x1200, 4, "GL_AMBIENT"},
                    {0x1201, 4, "GL_DIFFUSE"},
                    {0x1202, 4, "GL_SPECULAR"},
                    {0x1600, 4, "GL_EMISSION"},
                    {0x1601, 1, "GL_SHININESS"},
                    {0x1603, 3, "GL_COLOR_INDEXES"}});
}

void dump_texturing(State &state, const HostGl &host)
{
    dump_pairs(state, host, "glGetTexEnvfv", gl::texture_env, "GL_TEXTURE_ENV",
               {{0x2200, 1, "GL_TEXTURE_ENV_MODE"}, {0x2201, 4, "GL_TEXTURE_ENV_COLOR"}});
    const char *const coordinates[] = {"GL_S", "GL_T", "GL_R", "GL_Q"};
    for (uint32_t c = 0; c < 4; ++c)
        dump_pairs(state, host, "glGetTexGenfv", 0x2000 + c, coordinates[c],
                   {{0x2500, 1, "GL_TEXTURE_GEN_MODE"}, {0x2501, 4, "GL_OBJECT_PLANE"}, {0x2502, 4, "GL_EYE_PLANE"}});
    for (const auto &[target, name] : {std::pair(0x0DE0u, "GL_TEXTURE_1D"), std::pair(0x0DE1u, "GL_TEXTURE_2D")})
        dump_pairs(state, host, "glGetTexParameterfv", target, name,
                   {{0x2800, 1, "GL_TEXTURE_MAG_FILTER"},
                    {0x2801, 1, "GL_TEXTURE_MIN_FILTER"},
                    {0x2802, 1, "GL_TEXTURE_WRAP_S"},
                    {0x2803, 1, "GL_TEXTURE_WRAP_T"},
                    {0x1004, 4, "GL_TEXTURE_BORDER_COLOR"},
                    {0x8066, 1, "GL_TEXTURE_PRIORITY"}});  // GL_TEXTURE_RESIDENT is GL's own decision
}

void dump_tables(State &state, const HostGl &host)
{
    const auto clip_plane = host.ask<void (*)(gl::Enum, double *)>("glGetClipPlane");
    for (uint32_t plane = 0; plane < 6; ++plane) {
        double equation[4] = {0};
        clip_plane(0x3000 + plane, equation);
        state["GL_CLIP_PLANE" + std::to_string(plane) + " equation"] = {0x3000 + plane,
                                                                        std::vector<double>(equation, equation + 4)};
    }
    uint8_t stipple[128] = {0};
    host.ask<void (*)(uint8_t *)>("glGetPolygonStipple")(stipple);
    state["polygon stipple pattern"] = {0x0B42, std::vector<double>(stipple, stipple + 128)};

    const auto pixel_map = host.ask<void (*)(gl::Enum, float *)>("glGetPixelMapfv");
    for (uint32_t map = 0; map < 10; ++map) {
        int32_t size = 0;
        host.GetIntegerv(0x0CB0 + map, &size);
        std::vector<float> values(static_cast<size_t>(size));
        pixel_map(0x0C70 + map, values.data());
        state["pixel map " + std::to_string(map)] = {0x0C70 + map, numbers(values.data(), size)};
    }
    constexpr StateName pointers[] = {
        {0x808E, 1, "GL_VERTEX_ARRAY_POINTER"},        {0x808F, 1, "GL_NORMAL_ARRAY_POINTER"},
        {0x8090, 1, "GL_COLOR_ARRAY_POINTER"},         {0x8091, 1, "GL_INDEX_ARRAY_POINTER"},
        {0x8092, 1, "GL_TEXTURE_COORD_ARRAY_POINTER"}, {0x8093, 1, "GL_EDGE_FLAG_ARRAY_POINTER"},
        {0x0DF0, 1, "GL_FEEDBACK_BUFFER_POINTER"},     {0x0DF3, 1, "GL_SELECTION_BUFFER_POINTER"}};
    const auto get_pointer = host.ask<void (*)(gl::Enum, void **)>("glGetPointerv");
    for (const StateName &name : pointers) {
        void *pointer = nullptr;
        get_pointer(name.name, &pointer);
        state[name.text] = {name.name, {static_cast<double>(reinterpret_cast<uintptr_t>(pointer))}};
    }
}

// Order, domain and control points of every evaluator.
void dump_maps(State &state, const HostGl &host)
{
    const auto get = host.ask<void (*)(gl::Enum, gl::Enum, double *)>("glGetMapdv");
    constexpr gl::Enum coefficients = 0x0A00, order = 0x0A01, domain = 0x0A02;
    for (uint32_t parameters = 1; parameters <= 2; ++parameters)
        for (uint32_t k = 0; k < 9; ++k) {
            const gl::Enum map = first_map[parameters - 1] + k;
            const std::string name = "map " + std::to_string(parameters) + "." + std::to_string(k);
            double orders[2] = {1, 1}, domains[4] = {0};
            get(map, order, orders);
            get(map, domain, domains);
            const size_t points = static_cast<size_t>(orders[0] * orders[1]) * size_t(map_components[k]);
            ASSERT_LT(points, 100000u) << name;
            std::vector<double> values(points);
            get(map, coefficients, values.data());
            state[name + " order"] = {map, {orders[0], orders[1]}};
            state[name + " domain"] = {map, std::vector<double>(domains, domains + 2 * parameters)};
            state[name + " coefficients"] = {map, values};
        }
}

}  // namespace

State dump_state(const HostGl &host, bool has_multisample)
{
    State state;
    for (const StateName &name : simple_state) {
        double values[16] = {0};
        host.GetDoublev(name.name, values);
        state[name.text] = {name.name, std::vector<double>(values, values + name.count)};
    }
    constexpr gl::Enum logic_op = 0x0BF2;  // indirect GLX does not know the query above
    state["GL_COLOR_LOGIC_OP"] = {logic_op, {double(host.IsEnabled(logic_op))}};
    if (has_multisample)
        for (const auto &[text, name] : {std::pair("GL_MULTISAMPLE", gl::multisample),
                                         std::pair("GL_SAMPLE_ALPHA_TO_COVERAGE", gl::sample_alpha_to_coverage),
                                         std::pair("GL_SAMPLE_ALPHA_TO_ONE", gl::sample_alpha_to_one)})
            state[text] = {name, {double(host.IsEnabled(name))}};
    dump_lights(state, host);
    dump_texturing(state, host);
    dump_tables(state, host);
    dump_maps(state, host);
    return state;
}

std::vector<std::string> differences(const State &before, const State &after)
{
    std::vector<std::string> names;
    for (const auto &[name, value] : before)
        if (value.values != after.at(name).values) names.push_back(name);
    return names;
}

std::string text_of(const StateValue &value)
{
    std::ostringstream text;
    for (const double v : value.values) text << v << ' ';
    return text.str();
}

}  // namespace gltest
