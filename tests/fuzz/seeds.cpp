#include "tests/fuzz/seeds.h"

#include <fstream>
#include <iterator>

#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace fuzzing
{
namespace
{

Bytes noise(uint64_t seed, size_t size)
{
    Bytes out;
    for (size_t i = 0; i < size; ++i) out.push_back(static_cast<uint8_t>(mixed(seed, i) >> 24));
    return out;
}

void add_descriptions(std::vector<Seed> &out)
{
    for (const char *name :
         {"maps/roman-classes.toml", "maps/cmu-people.toml", "maps/cmu-kaykit.toml", "scenes/odeon/odeon.toml",
          "scenes/odeon/path.toml", "scenes/town/path.toml", "scenarios/corner.toml", "scenarios/evacuation.toml",
          "scenarios/market.toml", "scenarios/odeon-evening.toml", "labels/variation/example.toml"}) {
        std::ifstream file(std::string(CLAQUE_SOURCE_DIR "/samples/") + name, std::ios::binary);
        Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        EXPECT_FALSE(bytes.empty()) << name;
        std::string flat(name);
        for (char &c : flat) c = c == '/' ? '-' : c;
        out.push_back({"toml", flat, bytes});
    }
    for (const std::string &text :
         {std::string("base = \"gpu\"\nrequire = [\"positions\", \"depth\"]\n[at_most]\n"
                      "\"positions.max_relative\" = 1e-6\n[at_least]\n\"colour.psnr\" = 30\n"),
          std::string("[[classes]]\nname = \"men\"\n[classes.zones]\nhair = { palette = [ { "
                      "colour = \"#2a1a10\", weight = 3 } ] }\nbelt = { linked_to = \"hair\", "
                      "variation = 0.1 }\n")})
        out.push_back({"toml", std::to_string(out.size()), Bytes(text.begin(), text.end())});
    const std::string machine =
        "machine = \"m\"\n[variables]\nn = 0\n[events]\ngo = 1\n[states.a]\ninitial = true\n"
        "enter = [ { play = \"bend\", fade = 0.2 }, { send = \"go\", radius = 5, delay = 0.1 } ]\n"
        "transitions = [ { end = true, before = 0.2, to = \"b\" }, { if = \"n > 3\", to = \"b\" } ]\n[states.b]\n"
        "transitions = [ { after = [0.1, 0.3], to = \"a\", do = [ { set = \"n\", to = \"n + 1\" } ] } ]\n";
    out.push_back({"machine", "two states", Bytes(machine.begin(), machine.end())});
}

void add_crowds(std::vector<Seed> &out)
{
    TestWorld world;
    for (const uint32_t count : {0u, 3u, 12u}) {
        clq_crowd *crowd = world.new_crowd();
        world.set_up(crowd);
        std::vector<clq_actor> actors = world.fill(crowd, count, count);
        for (uint32_t step = 0; step < 4 * count; ++step) world.happen(crowd, actors, count, step);
        out.push_back({"save", std::to_string(count), saved::save(crowd)});
    }
}

}  // namespace

std::vector<Seed> seeds()
{
    std::vector<Seed> out;
    add_character_seeds(out);
    add_picture_seeds(out);
    add_folder_seeds(out);
    add_people_seeds(out);
    add_record_seeds(out);
    add_descriptions(out);
    add_crowds(out);
    for (const size_t size : {60u, 300u, 700u}) out.push_back({"zone_map", std::to_string(size), noise(size, size)});
    for (const size_t size : {100u, 400u, 1500u, 4000u})
        out.push_back({"calls", std::to_string(size), noise(size, size)});
    return out;
}

}  // namespace fuzzing
