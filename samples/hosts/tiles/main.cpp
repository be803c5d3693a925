// One picture by several processes. Writes a picture and says in how many pixels those of several processes differ from
// those of one.
#include <cstdio>
#include <cstdlib>

#include "samples/hosts/picture_file.h"
#include "samples/hosts/tiles/tiled_picture.h"

namespace
{

constexpr int width = 640, height = 360, pictures = 4;

void run(const std::string &path, int processes)
{
    const size_t size = 3 * static_cast<size_t>(width) * height;
    std::vector<uint8_t> shared, alone;
    {
        tiles::TiledPicture picture(width, height, processes);
        for (int k = 0; k < pictures; ++k) {
            const uint8_t *rgb = picture.show(k * 0.5);
            shared.insert(shared.end(), rgb, rgb + size);
            std::printf("picture %d:", k);
            for (const processes::Tile &tile : picture.tiles()) std::printf(" %d-%d", tile.x0, tile.x1);
            std::printf("\n");
        }
    }
    tiles::TiledPicture whole(width, height, 1);
    for (int k = 0; k < pictures; ++k) {
        const uint8_t *rgb = whole.show(k * 0.5);
        alone.insert(alone.end(), rgb, rgb + size);
    }
    size_t other = 0;
    for (size_t i = 0; i < alone.size(); i += 3) other += !std::equal(&alone[i], &alone[i] + 3, &shared[i]);
    std::printf("%zu of %zu pixels differ\n", other, alone.size() / 3);
    hosts::write_picture(path, shared.data() + (pictures - 1) * size, width, height);
}

}  // namespace

int main(int count, char **arguments)
{
    const int processes = count > 2 ? std::atoi(arguments[2]) : 3;
    if (count < 2 || count > 3 || processes < 1 || processes > 64) {
        std::fprintf(stderr, "usage: %s PICTURE.png [PROCESSES]   1 to 64 processes, 3 if no number is given\n",
                     arguments[0]);
        return 2;
    }
    try {
        run(arguments[1], processes);
        return 0;
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        return 1;
    }
}
