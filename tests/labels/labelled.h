// A scene that is labelled for tests.
#pragma once

#include <gtest/gtest.h>

#include "samples/labels/labeller.h"
#include "tests/gl/support/absent.h"

namespace labels_test
{

// Skips the test where this machine has no software GL.
class Labelled : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
            END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    }

    void open(const std::string &scene, uint32_t count, int width, int height, int threads = 1)
    {
        labeller_.reset(), scene_.reset(), library_.reset();
        library_ = std::make_unique<scenes::Library>(threads);
        scenes::SceneOptions options;
        options.scene = scene, options.width = width, options.height = height;
        options.crowd_options.count = count, options.crowd_options.exact_poses = true;
        scene_ = std::make_unique<scenes::SceneRenderer>(*library_, options);
        labels::Wanted wanted;
        wanted.positions = true;
        labeller_ = std::make_unique<labels::Labeller>(*library_, *scene_, wanted);
    }

    std::unique_ptr<scenes::Library> library_;
    std::unique_ptr<scenes::SceneRenderer> scene_;
    std::unique_ptr<labels::Labeller> labeller_;
};

}  // namespace labels_test
