// Levels of a split template in updates of a crowd: at every distance the vertices of its level are shown.
#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "lib/frame/frame.h"
#include "posed.h"

namespace claque::test
{

namespace
{

// A body that loses its fingers and its hand, a hat that is visible from 40 m on, nothing from 90 m to 120 m.
Puppet far_going()
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body", 0, 90);
    m.hang(m.spine, "hat", 40, 90);
    m.hang(m.root, "sign", 120);
    m.swing({m.spine, m.arm, m.hand, m.finger});
    m.stop(m.finger, 20);
    m.stop(m.hand, 40);
    return m;
}

class Crowd
{
public:
    Crowd(const model::Template &tmpl, const frame::Settings &settings)
        : crowd_(std::pmr::get_default_resource(), 1), frame_(std::pmr::get_default_resource(), settings)
    {
        crowd::Play play;
        play.clip = 0;
        crowd::create(crowd_, tmpl, crowd::Transform(), play, 1);
        view_.height_px = 0;  // levels by distance alone
    }
    const draw::DrawList &at(float distance, double time_s)
    {
        const glm::dvec3 eye(0, 0, double(distance));
        view_.camera = frame::look_at(eye, glm::dvec3(0), glm::vec3(0, 1, 0), 1.5f, 1.0f, 0.1f, 500);
        frame::View *views[] = {&view_};
        const base::Status status = frame::update(crowd_, frame_, {views, 1}, time_s, base::Jobs());
        EXPECT_TRUE(status.ok()) << status.text;
        return view_.list;
    }

private:
    crowd::Crowd crowd_;
    frame::Frame frame_;
    frame::View view_{std::pmr::get_default_resource()};
};

}  // namespace

TEST(Proxies, EveryLevelShowsItsOwnVerticesAndAnEmptyOneNone)
{
    const auto tmpl = built(far_going());
    ASSERT_EQ(tmpl->levels.size(), 5u);
    for (const frame::Cull cull : {frame::Cull::actor, frame::Cull::traditional}) {
        frame::Settings settings;
        settings.cull = cull;
        Crowd crowd(*tmpl, settings);
        double time = 0;
        for (const float distance : {10.0f, 19.9f, 20.1f, 39.0f, 41.0f, 89.0f, 91.0f, 119.0f, 121.0f, 15.0f, 95.0f}) {
            const draw::DrawList &list = crowd.at(distance, time += 10);
            uint32_t level = 0;
            while (level + 1 < 5 && tmpl->levels[level + 1].switch_distance_m <= distance) ++level;
            size_t shown = 0;
            for (const draw::Item &item : list.items) {
                EXPECT_EQ(item.level, level) << distance;
                shown += item.tmpl->levels[item.level].vertex_count;
                const draw::Vertices &vertices = item.vertices;
                for (uint32_t i = 0; i < 3 * tmpl->levels[item.level].vertex_count; ++i)
                    ASSERT_TRUE(std::isfinite(vertices.positions[i]) && std::isfinite(vertices.normals[i]));
            }
            EXPECT_EQ(shown, tmpl->levels[level].vertex_count) << distance;
        }
    }
}

}  // namespace claque::test
