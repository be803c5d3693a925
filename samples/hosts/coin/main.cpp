// People in a Coin program: writes a picture of a portico.
#include <cstdio>

#include "samples/hosts/coin/portico.h"
#include "samples/hosts/picture_file.h"

namespace
{

constexpr int width = 1024, height = 640;

void run(const char *path)
{
    std::string why_not;
    const std::unique_ptr<contexts::Offscreen> context =
        contexts::make_offscreen(contexts::Kind::egl, width, height, contexts::PixelFormat::rgba8888, why_not);
    if (!context) throw scenes::Failure("no OpenGL context: " + why_not);
    coin_host::Portico portico(*context);
    hosts::write_picture(path, portico.picture(2).data(), width, height);
    std::printf("%u people in %s\n", portico.people().drawn().individuals, path);
}

}  // namespace

int main(int count, char **arguments)
{
    if (count != 2) {
        std::fprintf(stderr, "usage: %s PICTURE.png\n", arguments[0]);
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
