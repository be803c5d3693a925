// Compares the drawing cost of a distant level as a mesh with that of an impostor of the same colour variety: one
// textured quad that faces the eye, drawn once per visible zone with an alpha threshold (fused), batched in the
// same way. The unit is nanoseconds of processor time of all threads, of the shortest of many frames; one run measures
// both.
#include <cmath>

#include "lib/figures/figure.h"
#include "lib/lod/proxies/proxy.h"
#include "tests/bench/measure.h"
#include "tests/gl/support/pictures.h"
#include "tests/gl/support/split.h"

namespace
{

using namespace claque;
using namespace gltest;

constexpr int width = 1024, height = 768;
constexpr uint32_t people = 500, columns = 50;

double all_threads_ns()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

PosedModel mesh_of(uint32_t triangles)
{
    model::Model model = figures::citizen();
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    lod::ProxyMeshOptions options;
    options.targets = {triangles};
    lod::ProxyLevels proxies = lod::make_proxies(model, parts, options);
    lod::add_to_model(proxies, model);
    model.texture_sets.clear();
    model.parts = proxies.parts;
    return split_posed(model);
}

// Individuals in rows, `tall_px` high, all in view.
struct Field {
    explicit Field(float tall_px)
    {
        std::string why;
        context = contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why);
        if (!context) return;
        host = std::make_unique<HostGl>(*context);
        const float scale = tall_px / 1.75f;  // pixels per metre: a parallel projection, so that all have one height
        projection[0] = 2 * scale / width, projection[5] = 2 * scale / height;
        projection[10] = -0.01f, projection[15] = 1;
        for (uint32_t person = 0; person < people; ++person)
            places.push_back({(float(person % columns) + 0.5f) * 20 / scale - width / 2 / scale,
                              (float(person / columns) + 0.3f) * 18 / scale - height / 2 / scale, -5});
        for (uint32_t i = 0; i < 3 * zones * people; ++i) colours.push_back(uint8_t(60 + i * 37 % 190));
        light();
    }
    void light() const
    {
        const float above[4] = {0.3f, 0.8f, 0.5f, 0};
        host->Lightfv(0x4000, 0x1203, above);
        host->Enable(0x4000);
        host->Enable(0x0B50);
        host->Viewport(0, 0, width, height);
    }
    // Time for one individual, of the shortest of many frames.
    template <class Draw>
    void measure(benchmark::State &state, const Draw &draw) const
    {
        double shortest = 1e300;
        const auto frame = [&] {
            host->clear(0.1f, 0.1f, 0.1f);
            host->Finish();
            const double begun = all_threads_ns();
            draw();
            host->Finish();
            return all_threads_ns() - begun;
        };
        frame();  // GL compiles what this state needs
        for (auto _ : state) shortest = std::min(shortest, frame());
        state.counters["ns/person"] = shortest / people;
    }

    static constexpr uint32_t zones = 16;
    std::unique_ptr<contexts::Offscreen> context;
    std::unique_ptr<HostGl> host;
    float projection[16] = {0};
    std::vector<glm::vec3> places;
    std::vector<uint8_t> colours;  // of all individuals, `zones` each
};

void mesh(benchmark::State &state, uint32_t triangles, float tall_px)
{
    const Field field(tall_px);
    if (!field.context) return state.SkipWithError("no software GL here");
    const PosedModel posed = mesh_of(triangles);
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    if (!renderer.open(field.context->get_proc_address(), field.context->user()).ok() ||
        !renderer.prepare(*posed.tmpl).ok())
        return state.SkipWithError("the renderer refused");
    draw::DrawList list(std::pmr::get_default_resource());
    std::copy_n(field.projection, 16, list.projection);
    for (uint32_t person = 0; person < people; ++person) {
        draw::Item item;
        item.tmpl = posed.tmpl.get();
        item.vertices.positions = posed.positions.data();
        item.vertices.normals = posed.normals.data();
        item.zone_rgb = field.colours.data() + size_t(3) * Field::zones * person;
        const float c = std::cos(0.1f * float(person)), s = std::sin(0.1f * float(person));
        const glm::vec3 at = field.places[person];
        const float matrix[16] = {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, at.x, at.y, at.z, 1};
        std::copy_n(matrix, 16, item.model_view);
        list.items.push_back(item);
    }
    field.measure(state, [&] { renderer.draw(list, nullptr); });
    state.counters["triangles"] = double(posed.tmpl->report.triangles);
}

// Bodies on a sheet of eight by eight views, each a column of `zones` bands; holes elsewhere.
void load_views(const HostGl &host, uint32_t zones)
{
    constexpr uint32_t side = 256, cell = 32;
    std::vector<uint8_t> rgba(4 * side * side, 255);
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const double across = std::fabs((x % cell + 0.5) / cell - 0.5);
            const uint32_t band = (y % cell) * zones / cell;
            rgba[4 * size_t(y * side + x) + 3] = across > 0.22 ? 0 : uint8_t(94 + 160 * band / zones);
        }
    uint32_t name = 0;
    host.GenTextures(1, &name);
    host.BindTexture(gl::texture_2d, name);
    host.TexParameteri(gl::texture_2d, gl::texture_min_filter, int(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int(gl::nearest));
    host.TexImage2D(gl::texture_2d, 0, int(gl::rgba8), side, side, 0, gl::rgba, gl::unsigned_byte, rgba.data());
}

