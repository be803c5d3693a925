#include "passes/preflight.h"

#include <cstring>

namespace claque::passes
{
namespace
{

enum class Ask : uint8_t { enabled, not_zero, not_unit_0, not_last };
enum class Spoils : uint8_t { drawing, uploads, both };

constexpr int never_in_core = 9999;
constexpr int32_t texture_unit_0 = 0x84C0, last_vertex_convention = 0x8E4E;

// State newer than GL 1.1 that changes the effect of 1.1 calls.
struct Spoiler {
    gl::Enum name;
    Ask ask;
    Spoils spoils;
    int since;              // 10 * major + minor
    const char *extension;  // that adds it to older versions, or null
    const char *what;
};

constexpr Spoiler spoilers[] = {
    {0x84E0, Ask::not_unit_0, Spoils::both, 13, "GL_ARB_multitexture", "the active texture unit is not 0"},
    {0x84E1, Ask::not_unit_0, Spoils::drawing, 13, "GL_ARB_multitexture", "the client's active texture unit is not 0"},
    {0x8894, Ask::not_zero, Spoils::drawing, 15, "GL_ARB_vertex_buffer_object", "a buffer is bound: GL_ARRAY_BUFFER"},
    {0x8895, Ask::not_zero, Spoils::drawing, 15, "GL_ARB_vertex_buffer_object",
     "a buffer is bound: GL_ELEMENT_ARRAY_BUFFER"},
    {0x85B5, Ask::not_zero, Spoils::drawing, 30, "GL_ARB_vertex_array_object", "a vertex array object is bound"},
    {0x88EF, Ask::not_zero, Spoils::uploads, 21, "GL_ARB_pixel_buffer_object",
     "a buffer is bound: GL_PIXEL_UNPACK_BUFFER"},
    {0x8B8D, Ask::not_zero, Spoils::drawing, 20, nullptr, "a program is in use"},
    {0x825A, Ask::not_zero, Spoils::drawing, 41, "GL_ARB_separate_shader_objects", "a program pipeline is bound"},
    {0x8620, Ask::enabled, Spoils::drawing, never_in_core, "GL_ARB_vertex_program", "GL_VERTEX_PROGRAM_ARB is on"},
    {0x8804, Ask::enabled, Spoils::drawing, never_in_core, "GL_ARB_fragment_program", "GL_FRAGMENT_PROGRAM_ARB is on"},
    {0x806F, Ask::enabled, Spoils::drawing, 12, "GL_EXT_texture3D", "GL_TEXTURE_3D is on"},
    {0x8513, Ask::enabled, Spoils::drawing, 13, "GL_ARB_texture_cube_map", "GL_TEXTURE_CUBE_MAP is on"},
    {0x84F5, Ask::enabled, Spoils::drawing, never_in_core, "GL_ARB_texture_rectangle", "GL_TEXTURE_RECTANGLE is on"},
    {0x8919, Ask::not_zero, Spoils::drawing, 33, "GL_ARB_sampler_objects", "a sampler object is bound to unit 0"},
    {0x8457, Ask::enabled, Spoils::drawing, 14, "GL_EXT_fog_coord", "GL_FOG_COORD_ARRAY is on"},
    {0x845E, Ask::enabled, Spoils::drawing, 14, "GL_EXT_secondary_color", "GL_SECONDARY_COLOR_ARRAY is on"},
    {0x8E4F, Ask::not_last, Spoils::drawing, 32, "GL_EXT_provoking_vertex",
     "triangles take their colour from the first vertex: glProvokingVertex"},
    {0x8F9D, Ask::enabled, Spoils::drawing, 31, nullptr, "GL_PRIMITIVE_RESTART is on"},
};
constexpr int spoiler_count = sizeof spoilers / sizeof spoilers[0];

// "4.5 (Compatibility Profile) Mesa" is 45; a text that cannot be read is 11, the minimum.
int version_of(const char *text)
{
    if (text[0] < '1' || text[0] > '9' || text[1] != '.' || text[2] < '0' || text[2] > '9') return 11;
    return 10 * (text[0] - '0') + (text[2] - '0');
}

bool contains_word(const char *words, const char *word)
{
    const size_t length = std::strlen(word);
    for (const char *at = words; (at = std::strstr(at, word)); at += length)
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0)) return true;
    return false;
}

