// Small conformance files and written characters, damaged a few bytes at a time: whatever comes of it, only base::Error
// may.
#include "assets.h"
#include "lib/base/hash.h"

namespace claque::testing
{
namespace
{

const std::vector<std::string> conformance_files = {
    "conformance/khronos/SimpleMorph-Embedded/SimpleMorph.gltf",
    "conformance/khronos/AnimatedMorphCube.glb",
    "conformance/khronos/RiggedSimple.glb",
    "conformance/khronos/InterpolationTest.glb",
    "conformance/khronos/VertexColorTest.glb",
    "conformance/khronos/SimpleSkin-external/SimpleSkin.gltf",
    "conformance/khronos/SimpleSparseAccessor-external/SimpleSparseAccessor.gltf",
    "conformance/magnum/mesh-skin-attributes.gltf",
    "compressed/AnimatedMorphCube-Quantized/AnimatedMorphCube.gltf",
    "hostile/gltf/box_sparse.glb",
    "hostile/validator/glb/two_images.glb"};
constexpr uint64_t runs_per_file = 400;

// Numbers in a row for one damage, the same on every machine.
class Dice
{
public:
    explicit Dice(uint64_t seed) : seed_(seed) {}
    uint64_t below(uint64_t limit) { return base::hash(seed_, thrown_++, base::Purpose::pick) % limit; }

private:
    uint64_t seed_, thrown_ = 0;
};

// The JSON half is where most of what is read is decided: half of the damage goes there.
void damage(Bytes &bytes, Dice &dice)
{
    const size_t head = std::min<size_t>(bytes.size(), 3000);
    for (uint64_t n = 1 + dice.below(4); n > 0 && !bytes.empty(); --n) {
        const size_t at = dice.below(2) ? dice.below(head) : dice.below(bytes.size());
        switch (dice.below(6)) {
            case 0:
                bytes[at % bytes.size()] = static_cast<uint8_t>(dice.below(256));
                break;
            case 1:
                bytes[at % bytes.size()] ^= static_cast<uint8_t>(1u << dice.below(8));
                break;
            case 2:
            case 3:
                bytes[at % bytes.size()] = static_cast<uint8_t>("0123456789-.e[]{}\",:"[dice.below(20)]);
                break;
            case 4:
                bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at % bytes.size()), '9');
                break;
            default:
                if (dice.below(8) == 0) bytes.resize(at % bytes.size() + 1);
        }
    }
}

void expect_loaded_or_refused(const std::vector<std::string> &files)
{
    uint64_t loaded = 0, refused = 0;
    for (size_t f = 0; f < files.size(); ++f) {
        const Bytes whole = read_asset(files[f]);
        const asset::LoadOptions options = options_for(files[f]);
        for (uint64_t run = 0; run < runs_per_file; ++run) {
            Dice dice(1000 * f + run);
            Bytes bytes = whole;
            damage(bytes, dice);
            const Outcome outcome = outcome_of(bytes, options);
            outcome.status == 0 ? ++loaded : ++refused;
            EXPECT_NE(outcome.status, CLQ_ARGUMENT) << files[f] << " run " << run << ": " << outcome.text;
        }
    }
    EXPECT_GT(loaded, 100u);
    EXPECT_GT(refused, 100u);
}

TEST(Mutation, DamagedFilesLoadOrAreRefusedAndNothingElse)
{
    CLAQUE_NEEDS_ASSETS();
    expect_loaded_or_refused(conformance_files);
}

TEST(Mutation, DamagedWrittenCharactersLoadOrAreRefusedAndNothingElse) { expect_loaded_or_refused(written::files()); }

}  // namespace
}  // namespace claque::testing
