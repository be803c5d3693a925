// Colour maps as files: a saved map loads unchanged, and errors are reported by line and column.
#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests/api/colour_fixture.h"

namespace colours
{
namespace
{

using ColourFiles = Colours;

std::string saved(const clq_colour_map *map)
{
    std::string text;
    const auto take = [](void *to, const void *bytes, size_t count) {
        static_cast<std::string *>(to)->append(static_cast<const char *>(bytes), count);
        return 0;
    };
    EXPECT_EQ(clq_colour_map_save(map, take, &text), CLQ_OK) << clq_last_error();
    return text;
}

class Loaded
{
public:
    Loaded(clq_context *context, const std::string &text)
        : status(clq_colour_map_load(context, text.data(), text.size(), "f.toml", &map)), says(clq_last_error())
    {
    }
    ~Loaded() { clq_colour_map_destroy(map); }
    Loaded(const Loaded &) = delete;
    Loaded &operator=(const Loaded &) = delete;

    clq_colour_map *map = nullptr;
    clq_status status;
    std::string says;
};

const char whole[] = R"([[classes]]
name = "rich \"and\" poor"   # a comment
template = "strip"
[classes.zones]
zero = { hue = [190, 290.5], saturation = [0.1, 0.333], brightness = [0.5, 0.7], colour_space = "oklab" }
"zone \u00e9 \\" = { colour = "#8a3b12" }
two = { palette = [
    { colour = "#000000", weight = 5 },
    { hue = [340, 20], saturation = [0, 1], brightness = [0.25, 1] },
] }
one = { linked_to = "two", variation = 0.125 }

[[classes]]
name = "nobody"
)";

}  // namespace

TEST_F(ColourFiles, RoundTripByteForByte)
{
    const Loaded first(context_, whole);
    ASSERT_EQ(first.status, CLQ_OK) << first.says;
    const std::string once = saved(first.map);
    const Loaded second(context_, once);
    ASSERT_EQ(second.status, CLQ_OK) << second.says << once;
    EXPECT_EQ(saved(second.map), once);
    for (const char *part : {"\"rich \\\"and\\\" poor\"", "[0.1, 0.333]", "\"#8a3b12\"", "weight = 5",
                             "variation = 0.125", "linked_to = \"two\"", "\"oklab\"", "nobody"})
        EXPECT_NE(once.find(part), std::string::npos) << part << " in " << once;
    EXPECT_LT(once.find("zero"), once.find("two")) << "in the order of the file";
    EXPECT_LT(once.find("two ="), once.find("one ="));
}

