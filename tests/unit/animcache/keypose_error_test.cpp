// Errors of key-poses against skinning at the exact time (S3 3, 4, 6): in millimetres, and in pixels of a picture 768
// lines high over 60 degrees at the distances that claque/key_poses.h recommends for them.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "animcache/evaluate.h"
#include "animcache/keypose_vertices.h"
#include "animcache/scratch.h"
#include "lib/figures/figure.h"
#include "meshsplit/build.h"

namespace claque::animcache
{

namespace
{

using Positions = std::vector<double>;

class Shown
{
public:
    Shown(const model::Template &tmpl, float rate_hz)
        : tmpl_(tmpl),
          table_(std::pmr::get_default_resource(), tmpl, rate_hz),
          pool_(std::pmr::get_default_resource(), 1)
    {
        const model::Template *all[] = {&tmpl};
        Settings settings;
        settings.key_poses.bands[0].mode = KeyPoseMode::interpolated;
        settings.key_poses.band_count = 1;
        for (const VertexFormat vertex_format : {VertexFormat::floats, VertexFormat::packed}) {
            settings.vertex_format = vertex_format;
            const Sizes sizes = sizes_of({all, 1}, settings);
            pool_.reserve(sizes);
            vertices_.resize(std::max(vertices_.size(), sizes.vertex_floats));
        }
    }

