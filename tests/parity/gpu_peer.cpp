// gpu_peer SCENE RESULT [any|osmesa|egl]: draws the output of claque parity export with shaders in a context of this
// kind and writes the result. Exit codes: 0 done; 1 failed, with one sentence; 2 wrong usage; 77 this machine has no
// OpenGL to draw with.
#include <iostream>

#include "tests/parity/result_out.h"

int main(int argc, char **argv)
{
    const auto kind = contexts::kind_named(argc == 4 ? argv[3] : "any");
    if (argc < 3 || argc > 4 || !kind || kind == contexts::Kind::glx) {
        std::cerr << "gpu_peer SCENE RESULT [any|osmesa|egl]: the folder of a parity scene, a folder for the result, "
                     "and the kind of OpenGL context\n";
        return 2;
    }
    try {
        const parity_test::SceneIn scene = parity_test::read_scene(argv[1]);
        std::string why_not;
        const auto context =
            contexts::make_offscreen(*kind, scene.width, scene.height, contexts::PixelFormat::rgba8888, why_not);
        if (!context) {
            std::cerr << "gpu_peer: no OpenGL context: " << why_not << "\n";
            return 77;
        }
        parity_test::PeerOptions options;
        options.limiting = parity_test::limiting_for(scene.lighting);
        parity_test::Peer peer(*context, scene, options);
        parity_test::write_result(*context, peer, scene, argv[1], argv[2]);
        return 0;
    } catch (const std::exception &error) {
        std::cerr << "gpu_peer: " << error.what() << "\n";
        return 1;
    }
}
