// A view of a small scene in memory, for tests.
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "samples/view/script.h"
#include "samples/view/session.h"

namespace view_test
{

struct Stage {
    std::string scene = "parade";
    uint32_t count = 5;
    int width = 480, height = 480;
    float scale = 1;
    std::string character = {};             // a built-in one, for the parade
    std::vector<std::string> line_up = {};  // built-in people side by side, in place of a scene
    std::string file = {};                  // of a character, in the place of a built-in one
};

std::function<std::unique_ptr<scenes::Scene>(scenes::Library &, const scenes::CrowdOptions &)> line_up_of(
    const std::vector<std::string> &names);

// Skips the test where this machine has no software GL.
class Staged : public testing::Test
{
protected:
    void SetUp() override;

    // In place of the session before it.
    view::Session &open(const Stage &stage);
    view::Session &open_with(const view::Open &open, const Stage &stage = {});
    view::Session &session() { return *session_; }
    view::Surface &surface() { return *surface_; }

    // Plays steps; the input of the last frame stays. Throws scenes::Failure.
    void play(const std::vector<std::string> &steps);
    void play(view::Script script, const std::function<void(const view::Input &)> &each);
    // The whole window, or the picture alone, as it is.
    std::vector<uint8_t> window();
    std::vector<uint8_t> picture();

    // Called after each frame of play().
    std::function<void()> seen = [] {};

private:
    Stage stage_;
    std::unique_ptr<view::Surface> surface_;
    std::optional<view::Session> session_;
};

// No widget and no text is cut or lies on another one, and the lower bar needs no scrolling.
void expect_in_order(const view::Ui &ui, const std::string &at);

}  // namespace view_test
