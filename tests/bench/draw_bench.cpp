// Whole frames of a thousand people without levels and caches, against the textbook's way to draw the same bodies in
// the same poses: skin, then one plain glDrawElements each; or S1's passes, all triangles once for each zone.
//
// All ways take turns, so that other load on the machine counts for all alike. Times are of the processors, all threads
// and GL's together. The textbook gets its matrix palettes for nothing, and does not cull.
//
// Also what GL itself takes for a texture for each person instead of one for all, and for interleaved arrays: the
// textbook without skinning.
#include <cmath>
#include <functional>

#include "lib/crowd/edits.h"
#include "lib/figures/figure.h"
#include "lib/frame/frame.h"
#include "lib/pose/pose.h"
#include "meshsplit/build.h"
#include "tests/bench/measure.h"
#include "tests/bench/textbook.h"
#include "tests/gl/support/pictures.h"

namespace
{

using namespace claque;
using namespace gltest;

constexpr int width = 1024, height = 768;
constexpr uint32_t people = 1000, across = 40;
constexpr double shown_s = 2;
constexpr uint32_t small_side = 128;  // of the textures that each person gets, in texels

double phase_of(uint32_t person) { return 0.1 * double(person % 37); }

std::unique_ptr<model::Template> citizen()
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    meshsplit::build(figures::citizen(), {}, *tmpl);
    return tmpl;
}

// A field of people, all in view; everybody is due in every update.
struct Field {
    explicit Field(const model::Template &tmpl)
        : crowd(std::pmr::get_default_resource()),
          frame(std::pmr::get_default_resource(), settings()),
          view(std::pmr::get_default_resource())
    {
        for (uint32_t person = 0; person < people; ++person) {
            crowd::Transform place;
            place.position = glm::dvec3(1.2 * (person % across - 0.5 * (across - 1)), 0, -1.2 * (person / across));
            crowd::Play play;
            play.clip = 0;
            play.phase_s = float(phase_of(person));
            ids.push_back(crowd::create(crowd, tmpl, place, play, person));
        }
        view.camera = frame::look_at({0, 14, 26}, {0, 0, -15}, {0, 1, 0}, 1.0472f, float(width) / height, 0.5f, 1000);
    }
    static frame::Settings settings()
    {
        frame::Settings out;
        out.caches.period = {0, 0, 1, 2};
        return out;
    }
    void colour(const model::Template &tmpl, bool alike)
    {
        std::vector<float> rgb(3 * tmpl.zone_count(), 1.0f);
        for (uint32_t person = 0; person < people; ++person) {
            for (size_t i = 0; i < rgb.size() && !alike; ++i) rgb[i] = float((person * 37 + i * 91) % 160 + 80) / 255;
            crowd::set_colours(crowd, ids[person], rgb.data(), tmpl.zone_count());
        }
    }
    void update()
    {
        frame::View *views[1] = {&view};
        frame::update(crowd, frame, {views, 1}, shown_s, base::Jobs());
    }
    crowd::Crowd crowd;
    frame::Frame frame;
    frame::View view;
    std::vector<crowd::Id> ids;
};

// The textbook's renderer: one template, its texture, and for each person a palette and a matrix.
class Textbook
{
public:
    Textbook(const HostGl &host, const model::Template &tmpl, const draw::DrawList &list) : host_(host), tmpl_(tmpl)
    {
        const model::Level &level = tmpl.levels[0];
        for (const model::Bin &bin : level.surfaces[0].clean) add(bin.range);
        add(level.surfaces[0].dirty);
        pose::Workspace workspace(tmpl.rig);
        for (const draw::Item &item : list.items) {
            const auto palette = workspace.pose(0, shown_s + phase_of(item.actor_index));
            people_.emplace_back();
            for (uint32_t i = 0; i < palette.count; ++i) people_.back().palette.push_back(math::mat4_of(palette[i]));
            std::copy_n(item.model_view, 16, people_.back().model_view);
        }
        skinned_.resize(size_t(6) * level.source_count);
        const model::Texture &from = tmpl.textures[0];
        texture_ = upload(from.width, from.height, from.rgba);
        std::vector<uint8_t> small;
        for (uint32_t y = 0; y < small_side; ++y)
            for (uint32_t x = 0; x < small_side; ++x) {
                const size_t texel = size_t(y * from.height / small_side) * from.width + x * from.width / small_side;
                small.insert(small.end(), from.rgba.data() + 4 * texel, from.rgba.data() + 4 * texel + 4);
            }
        for (size_t i = 0; i < people_.size(); ++i) small_.push_back(upload(small_side, small_side, small));
    }

