#include "samples/parity/write/id_pictures.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "samples/parity/write/texels.h"
#include "samples/scenes/check.h"
#include "samples/scenes/gl.h"

namespace parity
{

using scenes::check;
namespace gl = scenes::gl;

namespace
{

constexpr unsigned all_attributes = 0xFFFFF, all_client_attributes = 0xFFFFFFFF;
constexpr unsigned alpha_test = 0x0BC0, greater = 0x0204, dither = 0x0BD0, back = 0x0405, clockwise = 0x0900,
                   counter_clockwise = 0x0901, replace = 0x1E01, nearest = 0x2600, alpha_format = 0x1906;

struct More {
    void (*PushAttrib)(unsigned);
    void (*PopAttrib)();
    void (*PushClientAttrib)(unsigned);
    void (*PopClientAttrib)();
    void (*AlphaFunc)(unsigned, float);
    void (*CullFace)(unsigned);
    void (*FrontFace)(unsigned);
    void (*Color3ub)(uint8_t, uint8_t, uint8_t);
};

class Painter
{
public:
    Painter(const contexts::Offscreen &context, const DrawnActors &drawn_actors, const Skinned &skinned);
    ~Painter();
    Painter(const Painter &) = delete;
    Painter &operator=(const Painter &) = delete;

    enum class What { actor, zone };
    void paint(What what, const float projection[16]);

private:
    struct Names {
        unsigned zones = 0, holes = 0;
    };
    using Key = std::tuple<const clq_template *, uint32_t, uint32_t>;  // texture, set

    Names textures_of(const Individual &who, uint32_t texture);
    unsigned upload(unsigned format, const std::vector<uint8_t> &texels, uint32_t width, uint32_t height,
                    const Key &key);
    void begin(What what, const float projection[16]);
    void draw(What what, const Individual &who);

