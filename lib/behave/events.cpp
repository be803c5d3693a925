#include "lib/behave/events.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/base/error.h"
#include "lib/behave/mechanisms.h"
#include "lib/crowd/gait.h"

namespace claque::behave
{

using crowd::Source;

namespace
{

// The interval in which something is played: after first_s, up to and including last_s.
struct Window {
    double first_s, last_s;
    Window within(double first, double last) const { return {std::max(first_s, first), std::min(last_s, last)}; }
    bool holds(double t) const { return t > first_s && t <= last_s; }
};

class Finder
{
public:
    Finder(const crowd::Crowd &crowd, model::Array<Event> &out) : crowd_(crowd), out_(out) {}

    void find(uint32_t row, Window window)
    {
        row_ = row;
        rig_ = &crowd_.template_of(row).rig;
        if (const crowd::MechanismAttachment *attachment = idle_of(row)) {
            idle(*attachment, window);
        } else {
            const crowd::LayerState *layer_state = crowd_.layers().of(row);
            Source plain;
            plain.play = crowd_.play_of(row);
            const crowd::Follow *follow = crowd_.follows().of(row);
            if (layer_state) base(*layer_state, window);
            else if (follow && follow->walks) walk(*follow, window);
            else source(plain, window, 0);
        }
        if (const crowd::LayerState *layer_state = crowd_.layers().of(row))
            for (uint32_t k = 0; k < layer_state->layer_count; ++k) layer(layer_state->layers[k], window);
    }

private:
    void put(double time_s, EventKind kind, uint32_t clip, uint32_t layer)
    {
        if (out_.size() == max_events)
            base::fail(CLQ_LIMIT, "more than %zu events in one interval: ask for a shorter one", max_events);
        Event event;
        event.time_s = time_s, event.row = row_, event.kind = kind, event.clip = clip, event.layer = layer;
        out_.push_back(event);
    }

    // Calls `each` (time, number of passes of 0 by then) at the times at which a clock passes `share` of a loop. The
    // clock stands at `phase` loops at start_s and makes `pace` loops per second.
    template <class Each>
    static void passes(double start_s, double phase, double pace, double share, Window window, const Each &each)
    {
        if (!(pace != 0) || !(window.first_s < window.last_s)) return;
        const auto rounds = [&](double t) { return phase + pace * (t - start_s) - share; };
        const double low = std::min(rounds(window.first_s), rounds(window.last_s));
        const double high = std::max(rounds(window.first_s), rounds(window.last_s));
        // One more at each end, because rounding is decided by the time alone.
        const double count = std::floor(high) - std::ceil(low) + 3;
        if (!(count < 2.0 * static_cast<double>(max_events)))
            base::fail(CLQ_LIMIT, "more than %zu events in one interval: ask for a shorter one", max_events);
        // Counts with an integer: beyond 2^53 adding 1 to k would not change it.
        for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
            const double k = std::ceil(low) - 1 + i;
            const double t = start_s + (k + share - phase) / pace;
            if (window.holds(t)) each(t, pace > 0 ? k - std::floor(phase) : std::ceil(phase) - k);
        }
    }

    // A loop ends where the next begins: at the clip's end when played forwards, at its start when played backwards.
    void clip(const crowd::Play &play, Window window, uint32_t layer)
    {
        if (play.clip == model::none) return;
        const model::Clip &clip = rig_->clips[play.clip];
        const double length = static_cast<double>(clip.duration_s);
        if (!(length > 0)) return;
        const double phase = static_cast<double>(play.phase_s) / length,
                     pace = static_cast<double>(play.speed) / length;
        passes(play.start_s, phase, pace, 0, window, [&](double t, double rounds) {
            put(t, EventKind::clip_end, play.clip, layer);
            out_.back().round = static_cast<uint64_t>(rounds > 0 ? rounds : 0);
        });
        each_marker(play.clip, [&](uint32_t marker, double time_s) {
            const double share = (time_s - static_cast<double>(clip.start_s)) / length;
            passes(play.start_s, phase, pace, share, window, [&](double t, double) {
                put(t, EventKind::marker, play.clip, layer);
                out_.back().marker = marker;
            });
        });
    }

