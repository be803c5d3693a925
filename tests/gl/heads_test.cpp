// Heads in levels of detail: where a level begins, a face looks as it does at the finest level.
#include <cmath>
#include <filesystem>

#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "lib/figures/figure.h"
#include "lib/lod/chain.h"
#include "meshsplit/build.h"
#include "samples/parity/flip.h"
#include "tests/gl/support/drawn_head.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

constexpr int side = 256, samples = 4;  // of a picture; along each side of a pixel of the reference

// The upper part of a character at rest, from the chin of most.
struct Head {
    glm::dvec3 centre = glm::dvec3(0);
    double half = 0;  // of its height
};

using Linear = parity::Map<parity::flip::Colour>;

class Heads : public testing::Test
{
protected:
    void TearDown() override
    {
        for (Drawer &drawer : drawers_)
            if (drawer.renderer && drawer.context->make_current()) drawer.renderer->destroy();
    }

    struct Drawer {
        std::unique_ptr<contexts::Offscreen> context;
        std::unique_ptr<passes::Renderer> renderer;
    };

    void make(model::Model character)
    {
        report_ = claque::lod::make_chain(character, {});
        tmpl_ = std::make_unique<model::Template>(std::pmr::get_default_resource());
        claque::meshsplit::build(character, {}, *tmpl_);
        for (const int pixels : {side, side * samples}) {
            Drawer &drawer = drawers_.emplace_back();
            std::string why;
            drawer.context =
                contexts::make_offscreen(contexts::Kind::any, pixels, pixels, contexts::PixelFormat::rgba8888, why);
            if (!drawer.context) END_WITHOUT_CONTEXT(contexts::Kind::any, why);
            drawer.renderer =
                std::make_unique<passes::Renderer>(std::pmr::get_default_resource(), passes::RendererOptions());
            ASSERT_TRUE(drawer.renderer->open(drawer.context->get_proc_address(), drawer.context->user()).ok());
            ASSERT_TRUE(drawer.renderer->prepare(*tmpl_).ok());
        }
        skin(*tmpl_, model::none, 0, positions_, normals_);
        glm::dvec3 low(1e30), high(-1e30);
        const auto each = [&](auto &&use) {
            for (size_t i = 0; i < positions_.size(); i += 3)
                use(glm::dvec3(positions_[i], positions_[i + 1], positions_[i + 2]));
        };
        each([&](const glm::dvec3 &p) { low = glm::min(low, p), high = glm::max(high, p); });
        // Alone, or on a body.
        head_.half = high.y - low.y < 0.5 ? 0.5 * (high.y - low.y) : 0.07 * (high.y - low.y);
        const double chin = high.y - 2 * head_.half;
        low = glm::dvec3(1e30), high = glm::dvec3(-1e30);
        each([&](const glm::dvec3 &p) {
            if (p.y >= chin) low = glm::min(low, p), high = glm::max(high, p);
        });
        head_.centre = 0.5 * (low + high);
    }