    scenes::Gl gl_;
    More more_{};
    const DrawnActors &shown_;
    const Skinned &skinned_;
    std::map<Key, Names> textures_;
};

Painter::Painter(const contexts::Offscreen &context, const DrawnActors &drawn_actors, const Skinned &skinned)
    : shown_(drawn_actors), skinned_(skinned)
{
    std::string missing;
    const auto find = [&](const char *name, auto &function) {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(context.get_proc_address()(context.user(), name));
        if (!function) missing = name;
    };
    if (!load(gl_, context.get_proc_address(), context.user(), missing))
        throw scenes::Failure("this OpenGL context lacks " + missing);
    find("glPushAttrib", more_.PushAttrib), find("glPopAttrib", more_.PopAttrib);
    find("glPushClientAttrib", more_.PushClientAttrib), find("glPopClientAttrib", more_.PopClientAttrib);
    find("glAlphaFunc", more_.AlphaFunc), find("glCullFace", more_.CullFace);
    find("glFrontFace", more_.FrontFace), find("glColor3ub", more_.Color3ub);
    if (!missing.empty()) throw scenes::Failure("this OpenGL context lacks " + missing);
    more_.PushAttrib(all_attributes);
    more_.PushClientAttrib(all_client_attributes);
}

Painter::~Painter()
{
    more_.PopClientAttrib();
    more_.PopAttrib();
    for (const auto &[key, names] : textures_) {
        const unsigned both[2] = {names.zones, names.holes};
        gl_.DeleteTextures(2, both);
    }
}

unsigned Painter::upload(unsigned format, const std::vector<uint8_t> &texels, uint32_t width, uint32_t height,
                         const Key &key)
{
    clq_wrap wrap_s, wrap_t;
    check(clq_template_get_wrap(std::get<0>(key), std::get<1>(key), &wrap_s, &wrap_t));
    const auto wrap = [](clq_wrap w) { return static_cast<int>(w == CLQ_WRAP_CLAMP ? gl::clamp : gl::repeat); };
    unsigned name = 0;
    gl_.GenTextures(1, &name);
    gl_.BindTexture(gl::texture_2d, name);
    gl_.PixelStorei(gl::unpack_alignment, 1);
    gl_.TexParameteri(gl::texture_2d, gl::min_filter, static_cast<int>(nearest));
    gl_.TexParameteri(gl::texture_2d, gl::mag_filter, static_cast<int>(nearest));
    gl_.TexParameteri(gl::texture_2d, gl::wrap_s, wrap(wrap_s));
    gl_.TexParameteri(gl::texture_2d, gl::wrap_t, wrap(wrap_t));
    gl_.TexImage2D(gl::texture_2d, 0, static_cast<int>(format), static_cast<int>(width), static_cast<int>(height), 0,
                   format, gl::unsigned_byte, texels.data());
    return name;
}

Painter::Names Painter::textures_of(const Individual &who, uint32_t texture)
{
    const Key key = {who.drawn_actors.tmpl, texture, shown_.meshes()[who.mesh].texture_set};
    Names &names = textures_[key];
    if (names.zones) return names;
    const Texels texels(std::get<0>(key), std::get<1>(key), std::get<2>(key));
    std::vector<uint8_t> zones, holes;
    for (const uint32_t zone : texels.zones) {
        const uint32_t number = zone == CLQ_NONE ? 0 : zone + 1;
        const uint8_t solid = zone == CLQ_NONE ? 0 : 255;
        zones.insert(zones.end(), {static_cast<uint8_t>(number & 255), static_cast<uint8_t>(number >> 8), 0, solid});
        holes.push_back(solid);
    }
    names.zones = upload(gl::rgba, zones, texels.width, texels.height, key);
    names.holes = upload(alpha_format, holes, texels.width, texels.height, key);
    return names;
}

void Painter::begin(What what, const float projection[16])
{
    for (const unsigned off : {gl::lighting, gl::fog, gl::blend, dither, gl::polygon_offset_fill}) gl_.Disable(off);
    for (const unsigned on : {gl::texture_2d, gl::depth_test, alpha_test}) gl_.Enable(on);
    more_.AlphaFunc(greater, 0.5f);
    more_.CullFace(back);
    gl_.DepthFunc(gl::lequal);
    gl_.DepthMask(1);
    gl_.TexEnvi(gl::texture_env, gl::texture_env_mode, static_cast<int>(what == What::zone ? replace : gl::modulate));
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    gl_.MatrixMode(gl::projection);
    gl_.LoadMatrixf(projection);
    gl_.MatrixMode(gl::modelview);
    gl_.DisableClientState(gl::normal_array);
    gl_.DisableClientState(gl::color_array);
    gl_.EnableClientState(gl::vertex_array);
    gl_.EnableClientState(gl::texcoord_array);
}

void Painter::draw(What what, const Individual &who)
{
    clq_mesh mesh = clq_mesh_init();
    check(clq_template_get_mesh(who.drawn_actors.tmpl, who.drawn_actors.level, &mesh));
    gl_.LoadMatrixf(who.drawn_actors.model_view);
    gl_.VertexPointer(3, gl::float_type, 0, skinned_.positions.data() + 3 * static_cast<size_t>(who.first_vertex));
    gl_.TexCoordPointer(2, gl::float_type, 0, mesh.uvs);
    more_.FrontFace(who.drawn_actors.mirrored ? clockwise : counter_clockwise);
    const uint32_t id = who.drawn_actors.actor.index1;
    more_.Color3ub(static_cast<uint8_t>(id & 255), static_cast<uint8_t>(id >> 8 & 255),
                   static_cast<uint8_t>(id >> 16 & 255));
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        check(clq_template_get_triangles(who.drawn_actors.tmpl, who.drawn_actors.level, bin, &triangles));
        const Names names = textures_of(who, triangles.texture);
        gl_.BindTexture(gl::texture_2d, what == What::zone ? names.zones : names.holes);
        triangles.double_sided ? gl_.Disable(gl::cull_face) : gl_.Enable(gl::cull_face);
        gl_.DrawElements(gl::triangles, static_cast<int>(triangles.index_count), gl::unsigned_int, triangles.indices);
    }
}

void Painter::paint(What what, const float projection[16])
{
    begin(what, projection);
    std::vector<const Individual *> order;
    for (const Individual &who : shown_.individuals()) order.push_back(&who);
    std::sort(order.begin(), order.end(), [](const Individual *a, const Individual *b) { return a->place < b->place; });
    for (const Individual *who : order) draw(what, *who);
}

}  // namespace

IdPictures id_pictures(const contexts::Offscreen &context, const DrawnActors &drawn_actors, const Skinned &skinned,
                       const float projection[16])
{
    Painter painter(context, drawn_actors, skinned);
    IdPictures out;
    std::vector<uint8_t> rgb;
    painter.paint(Painter::What::actor, projection);
    context.read_rgb(rgb);
    for (size_t i = 0; i < rgb.size(); i += 3)
        out.actor.push_back(rgb[i] | static_cast<uint32_t>(rgb[i + 1]) << 8 | static_cast<uint32_t>(rgb[i + 2]) << 16);
    painter.paint(Painter::What::zone, projection);
    context.read_rgb(rgb);
    for (size_t i = 0; i < rgb.size(); i += 3) out.zone.push_back(static_cast<uint16_t>(rgb[i] | rgb[i + 1] << 8));
    return out;
}

}  // namespace parity