base::Status check_stack(const Gl11 &gl, int32_t entries, gl::Enum depth, gl::Enum maximum, const char *name)
{
    if (entries == 0 || integer(gl, depth) + entries <= integer(gl, maximum)) return base::Status::good();
    return base::Status::bad(CLQ_GL_STATE, "the host has taken %d of %d places of the %s stack, claque needs %d",
                             integer(gl, depth), integer(gl, maximum), name, entries);
}

base::Status check_stacks(const Gl11 &gl, StackEntries entries)
{
    base::Status status =
        check_stack(gl, entries.attributes, gl::attrib_stack_depth, gl::max_attrib_stack_depth, "glPushAttrib");
    if (!status.ok()) return status;
    return check_stack(gl, entries.client, gl::client_attrib_stack_depth, gl::max_client_attrib_stack_depth,
                       "glPushClientAttrib");
}

}  // namespace

base::Status Preflight::learn(const Gl11 &gl)
{
    static_assert(spoiler_count <= max_spoilers, "make room in known_");
    constexpr gl::Enum context_profile_mask = 0x9126;
    constexpr int32_t core_profile_bit = 1;

    const char *text = reinterpret_cast<const char *>(gl.GetString(gl::version));
    if (!text) return check_current(gl);
    const int version = version_of(text);
    if (version >= 32 && (integer(gl, context_profile_mask) & core_profile_bit))
        return base::Status::bad(CLQ_GL_MISSING, "the GL context is a core profile (%s), which has no fixed function",
                                 text);

    const char *extensions = reinterpret_cast<const char *>(gl.GetString(gl::extensions));
    const auto knows = [&](int since, const char *extension) {
        return version >= since || (extension && extensions && contains_word(extensions, extension));
    };
    for (int i = 0; i < spoiler_count; ++i) known_[i] = knows(spoilers[i].since, spoilers[i].extension);
    multisample_ = knows(13, "GL_ARB_multisample");
    return base::Status::good();
}

base::Status Preflight::check(const Gl11 &gl, bool upload) const
{
    if (base::Status current = check_current(gl); !current.ok()) return current;
    if (const int32_t list = integer(gl, gl::list_index))
        return base::Status::bad(CLQ_GL_STATE, "the display list %d is being compiled", list);
    for (int i = 0; i < spoiler_count; ++i) {
        const Spoiler &spoiler = spoilers[i];
        if (!known_[i] || spoiler.spoils == (upload ? Spoils::drawing : Spoils::uploads)) continue;
        bool on = false;
        if (spoiler.ask == Ask::enabled) on = gl.IsEnabled(spoiler.name) != gl::no;
        if (spoiler.ask == Ask::not_zero) on = integer(gl, spoiler.name) != 0;
        if (spoiler.ask == Ask::not_unit_0) on = integer(gl, spoiler.name) != texture_unit_0;
        if (spoiler.ask == Ask::not_last) on = integer(gl, spoiler.name) != last_vertex_convention;
        if (on) return base::Status::bad(CLQ_GL_STATE, "%s", spoiler.what);
    }
    return base::Status::good();
}

base::Status Preflight::check_target(const Gl11 &gl) const
{
    base::Status status = check(gl, false);
    if (!status.ok()) return status;
    if (integer(gl, gl::render_mode) != static_cast<int32_t>(gl::render))
        return base::Status::bad(CLQ_GL_STATE, "the render mode is not GL_RENDER but selection or feedback");
    if (!integer(gl, gl::rgba_mode)) return base::Status::bad(CLQ_GL_STATE, "the target is in colour index mode");
    return base::Status::good();
}

base::Status Preflight::check_draw(const Gl11 &gl, StackEntries entries) const
{
    base::Status status = check_target(gl);
    return status.ok() ? check_stacks(gl, entries) : status;
}

base::Status Preflight::check_upload(const Gl11 &gl) const
{
    base::Status status = check(gl, true);
    if (!status.ok()) return status;
    return check_stacks(gl, {1, 1});
}

}  // namespace claque::passes
