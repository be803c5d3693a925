// A crowd of the bodies of body.h, and its updates.
#pragma once

#include <memory>
#include <random>

#include "lib/crowd/edits.h"
#include "lib/frame/frame.h"
#include "tests/bench/body.h"

namespace claque::bench
{

struct Scene {
    Scene(uint32_t count, double field_m, const frame::Settings &settings)
        : tmpl(make_body(2)),
          crowd(std::pmr::get_default_resource()),
          frame(std::pmr::get_default_resource(), settings),
          view(std::pmr::get_default_resource())
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> real(-field_m, field_m);
        for (uint32_t i = 0; i < count; ++i) {
            crowd::Transform place;
            place.position = glm::dvec3(real(random), 0, real(random));
            crowd::Play play;
            play.clip = 0;
            play.phase_s = float(i) * 0.137f;
            crowd::create(crowd, *tmpl, place, play, i);
        }
    }
    void update(double time_s, const base::Jobs &jobs = base::Jobs())
    {
        frame::View *views[1] = {&view};
        frame::update(crowd, frame, {views, 1}, time_s, jobs);
    }
    std::unique_ptr<model::Template> tmpl;
    crowd::Crowd crowd;
    frame::Frame frame;
    frame::View view;
};

// All of a field of 100 m by 100 m is in view, and every actor is due in every update.
struct AllDue : Scene {
    AllDue(uint32_t count, animcache::VertexFormat vertex_format) : Scene(count, 50, settings(vertex_format))
    {
        view.camera = frame::look_at({0, 10, 120}, {0, 0, 0}, {0, 1, 0}, 1.2f, 1.5f, 0.1f, 1000);
        update(0);
    }

private:
    static frame::Settings settings(animcache::VertexFormat vertex_format)
    {
        frame::Settings out;
        out.caches.period = {0, 0, 1, 2};
        out.caches.vertex_format = vertex_format;
        return out;
    }
};

}  // namespace claque::bench