void set_up(const HostGl &host, const float *projection)
{
    for (const gl::Enum on : {gl::texture_2d, gl::alpha_test, gl::depth_test, gl::normalize}) host.Enable(on);
    host.TexEnvi(gl::texture_env, gl::texture_env_mode, int(gl::modulate));
    host.AlphaFunc(gl::gequal, 94.0f / 255.0f - 0.01f);
    host.DepthFunc(gl::lequal);
    host.ColorMaterial(gl::front_and_back, gl::ambient_and_diffuse);
    host.Enable(gl::colour_material);
    host.MatrixMode(gl::projection);
    host.LoadMatrixf(projection);
    host.MatrixMode(gl::modelview);
    host.LoadIdentity();
    for (const gl::Enum array : {gl::vertex_array, gl::normal_array, gl::texture_coord_array, gl::colour_array})
        host.EnableClientState(array);
}

// Quads of many individuals, one after the other; indices never change.
struct Quads {
    static constexpr uint32_t room = 2048;
    explicit Quads(const HostGl &host) : host_(host)
    {
        for (uint32_t quad = 0; quad < room / 4; ++quad)
            for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices_.push_back(uint16_t(4 * quad + k));
        normals_.assign(3 * room, 0);
        for (uint32_t v = 0; v < room; ++v) normals_[3 * v + 2] = 1;
        positions_.resize(3 * room), uvs_.resize(2 * room), colours_.resize(4 * room);
    }
    void add(const glm::vec3 &at, const uint8_t *rgb, uint32_t zones, uint32_t view)
    {
        if (count_ + 4 * zones > room) flush();
        const float u = float(view % 8) / 8, v = float(view / 8 % 8) / 8;
        for (uint32_t zone = 0; zone < zones; ++zone)
            for (uint32_t corner = 0; corner < 4; ++corner, ++count_) {
                const float right = corner == 1 || corner == 2 ? 1.0f : 0.0f, up = corner > 1 ? 1.0f : 0.0f;
                float *p = &positions_[3 * count_];
                p[0] = at.x + 0.9f * (right - 0.5f), p[1] = at.y + 1.75f * up, p[2] = at.z;
                uvs_[2 * count_] = u + right / 8, uvs_[2 * count_ + 1] = v + up / 8;
                uint8_t *c = &colours_[4 * count_];
                c[0] = rgb[3 * zone], c[1] = rgb[3 * zone + 1], c[2] = rgb[3 * zone + 2];
                c[3] = zone == 0 ? 255 : uint8_t(255 * 94 / (94 + 160 * zone / zones));
            }
    }
    void flush()
    {
        if (count_ == 0) return;
        host_.VertexPointer(3, gl::real, 0, positions_.data());
        host_.NormalPointer(gl::real, 0, normals_.data());
        host_.TexCoordPointer(2, gl::real, 0, uvs_.data());
        host_.ColorPointer(4, gl::unsigned_byte, 0, colours_.data());
        host_.DrawElements(gl::triangles, int(count_ / 4 * 6), gl::unsigned_short, indices_.data());
        count_ = 0;
    }

private:
    const HostGl &host_;
    std::vector<float> positions_, normals_, uvs_;
    std::vector<uint8_t> colours_;
    std::vector<uint16_t> indices_;
    uint32_t count_ = 0;
};

void impostor(benchmark::State &state, uint32_t zones, float tall_px)
{
    const Field field(tall_px);
    if (!field.context) return state.SkipWithError("no software GL here");
    load_views(*field.host, zones);
    set_up(*field.host, field.projection);
    Quads quads(*field.host);
    field.measure(state, [&] {
        for (uint32_t person = 0; person < people; ++person)
            quads.add(field.places[person], field.colours.data() + size_t(3) * Field::zones * person, zones,
                      person % 64);
        quads.flush();
    });
}

constexpr int frames = 30;

#define FIELD(px)                                                                        \
    BENCHMARK_CAPTURE(mesh, 14_triangles_##px##_px, 14u, float(px))->Iterations(frames); \
    BENCHMARK_CAPTURE(mesh, 30_triangles_##px##_px, 30u, float(px))->Iterations(frames); \
    BENCHMARK_CAPTURE(impostor, 1_zone_##px##_px, 1u, float(px))->Iterations(frames);    \
    BENCHMARK_CAPTURE(impostor, 4_zones_##px##_px, 4u, float(px))->Iterations(frames);   \
    BENCHMARK_CAPTURE(impostor, 9_zones_##px##_px, 9u, float(px))->Iterations(frames)

FIELD(8);
FIELD(16);

}  // namespace
