// People in an OpenSceneGraph program. Writes three pictures: the town as a viewer shows it, the same with a culling
// frustum smaller than the picture's (S0 Fig. 10), and that frustum from outside, with the culled objects in grey.
#include <cstdio>

#include "samples/hosts/osg/application.h"
#include "samples/hosts/picture_file.h"

namespace
{

using namespace osg_host;

constexpr int width = 1024, height = 768;
constexpr uint32_t people = 700;
constexpr double time_s = 2, forced_share = 0.6;

void write(const std::string &path, const std::vector<uint8_t> &rgb)
{
    hosts::write_picture(path, rgb.data(), width, height);
}

void tell(const char *what, const Application &application)
{
    clq_crowd_stats stats = clq_crowd_stats_init();
    scenes::check(clq_crowd_get_stats(application.passengers().crowd(), &stats));
    std::printf("%s: %zu of %zu pieces of scenery, %zu of %zu omnibuses, %u of %u people\n", what,
                application.pieces().left_over(), application.pieces().count(), application.omnibuses().left_over(),
                application.omnibuses().count(), stats.visible, stats.actor_count);
}

void run(const std::string &prefix)
{
    std::string why_not;
    const std::unique_ptr<contexts::Offscreen> context =
        contexts::make_offscreen(contexts::Kind::egl, width, height, contexts::PixelFormat::rgba8888, why_not);
    if (!context) throw scenes::Failure("no OpenGL context: " + why_not);
    Application application(*context, people);
    const Viewpoint roofs = application.from_the_roofs();
    write(prefix + "view.png", application.picture(roofs, time_s));
    tell("view", application);
    write(prefix + "forced.png", application.picture(roofs, time_s, forced_share));
    tell("forced", application);
    write(prefix + "outside.png", application.picture_of_culling(application.from_outside(), time_s));
}

}  // namespace

int main(int count, char **arguments)
{
    if (count != 2) {
        std::fprintf(stderr, "usage: %s PREFIX   writes PREFIXview.png, PREFIXforced.png, PREFIXoutside.png\n",
                     arguments[0]);
        return 2;
    }
    try {
        run(arguments[1]);
        return 0;
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        return 1;
    }
}
