#include "tests/gl/support/checked.h"

#include <algorithm>
#include <fstream>

#include "tests/support/patterns.h"

namespace gltest
{
namespace
{

// Which arguments are enums.
const std::map<std::string, std::vector<size_t>> &named_arguments()
{
    static const std::map<std::string, std::vector<size_t>> made = {{"glEnable", {0}},
                                                                    {"glDisable", {0}},
                                                                    {"glIsEnabled", {0}},
                                                                    {"glGetString", {0}},
                                                                    {"glGetIntegerv", {0}},
                                                                    {"glGetDoublev", {0}},
                                                                    {"glAlphaFunc", {0}},
                                                                    {"glDepthFunc", {0}},
                                                                    {"glCullFace", {0}},
                                                                    {"glFrontFace", {0}},
                                                                    {"glLightModeli", {0}},
                                                                    {"glGetMaterialfv", {0, 1}},
                                                                    {"glMaterialfv", {0, 1}},
                                                                    {"glColorMaterial", {0, 1}},
                                                                    {"glTexEnvi", {0, 1, 2}},
                                                                    {"glMatrixMode", {0}},
                                                                    {"glRenderMode", {0}},
                                                                    {"glBindTexture", {0}},
                                                                    {"glTexImage2D", {0, 2, 6, 7}},
                                                                    {"glTexParameteri", {0, 1, 2}},
                                                                    {"glGetTexLevelParameteriv", {0, 2}},
                                                                    {"glPixelStorei", {0}},
                                                                    {"glPixelTransferf", {0}},
                                                                    {"glEnableClientState", {0}},
                                                                    {"glDisableClientState", {0}},
                                                                    {"glVertexPointer", {1}},
                                                                    {"glNormalPointer", {0}},
                                                                    {"glTexCoordPointer", {1}},
                                                                    {"glColorPointer", {1}},
                                                                    {"glDrawElements", {0, 2}}};
    return made;
}

// Tables 6.25 and 6.26 of the specification: the minimum that an implementation must have.
int least_depth(uint32_t matrix_mode) { return matrix_mode == gl::modelview ? 32 : 2; }
constexpr int least_attribute_depth = 16;

bool power_of_two(double v)
{
    const int64_t n = static_cast<int64_t>(v);
    return n > 0 && (n & (n - 1)) == 0;
}

std::string hex(double v)
{
    char text[32];
    std::snprintf(text, sizeof text, "0x%04llX", static_cast<unsigned long long>(v));
    return text;
}

}  // namespace

const std::set<uint32_t> &values_of_gl_1_1()
{
    static const std::set<uint32_t> made = [] {
        std::ifstream file("/usr/include/GL/gl.h");
        std::set<uint32_t> values;
        const std::string define = "^#define\\s+GL_\\w+\\s+(0x[0-9A-Fa-f]+|[0-9]+)";
        for (std::string line; std::getline(file, line) && line.find("OpenGL 1.2") == std::string::npos;)
            if (const patterns::Match found = patterns::first_match(define, line); !found.empty())
                values.insert(static_cast<uint32_t>(std::stoul(found[1], nullptr, 0)));
        return values;
    }();
    return made;
}

Checked::Checked(Spy &spy) : depths_{{gl::modelview, 1}, {gl::projection, 1}, {gl::texture, 1}}
{
    spy.strings[gl::version] = "1.1 of old";
    spy.strings[gl::extensions] = "";
    spy.watch = [this](const std::string &name, const std::vector<double> &arguments) { check(name, arguments); };
}

void Checked::offend(const std::string &what)
{
    if (std::find(offences.begin(), offences.end(), what) == offences.end()) offences.push_back(what);
}

void Checked::check(const std::string &name, const std::vector<double> &arguments)
{
    ++calls;
    check_values(name, arguments);
    check_stacks(name, arguments);
    if (name == "glTexImage2D") check_texture(arguments);
    check_drawing(name, arguments);
}

void Checked::check_values(const std::string &name, const std::vector<double> &arguments)
{
    const auto named = named_arguments().find(name);
    if (named == named_arguments().end()) return;
    for (const size_t i : named->second)
        if (!values_of_gl_1_1().count(static_cast<uint32_t>(arguments[i]))) offend(name + " of " + hex(arguments[i]));
}

void Checked::check_stacks(const std::string &name, const std::vector<double> &arguments)
{
    if (name == "glMatrixMode") mode_ = static_cast<uint32_t>(arguments[0]);
    if (name == "glPushMatrix" && ++depths_[mode_] > least_depth(mode_))
        offend("glPushMatrix to " + std::to_string(depths_[mode_]) + " of " + hex(mode_));
    if (name == "glPopMatrix" && --depths_[mode_] < 1) offend("glPopMatrix of the host's own");
    if (name == "glPushAttrib" && ++attributes_ > least_attribute_depth) offend("glPushAttrib too often");
    if (name == "glPushAttrib" && arguments[0] > gl::all_attrib_bits) offend("glPushAttrib of " + hex(arguments[0]));
    if (name == "glPopAttrib" && --attributes_ < 0) offend("glPopAttrib of the host's own");
    if (name == "glPushClientAttrib" && ++client_ > least_attribute_depth) offend("glPushClientAttrib too often");
    if (name == "glPopClientAttrib" && --client_ < 0) offend("glPopClientAttrib of the host's own");
}

void Checked::check_texture(const std::vector<double> &a)
{
    if (!power_of_two(a[3]) || !power_of_two(a[4]))
        offend("a texture of " + std::to_string(int(a[3])) + " x " + std::to_string(int(a[4])));
    if (a[1] != 0 || a[5] != 0) offend("a texture with a border, or a level of one");
}

void Checked::check_drawing(const std::string &name, const std::vector<double> &a)
{
    const auto one_of = [&](double value, std::initializer_list<uint32_t> allowed) {
        if (std::find(allowed.begin(), allowed.end(), static_cast<uint32_t>(value)) == allowed.end())
            offend(name + " of type " + hex(value));
    };
    if (name == "glDrawElements") one_of(a[2], {gl::unsigned_byte, gl::unsigned_short, gl::unsigned_int});
    if (name == "glVertexPointer" || name == "glTexCoordPointer")
        one_of(a[1], {gl::signed_short, 0x1404, gl::real, 0x140A});
    if (name == "glNormalPointer") one_of(a[0], {gl::signed_byte, gl::signed_short, 0x1404, gl::real, 0x140A});
}

}  // namespace gltest
