// Characters of files that face another way, walk and blend, in commands and scenarios.
#pragma once

#include <cmath>
#include <cstring>
#include <fstream>

#include "tests/cli/run.h"
#include "tests/support/gltf_maker.h"
#include "tests/support/walking_figure.h"

namespace cli_test
{

using claque::testing::FigureTraits;
using claque::testing::walking_figure;

class PlacementOptions : public Command
{
protected:
    PlacementOptions()
    {
        FigureTraits back;
        back.heading_deg = 180;
        write("back.glb", back);
        back.strange_names = true;
        write("strange.glb", back);
        std::ofstream table(path("way.csv"));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame <= 50; ++frame) table << "anna," << frame << ',' << 0.12 * frame << ",0\n";
    }
    void write(const std::string &name, const FigureTraits &traits) const
    {
        const claque::testing::Bytes bytes = walking_figure(traits);
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    // With a material that blends, and is below the alpha test everywhere.
    void write_visor() const
    {
        using GltfJson = claque::testing::Json;
        claque::testing::Maker maker;
        maker.triangle();
        maker.primitive()["material"] = 0;
        const GltfJson alpha = {{"baseColorFactor", {1, 1, 1, 0.4}}};
        maker.add("materials", {{"name", "visor"}, {"alphaMode", "BLEND"}, {"pbrMetallicRoughness", alpha}});
        const claque::testing::Bytes bytes = maker.glb();
        std::ofstream(path("visor.glb"), std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    Outcome tracks(const std::vector<std::string> &more) const
    {
        std::vector<std::string> arguments = {"tracks", path("way.csv"), "--columns", "id,frame,x,y", "--rate",
                                              "10",     "--unit",        "m"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return claque(arguments);
    }
    std::vector<float> dumped(const std::vector<std::string> &more) const
    {
        std::vector<std::string> arguments = {"dump", path("back.glb"), "--out", path("dumped.npy")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const std::string file = file_text(path("dumped.npy"));
        std::vector<float> xyz((file.size() - 128) / sizeof(float));
        std::memcpy(xyz.data(), file.data() + 128, xyz.size() * sizeof(float));
        return xyz;
    }
    // Runs a scenario with one class, of this character and with these lines.
    Outcome scenario(const std::string &character, const std::string &lines,
                     const std::vector<std::string> &more = {}) const
    {
        std::ofstream(path("scenario.toml"))
            << "name = \"walk\"\n[tracks]\nfile = \"way.csv\"\ncolumns = \"id,frame,x,y\"\nrate_hz = 10\nunit = \"m\"\n"
            << "[[characters]]\nname = \"people\"\ncharacter = \"" << character << "\"\n"
            << lines;
        std::vector<std::string> arguments = {"render", "--scenario", path("scenario.toml"), "--size",
                                              "64x48",  "--out",      path("s.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return claque(arguments);
    }
};

inline bool says(const Outcome &outcome, const std::string &sentence)
{
    return outcome.err.find(sentence) != std::string::npos;
}

}  // namespace cli_test
