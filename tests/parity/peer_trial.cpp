#include "tests/parity/peer_trial.h"

#include <claque/assets.h>

#include <unistd.h>

#include "samples/parity/compare.h"
#include "samples/parity/write/write.h"
#include "samples/scenes/check.h"
#include "tests/gl/support/absent.h"
#include "tests/parity/result_out.h"

namespace parity_test
{

namespace fs = std::filesystem;

void PeerTrial::begin(const char *scene, uint32_t count, const std::string &glb)
{
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
        END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    folder_ = fs::temp_directory_path() / ("claque-peer-trial-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    scenes::Library library(2);
    scenes::SceneOptions options;
    options.scene = scene;
    options.crowd_options.count = count;
    options.width = 320, options.height = 240;
    options.flat_triangles = 0;  // the peer lights smoothly
    scenes::Own<clq_template> tmpl;
    if (!glb.empty()) {
        clq_asset *asset = nullptr;
        scenes::check(clq_asset_load(library.context(), glb.data(), glb.size(), nullptr, &asset));
        const scenes::Own<clq_asset> owned(asset);
        clq_template *made = nullptr;
        scenes::check(clq_asset_build(library.context(), asset, 0, &made));
        tmpl.reset(made);
        options.character.tmpl = made;
    }
    scenes::SceneRenderer scene_renderer(library, options);
    const parity::CaptureTime capture_time = {options.scene, 2, options.width, options.height};
    parity::write_scene(scene_renderer, capture_time, path("scene"));
    parity::write_result(scene_renderer, capture_time, path("reference"));
    scene_ = read_scene(path("scene"));
    reference_ = parity::read_capture(path("reference"));
}

void PeerTrial::TearDown()
{
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

parity::Capture PeerTrial::draw(const SceneIn &scene, const PeerOptions &options) const
{
    std::string why_not;
    const auto context = contexts::make_offscreen(contexts::Kind::any, scene.width, scene.height,
                                                  contexts::PixelFormat::rgba8888, why_not);
    Peer peer(*context, scene, options);
    write_result(*context, peer, scene, path("scene"), path("result"));
    return parity::read_capture(path("result"));
}

std::string PeerTrial::broken(const parity::Capture &result, const char *tolerance) const
{
    constexpr double pixels_per_degree = 67;
    return parity::reasons(
        parity::verdict_of(parity::compare(reference_, result, pixels_per_degree), parity::tolerance_of(tolerance)),
        99);
}

}  // namespace parity_test
