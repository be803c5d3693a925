#include "samples/scenes/town/trees.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"
#include "samples/scenes/town/landmarks.h"

namespace scenes::town
{
namespace
{

constexpr double shaded_m = 620;  // shadows of farther trees are not visible
constexpr Rgb bark = {0.42f, 0.34f, 0.27f};
constexpr Rgb greens[] = {
    {0.42f, 0.60f, 0.26f}, {0.36f, 0.54f, 0.24f}, {0.48f, 0.62f, 0.28f}, {0.40f, 0.52f, 0.20f}, {0.54f, 0.60f, 0.26f}};

class Gardener
{
public:
    Gardener(const Plan &plan, const std::vector<House> &houses, uint64_t seed)
        : plan_(plan), houses_(houses), seed_(seed)
    {
    }

    std::vector<Tree> plant()
    {
        for (const Block &b : plan_.blocks()) {
            const int wanted = b.kind == Block::Kind::park     ? 26
                               : b.kind == Block::Kind::houses ? 6
                               : b.kind == Block::Kind::yards  ? 3
                                                               : 0;
            for (int i = 0; i < wanted; ++i) {
                const uint64_t number = draws_++;
                const double u = random_between(seed_, number, Purpose::place_x, b.u0 + 4, b.u1 - 4);
                const double v = random_between(seed_, number, Purpose::place_z, b.v0 + 4, b.v1 - 4);
                try_at(number, u, v);
            }
        }
        on_square();
        avenues();
        by_stream();
        between_fields();
        return std::move(trees_);
    }

private:
    void try_at(uint64_t number, double u, double v)
    {
        const double share = random_unit(seed_, number, Purpose::tree);
        add(number, u, v, share < 0.80 ? Tree::Kind::broad : share < 0.9 ? Tree::Kind::poplar : Tree::Kind::fir);
    }

    void add(uint64_t number, double u, double v, Tree::Kind kind)
    {
        Tree t = {};
        t.kind = kind;
        t.at = plan_.at(u, v);
        const double size = random_between(seed_, number, Purpose::size, 0.78, 1.2);
        t.height_m = size * (kind == Tree::Kind::broad ? 8.2 : 12.5);
        t.radius_m = size * (kind == Tree::Kind::broad ? 3.3 : kind == Tree::Kind::poplar ? 1.5 : 2.6);
        for (const House &h : houses_) {
            const double x = t.at.x - h.at.x, z = t.at.z - h.at.z;
            const double out = std::abs(x * h.out.x + z * h.out.z), along = std::abs(x * h.out.z - z * h.out.x);
            if (out < h.depth_m / 2 + 0.75 * t.radius_m && along < h.width_m / 2 + 0.75 * t.radius_m) return;
        }
        for (const Tree &other : trees_) {
            const double x = t.at.x - other.at.x, z = t.at.z - other.at.z;
            if (x * x + z * z < 9) return;
        }
        trees_.push_back(t);
    }

    void on_square()
    {
        const Block &b = plan_.square();
        for (int i = 0; i < 5; ++i)
            for (const double u : {b.u0 + 9, b.u1 - 9}) add(draws_++, u, b.v0 + 36 + 9.5 * i, Tree::Kind::broad);
    }

    // Poplars on both sides of the roads into the country.
    void avenues()
    {
        const double high = plan_.streets_v()[Plan::high_street], south = plan_.streets_u()[Plan::south_street];
        for (int i = 0; i < 12; ++i)
            for (const double side : {-1.0, 1.0}) {
                const double out = 200 + 17.0 * i + (side > 0 ? 7 : 0), beside = side * 8.5;
                if (i < 10) add(draws_++, -out, high + beside, Tree::Kind::poplar);
                if (i > 4) add(draws_++, out + 20, high + beside, Tree::Kind::poplar);
                if (i % 2 == 0) add(draws_++, south + beside, -out, Tree::Kind::broad);
                add(draws_++, south + beside, out, Tree::Kind::poplar);
            }
    }

    void by_stream()
    {
        const double high = plan_.streets_v()[Plan::high_street];
        for (int i = 0; i < 40; ++i) {
            const uint64_t number = draws_++;
            const double v = random_between(seed_, number, Purpose::place_z, -420, 520);
            if (std::abs(v - high) < 14) continue;
            const double away = random_between(seed_, number, Purpose::place_x, 9, 24);
            try_at(number, plan_.stream_u() + (random_unit(seed_, number, Purpose::gap) < 0.5 ? -away : away), v);
        }
    }

