#include "samples/cli/label_scene.h"

namespace cli
{
namespace
{

class FilmScene final : public LabelScene
{
public:
    FilmScene(scenes::Library &library, const scenes::SceneOptions &options, const labels::Wanted &wanted, double fps)
        : fps_(fps), scene_(library, options), labeller_(library, scene_, wanted)
    {
    }

    LabelledPicture label(int number) override
    {
        LabelledPicture out;
        out.sample = labeller_.label(number, number / fps_);
        out.silhouette_pictures = labeller_.silhouette_pictures();
        return out;
    }

private:
    double fps_;
    scenes::SceneRenderer scene_;
    labels::Labeller labeller_;
};

}  // namespace

std::unique_ptr<LabelScene> film_scene(scenes::Library &library, const scenes::SceneOptions &options,
                                       const labels::Wanted &wanted, double fps)
{
    return std::make_unique<FilmScene>(library, options, wanted, fps);
}

}  // namespace cli
