#include "samples/parity/write/gl_query.h"

#include <array>

#include "samples/scenes/check.h"

namespace parity
{
namespace
{

constexpr unsigned lighting = 0x0B50, light_model_ambient = 0x0B53;
constexpr unsigned light0 = 0x4000, max_lights = 0x0D31;
constexpr unsigned ambient = 0x1200, diffuse = 0x1201, position = 0x1203;
constexpr unsigned spot_direction = 0x1204, spot_exponent = 0x1205, spot_cutoff = 0x1206;
constexpr unsigned constant_attenuation = 0x1207, linear_attenuation = 0x1208, quadratic_attenuation = 0x1209;
constexpr unsigned fog = 0x0B60, fog_density = 0x0B62, fog_start = 0x0B63, fog_end = 0x0B64, fog_mode = 0x0B65,
                   fog_color = 0x0B66;
constexpr unsigned subpixel_bits_name = 0x0D50;
constexpr unsigned exp_mode = 0x0800, exp2_mode = 0x0801;

class Query
{
public:
    explicit Query(const contexts::Offscreen &context)
    {
        find(context, "glIsEnabled", is_enabled_);
        find(context, "glGetFloatv", get_float_);
        find(context, "glGetIntegerv", get_integer_);
        find(context, "glGetLightfv", get_light_);
    }
    bool on(unsigned name) const { return is_enabled_(name) != 0; }
    int whole(unsigned name) const
    {
        int value[16] = {0};
        get_integer_(name, value);
        return value[0];
    }
    float number(unsigned name) const
    {
        float value[16] = {0};
        get_float_(name, value);
        return value[0];
    }
    Json colour(unsigned name) const
    {
        float value[16] = {0};
        get_float_(name, value);
        return {value[0], value[1], value[2]};
    }
    std::array<float, 4> of_light(unsigned light, unsigned name) const
    {
        std::array<float, 4> value{};
        get_light_(light, name, value.data());
        return value;
    }

private:
    template <class Function>
    static void find(const contexts::Offscreen &context, const char *name, Function &function)
    {
        function = reinterpret_cast<Function>(context.get_proc_address()(context.user(), name));
        if (!function) throw scenes::Failure(std::string("this OpenGL context lacks ") + name);
    }
    unsigned char (*is_enabled_)(unsigned) = nullptr;
    void (*get_float_)(unsigned, float *) = nullptr;
    void (*get_integer_)(unsigned, int *) = nullptr;
    void (*get_light_)(unsigned, unsigned, float *) = nullptr;
};

Json light_of(const Query &query, unsigned light)
{
    const auto three = [&](unsigned name) {
        const std::array<float, 4> c = query.of_light(light, name);
        return Json{c[0], c[1], c[2]};
    };
    const std::array<float, 4> at = query.of_light(light, position);
    Json out = {{"position_eye", at},
                {"ambient", three(ambient)},
                {"diffuse", three(diffuse)},
                {"attenuation",
                 {query.of_light(light, constant_attenuation)[0], query.of_light(light, linear_attenuation)[0],
                  query.of_light(light, quadratic_attenuation)[0]}}};
    const float cutoff = query.of_light(light, spot_cutoff)[0];
    constexpr float none = 180;
    if (cutoff != none)
        out["spot"] = {{"direction_eye", three(spot_direction)},
                       {"exponent", query.of_light(light, spot_exponent)[0]},
                       {"cutoff_deg", cutoff}};
    return out;
}

}  // namespace

Json lighting_of(const contexts::Offscreen &context)
{
    const Query query(context);
    Json out = {{"enabled", query.on(lighting)}, {"ambient", query.colour(light_model_ambient)}};
    out["lights"] = Json::array();
    const unsigned count = static_cast<unsigned>(query.whole(max_lights));
    for (unsigned light = light0; light < light0 + count; ++light)
        if (query.on(light)) out["lights"].push_back(light_of(query, light));
    return out;
}

int subpixel_bits(const contexts::Offscreen &context) { return Query(context).whole(subpixel_bits_name); }

Json fog_of(const contexts::Offscreen &context)
{
    const Query query(context);
    if (!query.on(fog)) return nullptr;
    const unsigned mode = static_cast<unsigned>(query.whole(fog_mode));
    return {{"mode", mode == exp_mode    ? "exp"
                     : mode == exp2_mode ? "exp2"
                                         : "linear"},
            {"colour", query.colour(fog_color)},
            {"density", query.number(fog_density)},
            {"start", query.number(fog_start)},
            {"end", query.number(fog_end)}};
}

}  // namespace parity
