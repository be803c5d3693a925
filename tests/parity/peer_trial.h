// A test that exports a scene, captures it, and has the GPU peer draw the scene as it is or changed.
#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "samples/parity/verdict.h"
#include "samples/scenes/scene_renderer.h"
#include "tests/parity/peer.h"

namespace parity_test
{

class PeerTrial : public testing::Test
{
protected:
    // Skips the test where there is no OpenGL context; otherwise exports and captures. 320 x 240, two seconds. `glb`:
    // the character of a parade.
    void begin(const char *scene, uint32_t count, const std::string &glb = "");
    void TearDown() override;

    // What the peer makes of a scene; its folder is that of the exported one.
    parity::Capture draw(const SceneIn &scene, const PeerOptions &options) const;
    // Exceeded limits; empty: all are kept.
    std::string broken(const parity::Capture &result, const char *tolerance) const;

    const SceneIn &scene() const { return scene_; }
    const parity::Capture &reference() const { return reference_; }

private:
    std::string path(const char *name) const { return (folder_ / name).string(); }

    std::filesystem::path folder_;
    SceneIn scene_;
    parity::Capture reference_;
};

}  // namespace parity_test
