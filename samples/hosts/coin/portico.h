// A Coin program's scene: a portico of columns with people among them.
#pragma once

#include <memory>
#include <vector>

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include "samples/contexts/offscreen.h"
#include "samples/hosts/coin/crowd_callback.h"
#include "samples/scenes/library.h"

class SoSceneManager;

namespace coin_host
{

class Portico
{
public:
    // Draws into this context, which is current. Coin has one of the process. Throws scenes::Failure.
    explicit Portico(contexts::Offscreen &context);
    ~Portico();

    // Three bytes a pixel, top row first, valid until the next call. Throws scenes::Failure.
    const std::vector<uint8_t> &picture(double time_s);
    SoSeparator &people_here() const { return *people_here_; }  // the parent of their node alone
    SoPerspectiveCamera &camera() const { return *camera_; }
    const CrowdCallback &people() const { return *people_; }

private:
    void build();
    void cast();

    contexts::Offscreen &context_;
    scenes::Library library_;
    scenes::Own<clq_crowd> crowd_;
    std::unique_ptr<CrowdCallback> people_;
    SoSeparator *root_, *people_here_;
    SoPerspectiveCamera *camera_;
    std::unique_ptr<SoSceneManager> manager_;
    std::vector<uint8_t> rgb_;
};

}  // namespace coin_host
