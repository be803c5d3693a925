#include "samples/scenes/town/plan.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace scenes::town
{
namespace
{

constexpr int outside = 100;  // groups from here on are fields

double smooth(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Point unit(double x, double z)
{
    const double length = std::sqrt(x * x + z * z);
    return {x / length, z / length};
}

// Adds strips up to `to`, none longer than `longest`.
void fill(std::vector<Strip> &strips, double from, double to, double longest, Strip::Use use, int group)
{
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
    for (int part = 0; part < parts; ++part)
        strips.push_back({use, from + (to - from) * part / parts, from + (to - from) * (part + 1) / parts, group});
}

// Fields grow with the distance.
constexpr double country[] = {0, 24, 60, 104, 150, 205, 270, 350, 450, 570, 720, 900, 1120, 1380, 1680, 2020};

}  // namespace

Plan::Plan(uint64_t seed) : seed_(seed)
{
    for (uint64_t i = 0; i < 6; ++i) phases_[i] = random_between(seed, i, Purpose::gradient, 0, two_pi);
    lay_streets();
    lay_columns();
    lay_rows();
    lay_blocks();
}

void Plan::lay_streets()
{
    constexpr double u[] = {-140, -50, 46, 134}, v[] = {-128, -42, 46, 132};
    for (uint64_t i = 0; i < streets_each_way; ++i) {
        street_u_.push_back(u[i] + random_between(seed_, i, Purpose::lane, -5, 5));
        street_v_.push_back(v[i] + random_between(seed_, 16 + i, Purpose::lane, -5, 5));
    }
    for (int i = 0; i < streets_each_way; ++i) {
        const bool on = i == south_street, off = i == high_street;  // into the country
        streets_.push_back({Street::Direction::south, street_u_[static_cast<size_t>(i)], half_u(i),
                            on ? -reach_m : street_v_.front(), on ? reach_m : street_v_.back()});
        streets_.push_back({Street::Direction::east, street_v_[static_cast<size_t>(i)], half_v(i),
                            off ? -reach_m : street_u_.front(), off ? reach_m : street_u_.back()});
    }
}

void Plan::lay_columns()
{
    const double west = street_u_.front() - half_u(0) - yard_m, east = street_u_.back() + half_u(0) + yard_m;
    const size_t fields = sizeof country / sizeof *country;
    for (size_t i = fields; i-- > 1;)
        u_.push_back({Strip::Use::open, west - country[i], west - country[i - 1], outside + static_cast<int>(i)});
    u_.front().first = -reach_m;
    double from = west;
    for (int i = 0; i < streets_each_way; ++i) {
        const double at = street_u_[static_cast<size_t>(i)], half = half_u(i);
        fill(u_, from, at - half, 24, Strip::Use::open, i);
        u_.push_back({Strip::Use::street, at - half, at + half, i});
        from = at + half;
    }
    fill(u_, from, east, 24, Strip::Use::open, streets_each_way);
    stream_u_ = east + 62;
    const double water0 = stream_u_ - water_half_m, water1 = stream_u_ + water_half_m;
    fill(u_, east, water0 - bank_m, 20, Strip::Use::open, outside + 40);
    u_.push_back({Strip::Use::bank, water0 - bank_m, water0, outside + 41});
    u_.push_back({Strip::Use::water, water0, water1, outside + 42});
    u_.push_back({Strip::Use::bank, water1, water1 + bank_m, outside + 43});
    for (size_t i = 1; i < fields; ++i) {
        const double last = water1 + bank_m + country[i];
        u_.push_back({Strip::Use::open, u_.back().last, last, outside + 50 + static_cast<int>(i)});
    }
    u_.back().last = reach_m;
}

void Plan::lay_rows()
{
    const double north = street_v_.front() - half_v(0) - yard_m, south = street_v_.back() + half_v(0) + yard_m;
    const size_t fields = sizeof country / sizeof *country;
    for (size_t i = fields; i-- > 1;)
        v_.push_back({Strip::Use::open, north - country[i], north - country[i - 1], outside + static_cast<int>(i)});
    v_.front().first = -reach_m;
    double from = north;
    for (int i = 0; i < streets_each_way; ++i) {
        // A narrow strip on either side of the high street: where it crosses the stream the land falls off there.
        const double verge = i == high_street ? 0.8 : 0.0;
        const double at = street_v_[static_cast<size_t>(i)], half = half_v(i);
        fill(v_, from, at - half - verge, 24, Strip::Use::open, i);
        if (verge > 0) v_.push_back({Strip::Use::bank, at - half - verge, at - half, i});
        v_.push_back({Strip::Use::street, at - half, at + half, i});
        if (verge > 0) v_.push_back({Strip::Use::bank, at + half, at + half + verge, i + 1});
        from = at + half + verge;
    }
    fill(v_, from, south, 24, Strip::Use::open, streets_each_way);
    for (size_t i = 1; i < fields; ++i)
        v_.push_back(
            {Strip::Use::open, south + country[i - 1], south + country[i], outside + 50 + static_cast<int>(i)});
    v_.back().last = reach_m;
}

void Plan::lay_blocks()
{
    for (int i = 0; i <= streets_each_way; ++i)
        for (int k = 0; k <= streets_each_way; ++k) {
            const auto side = [](const std::vector<double> &at, int n, double half(int), double &first, double &last) {
                const size_t s = static_cast<size_t>(n);
                first = n == 0 ? at.front() - half(0) - yard_m : at[s - 1] + half(n - 1);
                last = n == streets_each_way ? at.back() + half(0) + yard_m : at[s] - half(n);
            };
            Block b = {};
            side(street_u_, i, half_u, b.u0, b.u1);
            side(street_v_, k, half_v, b.v0, b.v1);
            const bool rim = i == 0 || k == 0 || i == streets_each_way || k == streets_each_way;
            b.kind = rim                ? Block::Kind::yards
                     : i == 2 && k == 2 ? Block::Kind::square
                     : i == 3 && k == 3 ? Block::Kind::park
                                        : Block::Kind::houses;
            blocks_.push_back(b);
        }
}

const Block &Plan::square() const { return blocks_[2 * (streets_each_way + 1) + 2]; }

Point Plan::at(double u, double v) const
{
    const double *p = phases_;
    double x = u + 8 * std::sin(v / 92 + p[0]) + 26 * std::sin(v / 430 + p[1]);
    const double z = v + 7 * std::sin(u / 104 + p[2]) + 24 * std::sin(u / 470 + p[3]);
    const double d = from_stream(u), far = std::abs(d);
    // The stream winds more than the streets do, and widens into a lake in the south.
    x += 16 * std::sin(v / 62 + p[4]) * smooth(1 - far / 110);
    const double lake = 55 * smooth(1 - std::abs(v - 330) / 150), edge = water_half_m;
    const double push = far < edge ? far / edge : smooth(1 - (far - edge) / 260);
    x += lake * push * (d < 0 ? -1 : 1);
    return {x, z};
}

Point Plan::east(double u, double v) const
{
    const Point a = at(u - 0.5, v), b = at(u + 0.5, v);
    return unit(b.x - a.x, b.z - a.z);
}

Point Plan::south(double u, double v) const
{
    const Point a = at(u, v - 0.5), b = at(u, v + 0.5);
    return unit(b.x - a.x, b.z - a.z);
}

std::vector<double> Plan::lines_u() const
{
    std::vector<double> lines = {u_.front().first};
    for (const Strip &s : u_) lines.push_back(s.last);
    return lines;
}

std::vector<double> Plan::lines_v() const
{
    std::vector<double> lines = {v_.front().first};
    for (const Strip &s : v_) lines.push_back(s.last);
    return lines;
}

bool Plan::in_town(const Strip &strip) const { return strip.group <= streets_each_way; }

Cover Plan::cover(size_t column, size_t row) const
{
    const Strip &u = u_[column], &v = v_[row];
    const bool along_v = u.use == Strip::Use::street, along_u = v.use == Strip::Use::street;
    const bool within_u = u.middle() > street_u_.front() - 5 && u.middle() < street_u_.back() + 5;
    const bool within_v = v.middle() > street_v_.front() - 5 && v.middle() < street_v_.back() + 5;
    if (along_u && along_v) return Cover::crossing;
    if (along_u && within_u) return Cover::street;
    if (along_v && within_v) return Cover::street;
    if ((along_u && v.group == high_street) || (along_v && u.group == south_street)) return Cover::road;
    if (u.use == Strip::Use::water) return v.use == Strip::Use::bank ? Cover::embankment : Cover::water;
    if (u.use == Strip::Use::bank) return Cover::bank;
    if (!in_town(u) || !in_town(v)) {
        const double far = std::max(std::abs(u.middle()), std::abs(v.middle()));
        const double share = random_unit(seed_, parcel(column, row), Purpose::tree);
        return share < (far > 1300 ? 0.46 : far > 420 ? 0.22 : 0.06) ? Cover::wood : Cover::field;
    }
    for (const Block &b : blocks_)
        if (u.middle() > b.u0 && u.middle() < b.u1 && v.middle() > b.v0 && v.middle() < b.v1)
            return b.kind == Block::Kind::square ? Cover::square
                   : b.kind == Block::Kind::park ? Cover::park
                                                 : Cover::garden;
    return Cover::garden;
}

uint64_t Plan::parcel(size_t column, size_t row) const
{
    return static_cast<uint64_t>(u_[column].group) * 1024 + static_cast<uint64_t>(v_[row].group);
}

}  // namespace scenes::town
