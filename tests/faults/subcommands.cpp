#include "tests/faults/subcommands.h"

#include <fstream>

#include "tests/support/written_characters.h"

namespace command_faults
{

namespace fs = std::filesystem;

static Subcommand for_signals(const char *name, const std::vector<std::string> &words, bool is_slow = false)
{
    Subcommand made = {name, words, true, is_slow};
    made.is_for_signals = true;
    return made;
}

const std::vector<Subcommand> &subcommands()
{
    static const std::vector<Subcommand> all = {
        {"render",
         {"render", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">p.png", "--json", ">p.json"},
         true},
        {"render_prepared", {"render", "<p.clq", "--count", "2", "--size", "32x24", "--out", ">p.png"}, true},
        {"render_scene",
         {"render", "--scenario", "<odeon.toml", "--camera", "path", "--path", "<path.toml", "--colours", "<roman.toml",
          "--count", "3", "--size", "32x24", "--out", ">p.png"},
         true,
         true},
        {"render_tracks",
         {"render", "--scenario", "<street.toml", "--time", "3", "--size", "32x24", "--out", ">p.png"},
         true,
         true},
        {"sheet",
         {"sheet", "--path", "<path.toml", "--scenario", "<odeon.toml", "--count", "3", "--size", "32x24", "--out",
          ">s.png", "--json", ">s.json"},
         true,
         true},
        {"inspect", {"inspect", "<p.glb", "--json"}},
        {"dump", {"dump", "<p.glb", "--out", ">p.npy"}},
        {"split", {"split", "<p.glb", "--picture", ">p.png"}},
        {"variety", {"variety", "<p.glb", "--count", "2", "--colours", "<p.toml", "--out", ">p.png"}, true},
        {"colours_save", {"colours", "save", "<roman.toml", "--out", ">c.toml"}},
        {"lods", {"lods", "<p.glb", "--targets", "500", "--proxy-max-triangles", "0", "--out", ">l.png"}, true},
        {"blend",
         {"blend",   "<p.glb",    "--fade", "walk,wave",  "--phases", "2",      "--over",
          "walk",    "--layer",   "wave",   "--additive", "stand",    "--node", "body",
          "--gaits", "walk,wave", "--size", "300x300",    "--out",    ">b.png"},
         true},
        {"prepare", {"prepare", "<s.gltf", "--propose", "2", "--zones-out", ">z.png", "--out", ">p.clq"}},
        {"prepare_clips",
         {"prepare", "citizen", "--clips", "<w.bvh", "--map", "<map.toml", "--zones", "<z.png", "--out", ">p.clq"}},
        {"convert", {"convert", "<o.obj", "--out", ">o.glb"}, false, false, true},
        {"bench",
         {"bench", "<p.glb", "--count", "2", "--frames", "1", "--strategy", "fused", "--cache", "none", "--size",
          "32x24", "--save", ">b.json"},
         true},
        {"bench_operations",
         {"bench", "hundred_actors", "--frames", "1", "--strategy", "fused", "--cache", "none", "--size", "32x24",
          "--operations", ">o.json"},
         true,
         true},
        {"plot", {"plot", "<lines.json", "--out", ">l.svg"}},
        {"plot_png", {"plot", "<lines.json", "--out", ">l.png"}},
        {"cost", {"cost", "--measured", "<counts.json", "--json", ">c.json", "--plot", ">c.svg"}},
        {"labels",
         {"labels", "--scene", "plaza", "--count", "2", "--size", "32x24", "--frames", "0:1", "--write", "coco,flo",
          "--out", ">labels/", "--json", ">l.json"},
         true,
         false,
         false,
         true},
        {"parity_export", {"parity", "export", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">scene/"}, true},
        {"parity_capture",
         {"parity", "capture", "<p.glb", "--count", "2", "--size", "32x24", "--out", ">result/"},
         true},
        {"parity_compare",
         {"parity", "compare", "<a/", "<b/", "--tolerance", "<mine.toml", "--json", ">r.json", "--html", ">r.html"},
         true},
        for_signals("film", {"render", "<p.glb", "--count", "2", "--size", "32x24", "--frames", "0:1", "--out",
                             ">f-%d.png", "--manifest", ">film.json"}),
        for_signals("record", {"play", "<corner.csv", "--columns", "id,frame,x,y", "--rate", "2", "--unit", "m",
                               "--size", "32x24", "--frames", "0:1", "--out", ">f-%d.png", "--record", ">run.clt"}),
        for_signals("readers", {"bench", "readers", "--count", "1", "--save", ">r.json"}, true)};
    return all;
}

void make_inputs(const fs::path &folder)
{
    const fs::path source = CLAQUE_SOURCE_DIR;
    fs::copy_file(written::folder() + "WrittenPerson.glb", folder / "p.glb");
    fs::copy_file(written::folder() + "WrittenWalk.bvh", folder / "w.bvh");
    fs::copy_file(source / "samples/scenes/odeon/odeon.toml", folder / "odeon.toml");
    fs::copy_file(source / "samples/scenes/odeon/path.toml", folder / "path.toml");
    fs::copy_file(source / "samples/maps/roman-classes.toml", folder / "roman.toml");
    for (const char *name : {"corner.csv", "corner.wkt"})
        fs::copy_file(source / "samples/scenarios" / name, folder / name);
    std::ofstream(folder / "street.toml")
        << "name = 'street'\ncolours = 'roman.toml'\n[tracks]\nfile = 'corner.csv'\ncolumns = 'id,frame,x,y'\n"
           "rate_hz = 2\nunit = 'm'\n[[characters]]\nname = 'plebeians'\ncharacter = 'plebeian'\n"
           "[ground]\narea = 'corner.wkt'\n[camera]\npath = 'path.toml'\n";
    fs::copy_file(source / "samples/maps/cmu-people.toml", folder / "map.toml");
    fs::copy_file(written::folder() + "WrittenSparse.gltf", folder / "s.gltf");
    for (const auto &file : fs::directory_iterator(written::folder()))
        if (file.path().extension() == ".bin" || file.path().extension() == ".png")
            fs::copy_file(file.path(), folder / file.path().filename());
    std::ofstream(folder / "mine.toml") << "require = ['colour']\n[at_most]\ncolour.over_8 = 1\n";
    std::ofstream(folder / "o.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    std::ofstream(folder / "lines.json") << R"({"kind": "lines", "title": "t", "x": {"title": "x"}, "y": {"title": "y"},
        "series": [{"name": "s", "points": [[1, 1], [2, 3]]}]})";
}

}  // namespace command_faults