    // `individual`: exactly at that time.
    Positions at(KeyPoseMode mode, uint32_t clip, double time_s, VertexFormat vertex_format = VertexFormat::floats)
    {
        Request request;
        request.tmpl = &tmpl_;
        request.pose.version = 1;
        request.pose.clip = clip;
        request.pose.clip_time_s = time_s;
        if (shows_key_poses(mode)) request.key_pose = table_.select(mode, clip, time_s);
        const Scratch scratch = pool_.slice(0);
        if (mode == KeyPoseMode::interpolated) {
            interpolate(request, vertex_format, scratch, vertices_.data());
        } else {
            if (mode == KeyPoseMode::intermittent) request.pose.clip_time_s = request.key_pose.time_s[0];
            animate(request, scratch, scratch.palette);
            skin(request, scratch.palette, vertex_format, scratch, vertices_.data());
        }
        const draw::Vertices made = vertices_in(vertices_.data(), tmpl_, 0, vertex_format);
        Positions out;
        for (uint32_t v = 0; v < tmpl_.levels[0].vertex_count; ++v)
            for (size_t k = 0; k < 3; ++k)
                out.push_back(vertex_format == VertexFormat::floats
                                  ? double(made.positions[3 * v + k])
                                  : double(made.offset[k]) + double(made.step) * made.short_positions[4 * v + k]);
        return out;
    }

private:
    const model::Template &tmpl_;
    KeyPoseTable table_;
    ScratchPool pool_;
    std::vector<float> vertices_;
};

double farthest(const Positions &a, const Positions &b)
{
    double most = 0;
    for (size_t i = 0; i < a.size(); i += 3)
        most = std::max(most, std::hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
    return most;
}

double squares(const Positions &a, const Positions &b)
{
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum / (double(a.size()) / 3);
}

struct Error {
    double most = 0, mean = 0;  // metres: the worst vertex, and the root mean square
};

const model::Template &person(size_t which)
{
    static std::vector<std::unique_ptr<model::Template>> made;
    while (made.size() <= which) {
        made.push_back(std::make_unique<model::Template>(std::pmr::get_default_resource()));
        meshsplit::BuildOptions options;
        options.max_texture_px = 64;
        meshsplit::build(figures::people()[made.size() - 1].make(), options, *made.back());
    }
    return *made[which];
}

// Times spread evenly over the intervals between key-poses, by the golden section.
Error error_of(KeyPoseMode mode, size_t which, float rate_hz, int moments)
{
    const model::Template &tmpl = person(which);
    Shown shown(tmpl, rate_hz);
    Error error;
    double sum = 0, count = 0;
    for (uint32_t clip = 0; clip < tmpl.rig.clips.size(); ++clip)
        for (int k = 0; k < moments; ++k) {
            const model::Clip &of = tmpl.rig.clips[clip];
            const double share = std::fmod(0.5 + k * 0.6180339887498949, 1.0);
            const double time_s = double(of.start_s) + double(of.duration_s) * share;
            const Positions exact = shown.at(KeyPoseMode::individual, clip, time_s),
                            made = shown.at(mode, clip, time_s);
            error.most = std::max(error.most, farthest(exact, made));
            sum += squares(exact, made), count += 1;
        }
    error.mean = std::sqrt(sum / count);
    return error;
}

double pixels(double metres, double distance_m) { return metres / distance_m * 384 * std::sqrt(3.0); }

}  // namespace

// The figures in claque/key_poses.h for the built-in people at 15 key-poses a second.
TEST(KeyPoseError, OfTheBuiltInPeopleIsWithinWhatTheHeaderStates)
{
    const struct {
        KeyPoseMode mode;
        double most_m, mean_m, from_m;  // from_m: distance at which the worst vertex is off by a pixel
    } stated[] = {{KeyPoseMode::intermittent, 0.120, 0.009, 80}, {KeyPoseMode::interpolated, 0.030, 0.002, 20}};
    for (size_t which = 0; which < figures::people().size(); ++which)
        for (const auto &s : stated) {
            const Error error = error_of(s.mode, which, 15, 48);
            std::printf("%-10s %-12s at most %.1f mm, mean %.2f mm; from %.0f m at most %.2f, mean %.3f pixels\n",
                        figures::people()[which].name,
                        s.mode == KeyPoseMode::intermittent ? "intermittent" : "interpolated", 1000 * error.most,
                        1000 * error.mean, s.from_m, pixels(error.most, s.from_m), pixels(error.mean, s.from_m));
            EXPECT_LE(error.most, s.most_m);
            EXPECT_LE(error.mean, s.mean_m);
            EXPECT_LE(pixels(error.most, s.from_m), 1.0);
            EXPECT_GT(error.most, s.most_m / 4) << "a bound that says something";
        }
}

// The nearest key-pose is at most half an interval away, so a vertex is off by at most its top speed times that.
TEST(KeyPoseError, OfTheNearestOneIsNoMoreThanTheFastestVertexMovesInHalfAnInterval)
{
    const model::Template &tmpl = person(0);
    for (const float rate_hz : {7.5f, 15.0f, 30.0f}) {
        Shown shown(tmpl, rate_hz);
        for (uint32_t clip = 0; clip < 4; ++clip) {
            const model::Clip &of = tmpl.rig.clips[clip];
            const double step_s = 1 / 240.0;
            double fastest = 0, worst = 0;
            Positions before = shown.at(KeyPoseMode::individual, clip, double(of.start_s));
            for (double t = step_s; t <= double(of.duration_s); t += step_s) {
                const Positions now = shown.at(KeyPoseMode::individual, clip, double(of.start_s) + t);
                fastest = std::max(fastest, farthest(now, before) / step_s);
                worst =
                    std::max(worst, farthest(now, shown.at(KeyPoseMode::intermittent, clip, double(of.start_s) + t)));
                before = now;
            }
            const double intervals = std::max(1.0, std::round(double(of.duration_s) * double(rate_hz)));
            EXPECT_LE(worst, fastest * double(of.duration_s) / intervals / 2 + 1e-5)
                << "clip " << clip << " at " << rate_hz;
            EXPECT_GT(worst, 0.0);
        }
    }
}

TEST(KeyPoseError, HalvesForTheNearestAndQuartersForTwoBlendedWhereTheRateDoubles)
{
    const Error near_slow = error_of(KeyPoseMode::intermittent, 0, 15, 60),
                near_fast = error_of(KeyPoseMode::intermittent, 0, 30, 60);
    EXPECT_NEAR(near_slow.mean / near_fast.mean, 2, 0.3);
    const Error slow = error_of(KeyPoseMode::interpolated, 0, 30, 60),
                fast = error_of(KeyPoseMode::interpolated, 0, 60, 60);
    EXPECT_NEAR(slow.most / fast.most, 4, 1.5);
}

// Two key-poses are packed, then blended, then rounded: half a step for each of the first two, weighted, and half a
// step more.
TEST(KeyPoseError, PackedKeyPosesAddAStepAlongEachAxisAtMost)
{
    const model::Template &tmpl = person(0);
    Shown shown(tmpl, 15);
    const double step = double(tmpl.sklsroot.radius) / 32767;
    double most[2] = {0, 0};
    for (uint32_t clip = 0; clip < tmpl.rig.clips.size(); ++clip)
        for (int k = 0; k < 20; ++k) {
            const double time_s =
                double(tmpl.rig.clips[clip].start_s) + double(tmpl.rig.clips[clip].duration_s) * k / 20.3;
            for (int way = 0; way < 2; ++way) {
                const KeyPoseMode mode = way == 0 ? KeyPoseMode::intermittent : KeyPoseMode::interpolated;
                most[way] = std::max(most[way], farthest(shown.at(mode, clip, time_s),
                                                         shown.at(mode, clip, time_s, VertexFormat::packed)));
            }
        }
    std::printf("packed: a nearest key-pose %.4f mm, two blended %.4f mm off\n", 1000 * most[0], 1000 * most[1]);
    EXPECT_LE(most[0], 0.5 * std::sqrt(3.0) * step * 1.01);
    EXPECT_LE(most[1], std::sqrt(3.0) * step * 1.01);
    EXPECT_GT(most[1], 0.2 * step);
}

}  // namespace claque::animcache