    void between_fields()
    {
        for (int i = 0; i < 40; ++i) {
            const uint64_t number = draws_++;
            const double angle = random_between(seed_, number, Purpose::heading, 0, two_pi);
            const double far = random_between(seed_, number, Purpose::radius, 230, 620);
            const double u = far * std::sin(angle), v = far * std::cos(angle);
            if (std::abs(plan_.from_stream(u)) < 12) continue;
            if (std::abs(v - plan_.streets_v()[Plan::high_street]) < 11) continue;
            if (std::abs(u - plan_.streets_u()[Plan::south_street]) < 11) continue;
            try_at(number, u, v);
        }
    }

    const Plan &plan_;
    const std::vector<House> &houses_;
    uint64_t seed_, draws_ = 9000;
    std::vector<Tree> trees_;
};

struct Ring {
    double share, radius;  // of the height and of the radius
};

// One ball of leaves, or a cone: rings from the bottom up, bumpy.
struct Ball {
    Vec3 foot;  // the centre of its lower end
    double height, radius;
    int sides;
    Vec3 crown;  // the centre of the whole crown, from which light falls off
    double crown_height;
};

void ball(Geometry &g, const Ball &b, const std::vector<Ring> &rings, Rgb green, uint64_t seed)
{
    const double leaf = 1 / static_cast<double>(leaves_metres);
    const double wraps = std::max(1.0, std::floor(two_pi * b.radius * leaf + 0.5));
    std::vector<uint32_t> below, row;
    for (size_t k = 0; k < rings.size(); ++k) {
        row.clear();
        for (int side = 0; side <= b.sides; ++side) {
            const uint64_t number = k * 32 + static_cast<uint64_t>(side % b.sides);
            const bool pole = rings[k].radius == 0;
            const double bump = pole ? 1 : random_between(seed, number, Purpose::radius, 0.82, 1.14);
            const double shift = pole ? 0 : random_between(seed, number, Purpose::size, -0.06, 0.06);
            const double angle = two_pi * (side + 0.5 * static_cast<double>(k % 2)) / b.sides;
            const double r = rings[k].radius * b.radius * bump, y = (rings[k].share + shift) * b.height;
            const double x = r * std::sin(angle), z = r * std::cos(angle);
            const Vec3 p = {b.foot.x + static_cast<float>(x), b.foot.y + static_cast<float>(y),
                            b.foot.z + static_cast<float>(z)};
            // Half away from the ball's own centre, half from the crown's.
            const double ny = (rings[k].share - 0.45) * b.radius * 2 + static_cast<double>(p.y - b.crown.y);
            const double nx = x + static_cast<double>(p.x - b.crown.x), nz = z + static_cast<double>(p.z - b.crown.z);
            const double length = std::sqrt(nx * nx + ny * ny + nz * nz) + 1e-9;
            const double high = static_cast<double>(p.y - b.crown.y) / b.crown_height + 0.5;
            const float light = static_cast<float>(0.74 + 0.30 * high + (pole ? 0 : 0.5 * (bump - 1)));
            row.push_back(g.add(
                p, {static_cast<float>(nx / length), static_cast<float>(ny / length), static_cast<float>(nz / length)},
                static_cast<float>(side * wraps / b.sides), static_cast<float>(y * leaf), green * light));
        }
        for (size_t side = 0; k > 0 && side + 1 < row.size(); ++side) {
            if (rings[k - 1].radius > 0) g.triangle(below[side], below[side + 1], row[side + 1]);
            if (rings[k].radius > 0) g.triangle(below[side], row[side + 1], row[side]);
        }
        below = row;
    }
}

void crown(Geometry &g, const Tree &tree, Visibility seen, double foot, double ground, Rgb green, uint64_t seed)
{
    static const std::vector<Ring> rough = {{0, 0.25}, {0.30, 0.98}, {0.72, 0.80}, {1, 0}};
    static const std::vector<Ring> round = {{0, 0}, {0.30, 0.95}, {0.70, 0.86}, {1, 0}};
    static const std::vector<Ring> slim = {{0, 0.3}, {0.25, 1.0}, {0.62, 0.78}, {1, 0}};
    static const std::vector<Ring> cone = {{0, 1.0}, {0.34, 0.62}, {0.35, 0.80}, {1, 0}};
    const double high = tree.height_m - foot;
    const float x = static_cast<float>(tree.at.x), z = static_cast<float>(tree.at.z);
    const Vec3 low = {x, static_cast<float>(ground + foot), z},
               middle = {x, static_cast<float>(ground + foot + 0.5 * high), z};
    if (tree.kind != Tree::Kind::broad || seen == Visibility::far) {
        const std::vector<Ring> &rings = tree.kind == Tree::Kind::poplar ? slim
                                         : tree.kind == Tree::Kind::fir  ? cone
                                                                         : rough;
        ball(g, {low, high, tree.radius_m, 6, middle, high}, rings, green, seed);
        return;
    }
    for (uint64_t i = 0; i < 5; ++i) {  // boughs: four around, one on top
        const double turn = two_pi * (static_cast<double>(i) + random_between(seed, i, Purpose::heading, 0, 0.5)) / 4;
        const double out = i == 4 ? 0 : random_between(seed, i, Purpose::place_x, 0.36, 0.50) * tree.radius_m;
        const double up = i == 4 ? 0.36 : random_between(seed, i, Purpose::place_z, 0.0, 0.22);
        const double size = i == 4 ? 0.72 : random_between(seed, i, Purpose::slab, 0.58, 0.70);
        const Vec3 at = {x + static_cast<float>(out * std::sin(turn)), static_cast<float>(ground + foot + up * high),
                         z + static_cast<float>(out * std::cos(turn))};
        ball(g, {at, 0.64 * high, size * tree.radius_m, 7, middle, high}, round, green, seed + 77 * i);
    }
}

}  // namespace

std::vector<Tree> place_trees(const Plan &plan, const std::vector<House> &houses, uint64_t seed)
{
    return Gardener(plan, houses, seed).plant();
}

void grow_tree(Pieces &pieces, SunShadows &shadows, const Tree &tree, const Terrain &terrain, uint64_t seed)
{
    const double ground = terrain.height(tree.at.x, tree.at.z);
    const uint64_t own = seed ^ (static_cast<uint64_t>(static_cast<int64_t>(tree.at.x * 16)) * 0x9e3779b97f4a7c15u);
    const double foot = (tree.kind == Tree::Kind::broad ? 0.24 : 0.09) * tree.height_m;
    const size_t tone = static_cast<size_t>(random_unit(own, 0, Purpose::tone) * 5);
    const Rgb green = tree.kind == Tree::Kind::broad    ? greens[tone]
                      : tree.kind == Tree::Kind::poplar ? Rgb{0.36f, 0.52f, 0.24f}
                                                        : Rgb{0.24f, 0.40f, 0.24f};
    const float r = static_cast<float>(0.035 * tree.height_m), y = static_cast<float>(ground);
    pieces.on(SurfaceKind::stone)
        .turned(static_cast<float>(tree.at.x), static_cast<float>(tree.at.z),
                {{r, y - 0.03f}, {0.7f * r, y + static_cast<float>(foot + 0.14 * tree.height_m)}}, 4, bark);
    if (tree.kind == Tree::Kind::broad) {
        pieces.from_now(Visibility::near);
        crown(pieces.on(SurfaceKind::leaves), tree, Visibility::near, foot, ground, green, own);
        pieces.from_now(Visibility::far);
    }
    crown(pieces.on(SurfaceKind::leaves), tree, Visibility::far, foot, ground, green, own);
    pieces.finish(Piece::Kind::tree);

    if (std::abs(tree.at.x) + std::abs(tree.at.z) > shaded_m) return;
    std::vector<Vec3> outline;
    for (int side = 0; side < 6; ++side) {
        const double angle = two_pi * side / 6;
        for (const double share : {0.3, 0.7})
            outline.push_back({static_cast<float>(tree.at.x + 0.85 * tree.radius_m * std::sin(angle)),
                               static_cast<float>(ground + foot + share * (tree.height_m - foot)),
                               static_cast<float>(tree.at.z + 0.85 * tree.radius_m * std::cos(angle))});
    }
    shadows.cast(outline, ground);
}

}  // namespace scenes::town