    // Passes: 1, or one for each zone of the texture under its alpha test, as S1 3 has them.
    void draw(uint32_t passes, const float *projection)
    {
        begin(projection, passes > 1);
        const model::Texture &texture = tmpl_.textures[0];
        for (const Person &person : people_) {
            bench::textbook_skin(tmpl_.levels[0], person.palette.data(), skinned_.data());
            host_.LoadMatrixf(person.model_view);
            for (uint32_t pass = 0; pass < passes; ++pass) {
                const float key = float(texture.keys[pass % texture.keys.size()].key) / 255;
                if (passes > 1) host_.AlphaFunc(gl::gequal, key - 0.002f), host_.Color4f(1 - key, key, 1, 1);
                host_.DrawElements(gl::triangles, int32_t(indices_.size()), gl::unsigned_short, indices_.data());
            }
        }
        end();
    }

    // All in the pose of the first, with the first small texture or each with its own.
    void draw_unskinned(bool own_textures, bool interleaved, const float *projection)
    {
        begin(projection, false);
        bench::textbook_skin(tmpl_.levels[0], people_[0].palette.data(), skinned_.data());
        if (interleaved) interleave();
        host_.BindTexture(gl::texture_2d, small_[0]);
        for (size_t i = 0; i < people_.size(); ++i) {
            if (own_textures) host_.BindTexture(gl::texture_2d, small_[i]);
            host_.LoadMatrixf(people_[i].model_view);
            host_.DrawElements(gl::triangles, int32_t(indices_.size()), gl::unsigned_short, indices_.data());
        }
        end();
    }

private:
    template <class Bytes>
    uint32_t upload(uint32_t wide, uint32_t high, const Bytes &rgba) const
    {
        uint32_t texture = 0;
        host_.GenTextures(1, &texture);
        host_.BindTexture(gl::texture_2d, texture);
        host_.TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
        host_.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
        host_.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(wide), int32_t(high), 0, gl::rgba,
                         gl::unsigned_byte, rgba.data());
        host_.BindTexture(gl::texture_2d, 0);
        return texture;
    }

    // Position, normal and texture coordinates of a vertex side by side.
    void interleave()
    {
        const model::Level &level = tmpl_.levels[0];
        mixed_.clear();
        for (size_t v = 0; v < level.source_count; ++v) {
            const float *from = skinned_.data() + 3 * v;
            mixed_.insert(mixed_.end(), from, from + 3);
            mixed_.insert(mixed_.end(), from + size_t(3) * level.source_count,
                          from + size_t(3) * level.source_count + 3);
            mixed_.insert(mixed_.end(), level.uvs.data() + 2 * v, level.uvs.data() + 2 * v + 2);
        }
        host_.VertexPointer(3, gl::real, 32, mixed_.data());
        host_.NormalPointer(gl::real, 32, mixed_.data() + 3);
        host_.TexCoordPointer(2, gl::real, 32, mixed_.data() + 6);
    }

    struct Person {
        std::vector<glm::mat4> palette;
        float model_view[16];
    };

    void add(model::IndexRange range)
    {
        const auto first = tmpl_.levels[0].indices.begin() + range.first;
        indices_.insert(indices_.end(), first, first + range.count);
    }
    void begin(const float *projection, bool tests)
    {
        const model::Level &level = tmpl_.levels[0];
        for (const gl::Enum on : {gl::depth_test, gl::cull_face, gl::texture_2d}) host_.Enable(on);
        if (tests) host_.Enable(gl::alpha_test), host_.Enable(gl::colour_material);
        host_.DepthFunc(gl::lequal);
        host_.BindTexture(gl::texture_2d, texture_);
        host_.MatrixMode(gl::projection);
        host_.LoadMatrixf(projection);
        host_.MatrixMode(gl::modelview);
        for (const gl::Enum array : {gl::vertex_array, gl::normal_array, gl::texture_coord_array})
            host_.EnableClientState(array);
        host_.VertexPointer(3, gl::real, 0, skinned_.data());
        host_.NormalPointer(gl::real, 0, skinned_.data() + size_t(3) * level.source_count);
        host_.TexCoordPointer(2, gl::real, 0, level.uvs.data());
    }
    void end()
    {
        for (const gl::Enum array : {gl::vertex_array, gl::normal_array, gl::texture_coord_array})
            host_.DisableClientState(array);
        for (const gl::Enum off : {gl::alpha_test, gl::colour_material, gl::cull_face}) host_.Disable(off);
        host_.BindTexture(gl::texture_2d, 0);
    }

    const HostGl &host_;
    const model::Template &tmpl_;
    std::vector<Person> people_;
    std::vector<float> skinned_, mixed_;  // of one person after the other
    std::vector<uint16_t> indices_;
    uint32_t texture_ = 0;
    std::vector<uint32_t> small_;  // one for each person
};

