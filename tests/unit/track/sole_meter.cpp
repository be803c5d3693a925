#include "tests/unit/track/sole_meter.h"

#include <cmath>

#include "lib/pose/pose.h"

namespace claque::test
{

namespace
{

constexpr double sole_m = 0.035, sample_s = 0.01;

// Calls each(vertex, palette entry, weight) for the finest level.
template <class Each>
void for_influences(const model::Template &tmpl, const Each &each)
{
    const model::Level &level = tmpl.levels[0];
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i)
            for (uint32_t k = 0; k < run.influences; ++k) {
                const uint32_t at = run.first_influence + i * run.influences + k;
                each(run.first + i, uint32_t(level.joints[at]), double(level.weights[at]));
            }
}

// All vertices of the finest level in model space.
std::vector<glm::dvec3> skinned(const model::Template &tmpl, const math::Affine *palette)
{
    const model::Level &level = tmpl.levels[0];
    std::vector<glm::dvec3> out(level.positions.size() / 3, glm::dvec3(0));
    for_influences(tmpl, [&](uint32_t v, uint32_t entry, double weight) {
        const float *p = level.positions.data() + 3 * size_t(v);
        out[v] += weight * glm::dvec3(math::transform_point(palette[entry], glm::vec3(p[0], p[1], p[2])));
    });
    return out;
}

bool is_below(const model::Rig &rig, uint32_t node, uint32_t above)
{
    while (node != model::none && node != above) node = rig.parents[node];
    return node == above;
}

}  // namespace

SoleMeter::SoleMeter(const track::Locomotion &locomotion, double scale) : locomotion_(&locomotion)
{
    const model::Template &tmpl = *locomotion.tmpl;
    pose::Workspace work(tmpl.rig, &tmpl.motion);
    work.pose(model::none, 0);
    const std::vector<glm::dvec3> rest = skinned(tmpl, work.job().palette.data);
    for (int f = 0; f < 2; ++f) {
        std::vector<double> weights(rest.size(), 0);
        for_influences(tmpl, [&](uint32_t v, uint32_t entry, double weight) {
            if (is_below(tmpl.rig, tmpl.rig.palette[entry].node, locomotion.clips.legs[f][2])) weights[v] += weight;
        });
        double low = HUGE_VAL, back = HUGE_VAL, front = -HUGE_VAL;
        const auto is_sole = [&](uint32_t v) { return weights[v] > 0.5 && (rest[v].y - low) * scale < sole_m; };
        for (uint32_t v = 0; v < rest.size(); ++v)
            if (weights[v] > 0.5) low = std::min(low, rest[v].y);
        for (uint32_t v = 0; v < rest.size(); ++v)
            if (is_sole(v)) back = std::min(back, rest[v].z), front = std::max(front, rest[v].z);
        for (uint32_t v = 0; v < rest.size(); ++v) {
            if (!is_sole(v)) continue;
            const double along = (rest[v].z - back) / (front - back);
            soles_[f].vertices.push_back(v);
            soles_[f].parts.push_back(along < 0.3    ? Part::heel
                                      : along < 0.55 ? Part::waist
                                      : along < 0.8  ? Part::ball
                                                     : Part::toes);
        }
    }
}

Contacts SoleMeter::watch(const track::Track &track, const Ground &ground, bool held) const
{
    const auto shown = [&](double) -> const track::Track & { return track; };
    return watch(shown, track.start_s, track::end_of(track), ground, held);
}

Contacts SoleMeter::watch(const Shown &shown, double start_s, double end_s, const Ground &ground, bool held) const
{
    const model::Template &tmpl = *locomotion_->tmpl;
    pose::Workspace work(tmpl.rig, &tmpl.motion);
    std::vector<Soleprint> prints[2];
    const model::Level &level = tmpl.levels[0];
    struct Pull {
        uint32_t entry;
        double weight;
    };
    std::vector<std::vector<Pull>> pulls(level.positions.size() / 3);
    for_influences(tmpl, [&](uint32_t v, uint32_t entry, double weight) { pulls[v].push_back({entry, weight}); });
    for (double time_s = start_s; time_s <= end_s; time_s += sample_s) {
        const track::Track &track = shown(time_s);
        const track::State state = track::state_at(track, time_s);
        pose::Layer layers[3];
        pose::PoseJob job = work.job();
        job.layers = {layers,
                      track::layers_of(*locomotion_, state.gait, state.turn, state.phase, state.idle, time_s, layers)};
        const pose::FootTarget feet[] = {track::foot_at(track, state, 0, time_s),
                                         track::foot_at(track, state, 1, time_s)};
        if (held) job.feet = {feet, 2};
        job.run();
        const double c = std::cos(state.heading_rad), s = std::sin(state.heading_rad);
        const glm::dvec3 body = state.position * track.metres_per_unit;
        for (int f = 0; f < 2; ++f) {
            Soleprint print;
            print.time_s = time_s, print.body = {body.x, body.z};
            for (const uint32_t v : soles_[f].vertices) {
                const float *at = level.positions.data() + 3 * size_t(v);
                glm::dvec3 p(0);
                for (const Pull &pull : pulls[v])
                    p += pull.weight *
                         glm::dvec3(math::transform_point(job.palette[pull.entry], glm::vec3(at[0], at[1], at[2])));
                p *= track.scale;
                p = body + glm::dvec3(p.x * c + p.z * s, p.y, -p.x * s + p.z * c);
                p.y -= ground ? ground(p.x, p.z) : body.y;
                print.points.push_back(p);
            }
            prints[f].push_back(std::move(print));
        }
    }
    Contacts out = contacts_of(prints[0], soles_[0].parts);
    out.add(contacts_of(prints[1], soles_[1].parts));
    return out;
}

}  // namespace claque::test
