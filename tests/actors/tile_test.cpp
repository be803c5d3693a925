// A view of a part of a picture lists what can be seen in that part, as the view of the whole picture shows it. Each
// part has a crowd of its own, as in a process of its own, and its borders move from frame to frame.
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

constexpr uint32_t people = 120;

struct Tile {
    float left, bottom, right, top;
};

// The k-th division of a picture into six tiles: two rows of three.
std::vector<Tile> divided(uint32_t k)
{
    const auto cut = [&](uint32_t i, double from, double to) {
        return float(from + (to - from) * random_unit(40 + i, k));
    };
    const float x[] = {0, cut(0, 0.1, 0.5), cut(1, 0.5, 0.9), 1}, y[] = {0, cut(2, 0.3, 0.7), 1};
    std::vector<Tile> tiles;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) tiles.push_back({x[column], y[row], x[column + 1], y[row + 1]});
    return tiles;
}

std::unique_ptr<World> field(const frame::Settings &settings)
{
    auto world = std::make_unique<World>(settings);
    for (uint32_t i = 0; i < people; ++i) {
        const crowd::Id id = world->add({80 * (random_unit(1, i) - 0.5), 0, 80 * (random_unit(2, i) - 0.5)},
                                        6 * float(random_unit(3, i)));
        crowd::play(world->crowd, id, crowd::Play{0, 0, 0.8f + float(random_unit(4, i)), float(random_unit(5, i))});
    }
    world->look({0, 4, 60}, {0, 1, 0});
    return world;
}

void place_camera(World &world, uint32_t k)
{
    const double way = 0.05 * k;
    world.views[0]->camera = frame::look_at({30 * std::sin(way), 3 + 2 * std::sin(3 * way), 45 * std::cos(way)},
                                            {0, 1, 0}, glm::vec3(0, 1, 0), 1.0f, 1.3f, 0.1f, 500);
}

// Which parts of an individual have a vertex in a tile, by the inequalities of clip space.
uint64_t parts_in(const frame::View &view, const draw::Item &item, const Tile &tile)
{
    const model::Level &level = item.tmpl->levels[item.level];
    const uint32_t parts = static_cast<uint32_t>(level.parts.size());
    uint64_t found = 0;
    for (const model::Surface &surface : level.surfaces)
        for (uint32_t i = 0; i < surface.fused.count; ++i) {
            const float *p = item.vertices.positions + 3 * level.indices[surface.fused.first + i];
            double eye[4] = {0, 0, 0, 1}, clip[4] = {};
            for (int r = 0; r < 3; ++r)
                eye[r] = double(item.model_view[12 + r]) + double(item.model_view[r]) * double(p[0]) +
                         double(item.model_view[4 + r]) * double(p[1]) + double(item.model_view[8 + r]) * double(p[2]);
            for (int r = 0; r < 4; ++r)
                for (int c = 0; c < 4; ++c) clip[r] += double(view.list.projection[4 * c + r]) * eye[c];
            const double x = (clip[0] / clip[3] + 1) / 2, y = (clip[1] / clip[3] + 1) / 2;
            if (!(clip[3] > 0.1) || x < double(tile.left) || x > double(tile.right) || y < double(tile.bottom) ||
                y > double(tile.top))
                continue;
            uint32_t part = 0;  // a surface of one part has no offsets
            const size_t before =
                surface.part_offsets.size() - std::min<size_t>(surface.part_offsets.size(), parts + 1);
            while (part + 1 < parts && surface.part_offsets[before + part + 1] <= i) ++part;
            found |= uint64_t(1) << part;
        }
    return found;
}

bool same_bytes(const float *a, const float *b, size_t count) { return std::memcmp(a, b, count * sizeof *a) == 0; }

void expect_same(const draw::Item &one, const draw::Item &whole)
{
    EXPECT_EQ(one.level, whole.level);
    EXPECT_EQ(one.eye_distance_m, whole.eye_distance_m);
    EXPECT_TRUE(same_bytes(one.model_view, whole.model_view, 16));
    const size_t floats = 3 * size_t(whole.tmpl->levels[whole.level].vertex_count);
    EXPECT_TRUE(same_bytes(one.vertices.positions, whole.vertices.positions, floats)) << "actor " << one.actor_index;
    EXPECT_TRUE(same_bytes(one.vertices.normals, whole.vertices.normals, floats)) << "actor " << one.actor_index;
}

struct Seen {
    size_t in_tiles = 0, in_whole = 0;
};

// Each of 60 frames, drawn by tiles that forget nothing between frames.
Seen compare(const frame::Settings &settings)
{
    Seen seen;
    const auto whole = field(settings);
    std::vector<std::unique_ptr<World>> tiles;
    for (size_t i = 0; i < 6; ++i) tiles.push_back(field(settings));
    for (uint32_t k = 0; k < 60; ++k) {
        place_camera(*whole, k);
        whole->update(0.04 * k);
        const auto &all = whole->views[0]->list.items;
        seen.in_whole += all.size();
        const std::vector<Tile> cut = divided(k);
        for (size_t t = 0; t < 6; ++t) {
            frame::View &view = *tiles[t]->views[0];
            place_camera(*tiles[t], k);
            std::memcpy(view.tile, &cut[t], sizeof view.tile);
            tiles[t]->update(0.04 * k);
            seen.in_tiles += view.list.items.size();
            size_t next = 0;
            for (const draw::Item &item : all) {
                const bool listed =
                    next < view.list.items.size() && view.list.items[next].actor_index == item.actor_index;
                const uint64_t shown = parts_in(*whole->views[0], item, cut[t]);
                EXPECT_EQ(shown & ~(listed ? view.list.items[next].parts : 0), 0u)
                    << "frame " << k << ", tile " << t << " lacks a part of actor " << item.actor_index;
                if (listed) expect_same(view.list.items[next++], item);
            }
            EXPECT_EQ(next, view.list.items.size()) << "frame " << k << ", tile " << t << " has an order of its own";
            if (testing::Test::HasFailure()) return seen;
        }
    }
    return seen;
}

}  // namespace

TEST(Tile, ListsWhatIsSeenInItAsTheWholePictureShowsIt)
{
    const Seen seen = compare(frame::Settings());
    EXPECT_GT(seen.in_whole, 2000u);
    EXPECT_LT(double(seen.in_tiles), 1.6 * double(seen.in_whole)) << "tiles are culled by the whole picture";
    EXPECT_GT(seen.in_tiles, seen.in_whole) << "nobody stands on a border";
}

TEST(Tile, ListsTheSameWithoutCachesAndInTraditionalMode)
{
    frame::Settings settings;
    settings.caches.mode = animcache::Mode::none;
    compare(settings);
    settings.cull = frame::Cull::traditional;
    compare(settings);
}

TEST(Tile, OfANarrowedPyramidIsWhatBothContain)
{
    World world;
    frame::View &view = world.look({0, 0, 50}, {0, 0, 0}, 1.5707963f, 1);  // half the picture is 50 m at the actors
    const crowd::Id left = world.add({-20, 0, 0}), right = world.add({20, 0, 0}), far_right = world.add({40, 0, 0});
    const float half[4] = {0.5f, 0, 1, 1};
    std::memcpy(view.tile, half, sizeof half);
    world.update(0);
    EXPECT_FALSE(world.seen(left).visible);
    EXPECT_TRUE(world.seen(right).visible && world.seen(far_right).visible);
    view.cull_scale = 0.5f;
    world.update(1);
    EXPECT_FALSE(world.seen(left).visible || world.seen(far_right).visible);
    EXPECT_TRUE(world.seen(right).visible);
}