double all_threads_ms()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

struct Way {
    const char *name;
    std::function<void()> draw;
    std::vector<double> ms;
};

double median_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void against_the_textbook(benchmark::State &state)
{
    std::string why;
    const auto context =
        contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why);
    if (!context) return state.SkipWithError("no software GL here");
    const HostGl host(*context);
    const float above[4] = {0.3f, 0.8f, 0.5f, 0};
    host.Lightfv(0x4000, 0x1203, above);
    host.Enable(0x4000);
    host.Enable(0x0B50);
    host.Viewport(0, 0, width, height);
    const std::unique_ptr<model::Template> tmpl = citizen();
    passes::Renderer renderer(std::pmr::get_default_resource(), {});
    if (!renderer.open(context->get_proc_address(), context->user()).ok() || !renderer.prepare(*tmpl).ok())
        return state.SkipWithError("the renderer refused");
    Field coloured(*tmpl), alike(*tmpl);
    coloured.colour(*tmpl, false), alike.colour(*tmpl, true);
    alike.update();
    Textbook textbook(host, *tmpl, alike.view.list);
    const float *projection = alike.view.camera.projection;
    const uint32_t zones = uint32_t(tmpl->textures[0].keys.size());
    const auto claque_draws = [&](Field &field) {
        field.update();
        renderer.draw(field.view.list, nullptr);
    };
    Way ways[] = {{"textbook", [&] { textbook.draw(1, projection); }, {}},
                  {"textbook_zones", [&] { textbook.draw(zones, projection); }, {}},
                  {"uncoloured", [&] { claque_draws(alike); }, {}},
                  {"coloured", [&] { claque_draws(coloured); }, {}},
                  {"one_texture", [&] { textbook.draw_unskinned(false, false, projection); }, {}},
                  {"own_textures", [&] { textbook.draw_unskinned(true, false, projection); }, {}},
                  {"interleaved", [&] { textbook.draw_unskinned(false, true, projection); }, {}}};
    bool counted = false;
    for (auto _ : state) {
        for (Way &way : ways) {
            host.clear(0.1f, 0.1f, 0.1f);
            host.Finish();
            const double begun = all_threads_ms();
            way.draw();
            host.Finish();
            if (counted) way.ms.push_back(all_threads_ms() - begun);
        }
        counted = true;  // GL compiled what the first round needs
    }
    state.counters["zones"] = zones;
    for (const Way &way : ways) {
        state.counters[std::string(way.name) + "_ms"] = *std::min_element(way.ms.begin(), way.ms.end());
        std::vector<double> ratios;
        for (size_t i = 0; i < way.ms.size(); ++i) ratios.push_back(way.ms[i] / ways[0].ms[i]);
        state.counters[std::string(way.name) + "_ratio"] = median_of(ratios);
    }
    const auto of_one_texture = [&](const Way &way) {
        std::vector<double> ratios;
        for (size_t i = 0; i < way.ms.size(); ++i) ratios.push_back(way.ms[i] / ways[4].ms[i]);
        return median_of(ratios);
    };
    state.counters["own_textures_of_one"] = of_one_texture(ways[5]);
    state.counters["interleaved_of_apart"] = of_one_texture(ways[6]);
}

BENCHMARK(against_the_textbook)->Iterations(21)->Unit(benchmark::kMillisecond);

}  // namespace