    template <class Each>
    void each_marker(uint32_t clip, const Each &each) const
    {
        for (uint32_t i = 0; i < rig_->markers.size(); ++i)
            if (rig_->markers[i].clip == clip) each(i, static_cast<double>(rig_->markers[i].time_s));
    }

    // The common phase of a gait is linear except while its share changes; there it is found by bisection.
    void gait(const Source &source, Window window)
    {
        const crowd::Gait &gait = crowd_.layers().gait(source.gait);
        const auto rounds = [&](double t) { return rounds_at(gait, source, t); };
        const auto all = [&](double share, const auto &each) {
            if (!(window.first_s < window.last_s)) return;
            const double a = rounds(window.first_s), b = rounds(window.last_s);
            if (!(std::fabs(b - a) < 2.0 * static_cast<double>(max_events)))
                base::fail(CLQ_LIMIT, "more than %zu events in one interval: ask for a shorter one", max_events);
            const bool back = b < a;
            const uint32_t count = static_cast<uint32_t>(std::fabs(b - a)) + 4;
            for (uint32_t i = 0; i < count; ++i) {
                const double k = std::ceil(std::min(a, b) - share) - 1 + i;
                double low = window.first_s, high = window.last_s;
                const auto passed = [&](double t) { return back ? rounds(t) <= k + share : rounds(t) >= k + share; };
                if (passed(low) || !passed(high)) continue;
                for (int step = 0; step < 100 && low < high; ++step) {
                    const double middle = 0.5 * (low + high);
                    if (!(middle > low && middle < high)) break;
                    (passed(middle) ? high : low) = middle;
                }
                // A change of the share also extends backwards in time, so the start is known only up to rounding.
                const double begun = rounds(source.play.start_s) - share;
                each(high, back ? std::ceil(begun - 1e-9) - k : k - std::floor(begun + 1e-9));
            }
        };
        const double begins = static_cast<double>(rig_->clips[gait.clip_a].start_s);
        all(share_of_a(gait, begins), [&](double t, double round) {
            if (!(round > 0)) return;
            put(t, EventKind::clip_end, gait.clip_a, 0);
            out_.back().round = static_cast<uint64_t>(round);
        });
        each_marker(gait.clip_a, [&](uint32_t marker, double time_s) {
            all(share_of_a(gait, time_s), [&](double t, double) {
                put(t, EventKind::marker, gait.clip_a, 0);
                out_.back().marker = marker;
            });
        });
    }

    void source(const Source &source, Window window, uint32_t layer)
    {
        const Window played = window.within(source.play.start_s, window.last_s);
        if (source.gait == model::none) clip(source.play, played, layer);
        else if (source.gait != crowd::track_gait) gait(source, played);
        else if (const crowd::Follow *follow = crowd_.follows().of(row_)) walk(*follow, window);
    }

    // Feet that come down, and the moments in which a person begins to stand.
    void walk(const crowd::Follow &follow, Window window)
    {
        walk(*follow.track, follow, window);
        double end_s = follow.track->start_s;
        for (const track::Track *piece : follow.earlier) {
            if (!piece) break;
            walk(*piece, follow, window.within(window.first_s, follow.start_s + end_s));
            end_s = piece->start_s;
        }
    }

