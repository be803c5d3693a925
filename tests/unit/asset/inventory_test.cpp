// Every character and prop of the collection that is not meant to be refused, and every written character, held against
// the inventory beside it.
#include <map>
#include <set>

#include "assets.h"
#include "lib/asset/decoders.h"

namespace claque::testing
{
namespace
{

// Why this one does not load: it says itself that it is invalid.
const std::map<std::string, std::pair<int, std::string>> always_refused = {
    {"conformance/magnum/mesh-sparse.gltf", {CLQ_FORMAT, "sparse index"}}};

// What these need; a build without the decoder names one of them.
const std::map<std::string, std::vector<asset::Decoder>> needed = {
    {"compressed/Casual_Male-draco.gltf", {asset::Decoder::draco}},
    {"compressed/CesiumMan-Draco/CesiumMan.gltf", {asset::Decoder::draco}},
    {"compressed/valid-Asian_F_1_Busi.glb", {asset::Decoder::meshopt, asset::Decoder::webp}},
    {"environment/godot-town/town_model.gltf", {asset::Decoder::webp}},
    {"environment/kenney-town/fountain-round.glb", {asset::Decoder::draco}},
    {"environment/kenney-town/stairs-stone-round.glb", {asset::Decoder::draco}}};

std::map<std::string, std::pair<int, std::string>> refused_here()
{
    auto refused = always_refused;
    for (const auto &[file, decoders] : needed)
        for (const asset::Decoder decoder : decoders)
            if (!asset::has_decoder(decoder)) refused[file] = {CLQ_UNSUPPORTED, "this libclaque-assets was built"};
    return refused;
}

// The inventory counts meshes and vertices once; these show a mesh on several nodes, or on none.
const std::set<std::string> instanced = {"environment/godot-town/town_model.gltf",
                                         "conformance/khronos/RecursiveSkeletons.glb",
                                         "machines/khronos/CesiumMilkTruck.glb",
                                         "conformance/asset-generator/Animation_NodeMisc/Animation_NodeMisc_04.gltf",
                                         "conformance/magnum/mesh-skin-attributes.gltf",
                                         "conformance/magnum/mesh-unsigned-int-vertex-formats.gltf"};

Json inventory(const std::string &folder) { return Json::parse(std::ifstream(folder + "/inventory.json")); }

void expect_as_listed(const std::string &file, const Json &row, const model::Model &model)
{
    size_t vertices = 0;
    std::set<uint32_t> joints;
    uint32_t influences = 0;
    for (const model::Part &part : model.parts) {
        vertices += part.positions.size();
        if (part.skinned) influences = std::max(influences, part.influence_count);
    }
    if (!instanced.count(file)) {
        EXPECT_EQ(model.parts.size(), row["primitives"].get<size_t>()) << file;
        EXPECT_EQ(vertices, row["vertices"].get<size_t>()) << file;
        if (!needed.count(file)) {  // the inventory could not look into compressed files
            EXPECT_EQ(influences, row["max_influences"].is_number() ? row["max_influences"].get<uint32_t>() : 0)
                << file;
        }
    }
    for (const model::PaletteEntry &entry : model.rig.palette) {
        bool rigid = false;
        for (const model::Part &part : model.parts) rigid = rigid || (!part.skinned && part.node == entry.node);
        if (!rigid) joints.insert(entry.node);
    }
    if (!model.parts.empty()) {
        EXPECT_EQ(joints.size(), row["distinct_joints"].get<size_t>()) << file;
    }
    ASSERT_EQ(model.rig.clips.size(), row["clips"].size()) << file;
    for (size_t i = 0; i < model.rig.clips.size(); ++i) {
        // What the inventory calls seconds is the time of the last key.
        EXPECT_NEAR(model.rig.clips[i].start_s + model.rig.clips[i].duration_s, row["clips"][i]["seconds"].get<float>(),
                    1e-3f)
            << file << " " << i;
        EXPECT_NEAR(model.rig.clips[i].start_s, row["clips"][i]["start"].get<float>(), 1e-3f) << file << " " << i;
        EXPECT_EQ(model.rig.clips[i].channel_count, row["clips"][i]["channels"].get<uint32_t>()) << file << " " << i;
    }
    for (const model::Part &part : model.parts)
        if (part.material != model::none && model.materials[part.material].zone == model::none)
            ADD_FAILURE() << file << ": material '" << model.materials[part.material].name << "' has no zone";
}

TEST(Inventory, EveryFileLoadsAsListedOrIsRefusedForItsReason)
{
    CLAQUE_NEEDS_ASSETS();
    size_t loaded = 0, refusals = 0;
    const auto refused = refused_here();
    for (const Json &row : inventory(assets_folder())) {
        const std::string file = row["file"];
        const std::string suffix = std::filesystem::path(file).extension().string();
        if (suffix != ".glb" && suffix != ".gltf") continue;
        model::Model model;
        const Outcome outcome = outcome_of([&] { model = load(read_asset(file), options_for(file)); });
        const auto reason = refused.find(file);
        if (reason != refused.end()) {
            ++refusals;
            EXPECT_EQ(outcome.status, reason->second.first) << file << ": " << outcome.text;
            EXPECT_NE(outcome.text.find(reason->second.second), std::string::npos) << file << ": " << outcome.text;
            continue;
        }
        ASSERT_EQ(outcome.status, 0) << file << ": " << outcome.text;
        ++loaded;
        expect_as_listed(file, row, model);
    }
    EXPECT_EQ(refusals, refused.size());
    EXPECT_GE(loaded, 87u);
}

TEST(Inventory, EveryWrittenCharacterLoadsAsListed)
{
    size_t loaded = 0;
    for (const Json &row : inventory(written::folder())) {
        const std::string file = row["file"];
        expect_as_listed(file, row, load(read_asset(file), options_for(file)));
        ++loaded;
    }
    EXPECT_EQ(loaded, written::files().size());
}

TEST(Inventory, AWrittenPropHiddenByNameKeepsItsPlace)
{
    const std::string file = "WrittenPerson.glb";
    const auto hidden_by = [&](const std::vector<std::string> &nodes) {
        asset::LoadOptions options = options_for(file);
        options.hidden_nodes = nodes;
        const model::Model model = load(read_asset(file), options);
        EXPECT_EQ(model.parts.size(), 7u);
        EXPECT_EQ(model.warnings.size(), 1u);
        EXPECT_NE(model.warnings.at(0).find("no such node"), std::string::npos);
        std::set<std::string> hidden;
        for (const model::Part &part : model.parts)
            if (part.hidden) hidden.insert(model.rig.node_names[part.node].c_str());
        return hidden;
    };
    EXPECT_EQ(hidden_by({"hat", "no such node"}), (std::set<std::string>{"hat"}));
    EXPECT_EQ(hidden_by({"head", "no such node"}), (std::set<std::string>{"hat", "ear-ring.l", "ear-ring.r"}));
}

TEST(Inventory, APropHiddenByNameKeepsItsPlaceAndLosesItsMaterialsZone)
{
    CLAQUE_NEEDS_ASSETS();
    const std::string file = "humanoids/kaykit/Barbarian.glb";
    asset::LoadOptions options = options_for(file);
    options.hidden_nodes = {"2H_Axe", "handslot.l", "no such node"};
    const model::Model model = load(read_asset(file), options);
    std::set<std::string> hidden;
    for (const model::Part &part : model.parts)
        if (part.hidden) hidden.insert(model.rig.node_names[part.node].c_str());
    EXPECT_EQ(hidden, (std::set<std::string>{"1H_Axe_Offhand", "Barbarian_Round_Shield", "2H_Axe"}));
    EXPECT_EQ(model.parts.size(), 13u);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("no such node"), std::string::npos);
}

}  // namespace
}  // namespace claque::testing