// Random ranges whose numbers need all their digits.
TEST_F(ColourFiles, KeepEveryFloatToTheBit)
{
    uint32_t state = 12345;
    const auto next = [&] { return float((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f; };
    for (int round = 0; round < 40; ++round) {
        std::vector<clq_palette_entry> dyes(8);
        for (clq_palette_entry &entry : dyes) {
            entry = {{360 * next(), 360 * next(), next(), 0, next(), 0}, 1e-3f + 1e5f * next() * next()};
            entry.range.saturation_max = std::min(1.0f, entry.range.saturation_min + next());
            entry.range.brightness_max = std::min(1.0f, entry.range.brightness_min + next() * 1e-6f);
        }
        make({zone("one", dyes), linked_to("two", "one", next())});
        const Loaded back(context_, saved(map_));
        ASSERT_EQ(back.status, CLQ_OK) << back.says;
        clq_colour_map_def was = clq_colour_map_def_init(), is = was;
        ASSERT_EQ(clq_colour_map_get_def(map_, &was), CLQ_OK);
        ASSERT_EQ(clq_colour_map_get_def(back.map, &is), CLQ_OK);
        EXPECT_EQ(was.classes[0].zones[1].variation, is.classes[0].zones[1].variation);
        for (uint32_t i = 0; i < 8; ++i)
            EXPECT_EQ(std::memcmp(&was.classes[0].zones[0].palette[i], &is.classes[0].zones[0].palette[i],
                                  sizeof(clq_palette_entry)),
                      0)
                << i;
    }
}

TEST_F(ColourFiles, ColoursInHexadecimalAreUsedExactly)
{
    for (const char *hex : {"#000000", "#ffffff", "#8a3b12", "#010203", "#FE0001", "#7f7f80", "#12fe9c", "#9988f7"}) {
        const Loaded file(context_,
                          std::string("[[classes]]\nname = \"a\"\nzones.one = { colour = \"") + hex + "\" }\n");
        ASSERT_EQ(file.status, CLQ_OK) << file.says;
        clq_crowd *crowd = nullptr;
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        clq_actor actor;
        ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
        ASSERT_EQ(clq_crowd_randomise_colours(crowd, file.map, 0, &actor, 1), CLQ_OK) << clq_last_error();
        float rgb[3 * zone_count];
        ASSERT_EQ(clq_actor_get_colours(crowd, actor, rgb, zone_count), CLQ_OK);
        char got[8];
        const auto byte = [&](uint32_t k) { return unsigned(rgb[3 + k] * 255 + 0.5f); };
        std::snprintf(got, sizeof got, "#%02x%02x%02x", byte(0), byte(1), byte(2));
        std::string wanted = hex;
        for (char &c : wanted)
            if (c >= 'A' && c <= 'F') c = char(c - 'A' + 'a');
        EXPECT_EQ(got, wanted);
        clq_crowd_destroy(crowd);
    }
}

TEST_F(ColourFiles, ErrorsNameLineColumnAndRule)
{
    const std::string head = "[[classes]]\nname = \"a\"\n[classes.zones]\n";
    const std::string hsb = "hue = [0, 9], saturation = [0, 1], brightness = [0, 1]";
    const struct {
        std::string text;
        const char *place;
        std::vector<const char *> says;
    } cases[] = {
        {"", "line 1", {"[[classes]]"}},
        {"classes = 7\n", "line 1, column 11", {"not a list"}},
        {"classes = []\n", "line 1", {"0 classes", "1 to 256"}},
        {"[[classes]]\nname = \"a\"\ncolor = 1\n", "line 3, column 1", {"'color' is not known", "zones"}},
        {"[[classes]]\nname = 3\n", "line 2, column 8", {"'name' is not a string"}},
        {"[[classes]]\n", "line 1, column 1", {"no name"}},
        {"[[classes]]\nname = \"a\"\n[[classes]]\nname = \"a\"\n", "line 4, column 8", {"this name already"}},
        {head + "one = { hue = [0, 9 }\n", "line 4", {"not TOML"}},
        {head + "one = 4\n", "line 4, column 7", {"zone 'one' is not a table"}},
        {head + "one = { hue = [0, 400], saturation = [0, 1], brightness = [0, 1] }\n",
         "line 4, column 15",
         {"class 'a', zone 'one'", "hue is 0 to 400"}},
        {head + "one = { hue = [0, 9], saturation = [0.8, 0.1], brightness = [0, 1] }\n",
         "line 4, column 36",
         {"wrong way round"}},
        {head + "one = { hue = [0, 9], saturation = [0, 1] }\n", "line 4, column 7", {"lacks 'brightness'"}},
        {head + "one = { hue = [0], saturation = [0, 1], brightness = [0, 1] }\n", "line 4, column 15", {"[min, max]"}},
        {head + "one = { hue = [0, \"9\"], saturation = [0, 1], brightness = [0, 1] }\n",
         "line 4, column 19",
         {"not a number"}},
        {head + "one = { hue = [0, nan], saturation = [0, 1], brightness = [0, 1] }\n",
         "line 4, column 19",
         {"'hue' is not finite"}},
        {head + "one = { hue = [0, 1e300], saturation = [0, 1], brightness = [0, 1] }\n",
         "line 4, column 19",
         {"'hue' is too large"}},
        {head + "one = { hue = [0, 9007199254740993], saturation = [0, 1], brightness = [0, 1] }\n",
         "line 4, column 19",
         {"'hue' is 9007199254740993, a whole number that would be rounded"}},
        {head + "one = { colour = \"red\" }\n", "line 4, column 18", {"#8a3b12"}},
        {head + "one = { colour = \"#123456\", hue = [1, 2] }\n", "line 4, column 35", {"beside it"}},
        {head + "one = { " + hsb + ", colour_space = \"even\" }\n", "line 4, column 80", {"'even'", "hsb, oklab"}},
        {head + "\none = { palette = [\n{ colour = \"#123456\", weight = -2 } ] }\n",
         "line 6, column 32",
         {"weight is -2", "palette entry 1"}},
        {head + "one = { palette = [] }\n", "line 4, column 1", {"neither a palette entry"}},
        {head + "one = { linked_to = \"one\" }\n", "line 4, column 21", {"linked to itself"}},
        {head + "one = { linked_to = \"two\", variation = 3 }\n", "line 4, column 40", {"variation is 3"}},
        {head + "one = { " + hsb + " }\none = { " + hsb + " }\n", "line 5", {"not TOML", "one"}},
        {head + "one = { linked_to = \"a\\u0000b\" }\n", "line 4", {"zero byte"}},
        {head + "\"\" = { " + hsb + " }\n", "line 4, column 1", {"no name"}},
        {"\xff\xfe", "line 1", {"not TOML"}},
        {"x = " + std::string(2000, '['), "line 1", {"not TOML"}},
    };
    for (const auto &c : cases) {
        const Loaded file(context_, c.text);
        EXPECT_EQ(file.status, CLQ_FORMAT) << c.text;
        EXPECT_EQ(file.map, nullptr);
        EXPECT_NE(file.says.find(std::string("f.toml, ") + c.place), std::string::npos)
            << c.place << " wanted: " << file.says << "\n"
            << c.text;
        for (const char *word : c.says)
            EXPECT_NE(file.says.find(word), std::string::npos) << word << " in " << file.says;
        EXPECT_EQ(file.says.find('\n'), std::string::npos) << file.says;
    }
}

// Whatever a few bytes of a valid file become, the result is a map or an error message.
TEST_F(ColourFiles, DamagedOnesGiveAMapOrAnErrorMessage)
{
    uint64_t state = 99;
    const auto below = [&](size_t n) {
        return size_t((state = state * 6364136223846793005u + 1442695040888963407u) >> 33) % n;
    };
    int good = 0, refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string text = whole;
        for (size_t n = 1 + below(4); n > 0; --n) {
            const size_t at = below(text.size());
            if (below(3) == 0) text.erase(at, 1 + below(9));
            else text[at] = "0123456789-.e[]{}\",= \nabz\xc3\xff"[below(26)];
            if (text.empty()) text = "x";
        }
        const Loaded file(context_, text);
        ASSERT_TRUE(file.status == CLQ_OK || file.status == CLQ_FORMAT) << file.says;
        ASSERT_EQ(file.status == CLQ_OK, file.map != nullptr);
        if (file.status == CLQ_FORMAT) {
            ASSERT_NE(file.says.find("f.toml, line "), std::string::npos) << file.says;
        }
        ++(file.status == CLQ_OK ? good : refused);
    }
    EXPECT_GT(good, 100);
    EXPECT_GT(refused, 1000);
}

TEST_F(ColourFiles, FailuresToReadOrWriteAreReported)
{
    clq_colour_map *map = nullptr;
    EXPECT_EQ(clq_colour_map_load_file(context_, "/no/such/file.toml", &map), CLQ_IO);
    EXPECT_TRUE(mentions("/no/such/file.toml"));
    const std::string large((size_t(4) << 20) + 1, ' ');
    EXPECT_EQ(clq_colour_map_load(context_, large.data(), large.size(), nullptr, &map), CLQ_LIMIT);
    std::string deep = "\n\"a\"";
    for (int i = 0; i < 300000; ++i) deep += " . 'a'";
    EXPECT_EQ(clq_colour_map_load(context_, (deep + " = 1\n").data(), deep.size() + 5, nullptr, &map), CLQ_LIMIT);
    EXPECT_TRUE(mentions("line 2: a key has more than 16 parts")) << clq_last_error();
    const std::string stray = "# \u00DF\n\u00DF = 1\n";
    EXPECT_EQ(clq_colour_map_load(context_, stray.data(), stray.size(), nullptr, &map), CLQ_FORMAT);
    EXPECT_TRUE(mentions("line 2: not TOML: a letter outside of strings")) << clq_last_error();
    EXPECT_EQ(clq_colour_map_load(nullptr, "", 0, nullptr, &map), CLQ_ARGUMENT);
    EXPECT_EQ(clq_colour_map_load(context_, nullptr, 5, nullptr, &map), CLQ_ARGUMENT);
    EXPECT_EQ(map, nullptr);
    const std::vector<clq_palette_entry> entry = {{{0, 1, 0, 1, 0, 1}, 1}};
    make({zone("one", entry)});
    EXPECT_EQ(clq_colour_map_save(
                  map_, [](void *, const void *, size_t) { return 1; }, nullptr),
              CLQ_IO);
    EXPECT_EQ(clq_colour_map_save(
                  map_, [](void *, const void *, size_t) -> int { throw 3; }, nullptr),
              CLQ_CALLBACK);
    ASSERT_EQ(try_map({zone("one", entry)}, "no \xff utf"), CLQ_OK);
    EXPECT_EQ(clq_colour_map_save(
                  map_, [](void *, const void *, size_t) { return 0; }, nullptr),
              CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("UTF-8")) << clq_last_error();
}

// The colour map that comes with claque, and the place where the README says it is.
TEST_F(ColourFiles, TheBuiltInOneIsComplete)
{
    ASSERT_EQ(clq_colour_map_load_file(context_, CLAQUE_SOURCE_DIR "/samples/maps/roman-classes.toml", &map_), CLQ_OK)
        << clq_last_error();
    for (const char *name : {"decurions", "patricians", "plebeians"})
        EXPECT_NE(clq_colour_map_find(map_, name), CLQ_NONE);
}

}  // namespace colours