    void walk(const track::Track &track, const crowd::Follow &follow, Window window)
    {
        constexpr double rounding_s = 1e-6;  // the window decides
        const double clock_s = follow.start_s + track.start_s;
        const double first_s = window.first_s - clock_s - rounding_s, last_s = window.last_s - clock_s + rounding_s;
        track::for_steps(track, first_s, last_s, [&](double gone_s, int foot) {
            if (!window.holds(clock_s + gone_s)) return;
            put(clock_s + gone_s, EventKind::step, track.locomotion->clips.walk, 0);
            out_.back().marker = static_cast<uint32_t>(foot);
        });
        track::for_stands(track, first_s, last_s, [&](double gone_s, uint32_t idle) {
            if (!window.holds(clock_s + gone_s)) return;
            const track::LocomotionClips &clips = track.locomotion->clips;
            put(clock_s + gone_s, EventKind::stand, clips.idle_count > 0 ? clips.idles[idle] : model::none, 0);
        });
    }

    void base(const crowd::LayerState &layer_state, Window window)
    {
        double first = -crowd::never_s;
        for (uint32_t k = 0; k <= layer_state.fade_count; ++k) {
            const bool last = k == layer_state.fade_count;
            const double next = last ? crowd::never_s : layer_state.fades[k].at_s;
            source(last ? layer_state.now : layer_state.fades[k].from, window.within(first, next), 0);
            first = next;
            if (last) break;
            const double end = next + static_cast<double>(layer_state.fades[k].length_s);
            const Source &to = k + 1 < layer_state.fade_count ? layer_state.fades[k + 1].from : layer_state.now;
            if (window.holds(end)) put(end, EventKind::fade_end, to.play.clip, 0);
        }
    }

    void layer(const crowd::Layer &layer, Window window)
    {
        clip(layer.play, window.within(layer.start_s, layer.end_s), layer.layer_id);
        if (window.holds(layer.end_s)) put(layer.end_s, EventKind::layer_end, layer.play.clip, layer.layer_id);
    }

    const crowd::MechanismAttachment *idle_of(uint32_t row) const
    {
        const crowd::Behaviours &behaviours = crowd_.behaviours();
        const crowd::MechanismAttachment *last = nullptr;
        for (uint32_t i = behaviours.first_attachment(row); i != model::none; i = behaviours.attachment_at(i).next)
            if (std::holds_alternative<crowd::Idle>(behaviours.mechanism(behaviours.attachment_at(i).mechanism).kind))
                last = &behaviours.attachment_at(i);
        return last;
    }

    // One slot after the other, each with its random clip.
    void idle(const crowd::MechanismAttachment &attachment, Window window)
    {
        const crowd::Idle &idle = std::get<crowd::Idle>(crowd_.behaviours().mechanism(attachment.mechanism).kind);
        const double length = static_cast<double>(idle.slot_s);
        if (!((window.last_s - window.first_s) / length < static_cast<double>(max_events)))
            base::fail(CLQ_LIMIT, "more than %zu events in one interval: ask for a shorter one", max_events);
        crowd::Play play = idle_plays(idle, crowd_, row_, attachment, window.first_s).now;
        while (play.start_s < window.last_s) {
            const crowd::Play next = idle_plays(idle, crowd_, row_, attachment, play.start_s + 1.5 * length).now;
            clip(play, window.within(play.start_s, next.start_s), 0);
            if (!(next.start_s > play.start_s)) break;  // a clock so large that such times do not exist
            play = next;
        }
    }

    const crowd::Crowd &crowd_;
    model::Array<Event> &out_;
    uint32_t row_ = 0;
    const model::Rig *rig_ = nullptr;
};

}  // namespace

void find_events(const crowd::Crowd &crowd, double from_s, double to_s, model::Array<Event> &out)
{
    out.clear();
    if (!(from_s < to_s)) return;
    Finder finder(crowd, out);
    for (const uint32_t row : crowd.watched()) finder.find(row, {from_s, to_s});
    const auto key = [](const Event &e) {
        return std::make_tuple(e.time_s, e.row, e.kind, e.layer, e.clip, e.marker, e.round);
    };
    std::sort(out.begin(), out.end(), [&](const Event &a, const Event &b) { return key(a) < key(b); });
}

}  // namespace claque::behave