    // The head in the middle, from this distance through the lens that levels' distances are for.
    Linear picture(Drawer &drawer, uint32_t level, double distance_m, double turn_rad)
    {
        drawer.context->make_current();
        std::swap(tmpl_->levels[0], tmpl_->levels[level]);
        skin(*tmpl_, model::none, 0, positions_, normals_);
        std::swap(tmpl_->levels[0], tmpl_->levels[level]);
        Camera camera = {};
        const double tangent = 0.5 * side * 2 * std::sqrt(1.0 / 3) / 768, near = 0.05 * distance_m,
                     far = 20 * distance_m;
        camera.projection[0] = camera.projection[5] = float(1 / tangent);
        camera.projection[10] = float((far + near) / (near - far)), camera.projection[11] = -1;
        camera.projection[14] = float(2 * far * near / (near - far));
        const double c = std::cos(turn_rad), s = std::sin(turn_rad);
        const double rows[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
        for (int i = 0; i < 3; ++i) {
            double to = i == 2 ? -distance_m : 0;
            for (int k = 0; k < 3; ++k) {
                camera.model_view[4 * k + i] = float(rows[i][k]);
                to -= rows[i][k] * head_.centre[k];
            }
            camera.model_view[12 + i] = float(to);
        }
        camera.model_view[15] = 1;
        Individual one = {tmpl_.get(), positions_.data(), normals_.data(), nullptr, {}, 0};
        std::copy_n(camera.model_view, 16, one.model_view);
        claque::draw::DrawList list = list_of({one}, camera.projection);
        list.items[0].level = level;
        const Picture drawn = draw(*drawer.context, *drawer.renderer, list, 0);
        const int pixels = drawer.context->width(), each = pixels / side;
        const int half = std::min(side / 2, int(head_.half / (distance_m * tangent) * side / 2) + 1);
        Linear out(2 * half, 2 * half, {0, 0, 0});
        const int first = (side / 2 - half) * each;
        for (int y = 0; y < 2 * half * each; ++y)
            for (int x = 0; x < 2 * half * each; ++x) {
                const size_t from = 3 * (size_t(first + y) * size_t(pixels) + size_t(first + x));
                const parity::flip::Colour colour = parity::flip::linear_of(&drawn[from]);
                for (size_t k = 0; k < 3; ++k)
                    out.values[out.index(x / each, y / each)][k] += colour[k] / float(each * each);
            }
        return out;
    }

    struct Excess {
        double mean = 0, worst = 0, face_or_back = 0;  // of all sides, of all sides, and of these two
    };

    // By how much a level's pictures from eight sides are worse than the finest level's, over the pixels of the head
    // alone. At this size one side depends on how the pixels happen to lie.
    Excess excess(uint32_t level, double distance_m)
    {
        constexpr int sides = 8;
        Excess found;
        for (int view = 0; view < sides; ++view) {
            const double turn = 0.3 + 2 * 3.14159265 * view / sides;
            const Linear reference = picture(drawers_[1], 0, distance_m, turn);
            const auto map = [&](uint32_t of) {
                return parity::flip_map(reference, picture(drawers_[0], of, distance_m, turn),
                                        parity::pixels_per_degree());
            };
            const parity::Map<float> of_level = map(level), of_finest = map(0);
            double sum = 0, count = 0;
            for (size_t i = 0; i < reference.values.size(); ++i) {
                const parity::flip::Colour empty = parity::flip::linear_of(background), &here = reference.values[i];
                if (std::fabs(here[0] - empty[0]) + std::fabs(here[1] - empty[1]) + std::fabs(here[2] - empty[2]) <
                    1e-4f)
                    continue;
                sum += double(of_level.values[i] - of_finest.values[i]), ++count;
            }
            EXPECT_GT(count, 20);
            found.mean += sum / count / sides;
            found.worst = std::max(found.worst, sum / count);
            if (view % (sides / 2) == 0) found.face_or_back = std::max(found.face_or_back, sum / count);
        }
        return found;
    }

    // Where a character is 87 pixels long or more, as its shape alone counts farther away (docs/levels.md), and not so
    // near that the eye is in the head.
    void expect_faces(double most, uint32_t least_levels)
    {
        uint32_t seen = 0;
        for (uint32_t level = 1; level < tmpl_->levels.size(); ++level) {
            const double distance_m = double(tmpl_->levels[level].switch_distance_m);
            if (distance_m < 4 * head_.half) continue;
            if (87 * report_[level].error_m > report_[level].deviation.look.longest_m) break;
            const Excess found = excess(level, distance_m);
            EXPECT_LE(found.mean, 0.05) << report_[level].triangles << " triangles from " << distance_m << " m";
            EXPECT_LE(found.face_or_back, most) << report_[level].triangles << " triangles from " << distance_m << " m";
            EXPECT_LE(found.worst, 0.09) << report_[level].triangles << " triangles from " << distance_m << " m";
            ++seen;
        }
        EXPECT_GE(seen, least_levels);
    }

    std::unique_ptr<model::Template> tmpl_;
    std::vector<claque::lod::LevelReport> report_;
    std::vector<Drawer> drawers_;
    std::vector<float> positions_, normals_;
    Head head_;
};

TEST_F(Heads, OfADrawnFaceInSeveralChartsLookAsAtTheFinestLevel)
{
    make(drawn_head());
    if (drawers_.size() == 2) expect_faces(0.05, 1);
}

struct Character {
    const char *name;
    double most;      // by which face or back may be worse
    uint32_t levels;  // that begin where it is so large, at least
};

std::string name_of(const testing::TestParamInfo<Character> &one)
{
    std::string name;
    for (const char c : std::string(one.param.name)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

class HeadsOfPeople : public Heads, public testing::WithParamInterface<Character>
{
};

TEST_P(HeadsOfPeople, LookAsAtTheFinestLevel)
{
    for (const claque::figures::Builtin &one : claque::figures::people())
        if (std::string(one.name) == GetParam().name) make(one.make());
    if (drawers_.size() == 2) expect_faces(GetParam().most, GetParam().levels);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, HeadsOfPeople,
                         testing::Values(Character{"citizen", 0.05, 3}, Character{"patrician", 0.05, 3},
                                         Character{"decurion", 0.05, 3}, Character{"plebeian", 0.05, 3}),
                         name_of);

class HeadsOfFiles : public Heads, public testing::WithParamInterface<Character>
{
};

TEST_P(HeadsOfFiles, LookAsAtTheFinestLevel)
{
    const std::string path = std::string(CLAQUE_ASSETS_DIR "/") + GetParam().name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    const std::vector<uint8_t> bytes = claque::asset::read_file(path, 1u << 30);
    make(claque::asset::load_gltf(bytes.data(), bytes.size(), {}));
    if (drawers_.size() == 2) expect_faces(GetParam().most, GetParam().levels);
}

INSTANTIATE_TEST_SUITE_P(Are, HeadsOfFiles,
                         testing::Values(Character{"compressed/valid-Asian_F_1_Busi.glb", 0.05, 4},
                                         Character{"conformance-real/yuka-soldier.glb", 0.05, 1},
                                         Character{"hipoly/Man_King.glb", 0.05, 2}),
                         name_of);

}  // namespace
}  // namespace gltest
