// Many individuals of one proxy level, each with its own rotation, position and colours.
#pragma once

#include "lib/figures/figure.h"
#include "lib/lod/proxies/proxy.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{

using claque::draw::DrawList;
using claque::draw::Item;

// The citizen in about this many triangles, each of one zone.
inline PosedModel proxy_posed(uint32_t triangles)
{
    model::Model model = claque::figures::citizen();
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    claque::lod::ProxyMeshOptions options;
    options.targets = {triangles};
    claque::lod::ProxyLevels proxies = claque::lod::make_proxies(model, parts, options);
    claque::lod::add_to_model(proxies, model);
    model.parts = proxies.parts;
    return split_posed(model);
}

class CrowdTest : public GlTest
{
protected:
    static constexpr uint32_t across = 8, crowd = 40;

    explicit CrowdTest(const PosedModel &posed) : posed_(&posed) {}

    void SetUp() override
    {
        GlTest::SetUp();
        for (uint32_t person = 0; person < crowd; ++person)
            colours_.push_back(zone_colours(static_cast<uint32_t>(posed_->tmpl->zone_count())));
        for (uint32_t person = 0; person < crowd; ++person)
            for (size_t i = 0; i < colours_[person].size(); ++i)
                colours_[person][i] = static_cast<uint8_t>(colours_[person][i] + 5 * person);
    }

    // One call per individual.
    static passes::RendererOptions apart()
    {
        passes::RendererOptions options;
        options.batch_triangles = 0;
        return options;
    }
    static passes::RendererOptions smooth()
    {
        passes::RendererOptions options;
        options.flat_triangles = 0;
        return options;
    }

    // Individuals in rows.
    DrawList many() const
    {
        const Camera camera = camera_on(*posed_, 9, -0.3f, 0.2f, 4.0f / 3.0f);
        std::vector<Individual> people;
        for (uint32_t person = 0; person < crowd; ++person) {
            Individual one = individual_of(*posed_, camera, colours_[person].data());
            one.model_view[12] += 1.1f * posed_->radius * (float(person % across) - 3.5f);
            one.model_view[13] += 1.3f * posed_->radius * (float(person / across) - 2);
            people.push_back(one);
        }
        return list_of(people, camera.projection);
    }
    // In odd scales, every third one mirrored.
    DrawList squeezed() const
    {
        DrawList list = many();
        for (uint32_t person = 0; person < crowd; ++person) {
            float *m = list.items[person].model_view;
            for (int r = 0; r < 3; ++r) m[r] *= 0.8f, m[4 + r] *= 1.3f, m[8 + r] *= person % 3 == 0 ? -1.0f : 1.0f;
            list.items[person].mirrored = person % 3 == 0;
        }
        return list;
    }
    void light_from(const float (&direction)[4])
    {
        host_->Enable(0x0B50);  // GL_LIGHTING
        host_->Enable(0x4000);
        host_->Lightfv(0x4000, 0x1203, direction);
    }
    Picture shown(const DrawList &list, const passes::RendererOptions &options, passes::DrawStats *stats = nullptr)
    {
        const auto renderer = make_renderer_of(*posed_, options);
        const Picture picture = draw(*context_, *renderer, list, 0.001 * double(list.items.size()));
        if (stats) {
            EXPECT_TRUE(renderer->draw(list, stats).ok());
        }
        return picture;
    }
    void expect_the_same_for_all_strategies_and_formats()
    {
        const Picture expected = shown(many(), {});
        for (const passes::Strategy strategy : all_strategies)
            for (const passes::ColourFormat colours : {passes::ColourFormat::ubyte, passes::ColourFormat::real}) {
                passes::RendererOptions options = options_of(strategy);
                options.colours = colours;
                EXPECT_TRUE(shown(many(), options) == expected) << int(strategy) << " " << int(colours);
            }
    }
    static uint32_t different(const Picture &a, const Picture &b, int beyond)
    {
        uint32_t count = 0;
        for (size_t i = 0; i + 2 < a.size(); i += 3) {
            int most = 0;
            for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[i + c]) - int(b[i + c])));
            count += most > beyond;
        }
        return count;
    }
    static bool is_background(const Picture &picture, size_t at)
    {
        return std::equal(background, background + 3, picture.begin() + std::ptrdiff_t(at));
    }

    const PosedModel *posed_;
    std::vector<std::vector<uint8_t>> colours_;
};

// Of citizens in about this many triangles.
template <uint32_t triangles>
class CrowdOf : public CrowdTest
{
protected:
    CrowdOf() : CrowdTest(posed()) {}
    static const PosedModel &posed()
    {
        static const PosedModel made = proxy_posed(triangles);
        return made;
    }
};

}  // namespace gltest
