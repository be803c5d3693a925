// Labels the pictures of a run one by one: makes their files, and leaves writing them to others.
#pragma once

#include <memory>

#include "samples/cli/label_scene.h"
#include "samples/cli/label_work.h"
#include "samples/cli/stopwatch.h"
#include "samples/labels/formats.h"

namespace cli
{

struct LabelledFiles {
    Json about;  // what the picture says of its people, and its choices
    // Counts; times of the colour picture with its labels (label_), of that until the colour picture was read
    // (picture_), and of making the files.
    Json report;
    std::vector<labels::FrameFile> files;
};

class LabelMaker
{
public:
    // `arguments` must live as long as this.
    LabelMaker(const LabelArguments &arguments, int threads);

    // What GL calls itself. Throws scenes::Failure, as the next call does.
    std::string gl() const;
    // The scene is made before the first picture.
    LabelledFiles make(int number);

private:
    const LabelArguments &arguments_;
    scenes::Library library_;
    scenes::SceneOptions options_;
    std::unique_ptr<LabelScene> scene_;
    Stopwatch clock_;  // since the labelling of a picture began
    Stopwatch spent_{Stopwatch::Clock::processor};
    double picture_ms_ = 0, picture_cpu_ms_ = 0;  // of that, until the colour picture was read
};

// Of the scene that the arguments name.
scenes::SceneOptions label_options(const LabelArguments &arguments);

}  // namespace cli
