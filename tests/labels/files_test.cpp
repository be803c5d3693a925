// The files of a picture: read back from their formats' descriptions, they hold what the labels say.
#include <cmath>
#include <cstring>

#include <png.h>

#include "samples/labels/collections.h"
#include "samples/labels/frame_files.h"
#include "samples/labels/rle.h"
#include "tests/labels/labelled.h"

namespace
{

using labels::Sample;

// A PNG as 16-bit numbers, whatever it has.
std::vector<uint16_t> png_values(const std::string &file, int &channels, int &bits)
{
    png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(reader);
    std::pair<const std::string *, size_t> at = {&file, 0};
    png_set_read_fn(reader, &at, [](png_structp png, png_bytep out, size_t size) {
        auto &from = *static_cast<std::pair<const std::string *, size_t> *>(png_get_io_ptr(png));
        std::memcpy(out, from.first->data() + from.second, size);
        from.second += size;
    });
    png_read_png(reader, info, PNG_TRANSFORM_IDENTITY, nullptr);
    channels = png_get_channels(reader, info), bits = png_get_bit_depth(reader, info);
    std::vector<uint16_t> out;
    png_bytepp rows = png_get_rows(reader, info);
    for (png_uint_32 y = 0; y < png_get_image_height(reader, info); ++y)
        for (png_uint_32 x = 0; x < png_get_image_width(reader, info) * static_cast<png_uint_32>(channels); ++x)
            out.push_back(bits == 16 ? static_cast<uint16_t>(rows[y][2 * x] << 8 | rows[y][2 * x + 1]) : rows[y][x]);
    png_destroy_read_struct(&reader, &info, nullptr);
    return out;
}

class FilesOfLabels : public labels_test::Labelled
{
protected:
    void SetUp() override
    {
        Labelled::SetUp();
        if (IsSkipped()) return;
        open("plaza", 30, 160, 120);
        sample_ = labeller_->label(12, 0.48);
        formats_ = {labels::format_names().begin(), labels::format_names().end()};
        for (const labels::FrameFile &file : labels::frame_files(sample_, formats_)) files_[file.path] = file.bytes;
    }

    Sample sample_;
    std::set<std::string> formats_;
    std::map<std::string, std::string> files_;
};

TEST_F(FilesOfLabels, HoldMiddleburysFlow)
{
    const std::string &file = files_.at("flow_forward/000012.flo");
    float magic = 0;
    int32_t size[2];
    std::memcpy(&magic, file.data(), 4), std::memcpy(size, file.data() + 4, 8);
    EXPECT_EQ(magic, 202021.25f);
    EXPECT_EQ(size[0], 160);
    EXPECT_EQ(size[1], 120);
    ASSERT_EQ(file.size(), 12 + sizeof(float) * sample_.forward.size());
    std::vector<float> flow(sample_.forward.size());
    std::memcpy(flow.data(), file.data() + 12, sizeof(float) * flow.size());
    for (size_t i = 0; i < flow.size(); ++i)
        if (std::isnan(sample_.forward[i])) ASSERT_GT(flow[i], 1e9f);
        else ASSERT_EQ(flow[i], sample_.forward[i]);
}

TEST_F(FilesOfLabels, HoldKittisFlowAndDepth)
{
    int channels = 0, bits = 0;
    const std::vector<uint16_t> flow = png_values(files_.at("flow_backward/000012.png"), channels, bits);
    ASSERT_EQ(channels, 3);
    ASSERT_EQ(bits, 16);
    for (size_t i = 0; i < sample_.actor.size(); ++i) {
        ASSERT_EQ(flow[3 * i + 2] == 1, !std::isnan(sample_.backward[2 * i]));
        if (flow[3 * i + 2] == 0) continue;
        for (size_t k = 0; k < 2; ++k)
            ASSERT_NEAR((flow[3 * i + k] - 32768) / 64.0, static_cast<double>(sample_.backward[2 * i + k]), 1.0 / 127);
    }
    const std::vector<uint16_t> depth = png_values(files_.at("depth/000012.png"), channels, bits);
    ASSERT_EQ(channels, 1);
    ASSERT_EQ(bits, 16);
    for (size_t i = 0; i < sample_.actor.size(); ++i)
        if (std::isnan(sample_.depth_m[i])) ASSERT_EQ(depth[i], 0);
        else ASSERT_NEAR(depth[i] / 256.0, static_cast<double>(sample_.depth_m[i]), 1.0 / 511);
}

TEST_F(FilesOfLabels, HoldNormals)
{
    int channels = 0, bits = 0;
    const std::vector<uint16_t> values = png_values(files_.at("normals/000012.png"), channels, bits);
    ASSERT_EQ(channels, 3);
    ASSERT_EQ(bits, 8);
    ASSERT_EQ(values.size(), sample_.normal.size());
    size_t shown = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        const bool is_there = !std::isnan(sample_.normal[i]);
        shown += is_there;
        ASSERT_NEAR(values[i], is_there ? 127.5 * (static_cast<double>(sample_.normal[i]) + 1) : 0, 0.51);
    }
    EXPECT_GT(shown, 1000u);
}

TEST_F(FilesOfLabels, HoldCocosMasksBoxesAndPanopticPictures)
{
    const std::vector<labels::Json> frames = {labels::frame_json(sample_)};
    std::map<std::string, std::string> all;
    for (const labels::FrameFile &file : labels::collections(frames, formats_, labels::coco_keypoints()))
        all[file.path] = file.bytes;
    const labels::Json coco = labels::Json::parse(all.at("coco.json")),
                       panoptic = labels::Json::parse(all.at("panoptic.json"));
    size_t shown = 0;
    for (const labels::Person &person : sample_.people) shown += person.visible_px > 0;
    ASSERT_EQ(coco["annotations"].size(), shown);
    ASSERT_GT(shown, 5u);
    for (const labels::Json &one : coco["annotations"]) {
        std::vector<uint8_t> inside;
        for (const uint32_t actor : sample_.actor) inside.push_back(actor == one["track_id"].get<uint32_t>());
        EXPECT_EQ(one["segmentation"]["counts"], labels::letters_of(labels::runs_of(inside, 160, 120)));
        EXPECT_EQ(one["keypoints"].size(), 51u);
        EXPECT_EQ(one["area"].get<size_t>(), static_cast<size_t>(std::count(inside.begin(), inside.end(), 1)));
    }
    int channels = 0, bits = 0;
    const std::vector<uint16_t> rgb = png_values(files_.at("panoptic/000012.png"), channels, bits);
    for (size_t i = 0; i < sample_.actor.size(); ++i)
        ASSERT_EQ(rgb[3 * i] + 256u * rgb[3 * i + 1] + 65536u * rgb[3 * i + 2], sample_.actor[i]);
    EXPECT_EQ(panoptic["annotations"][0]["segments_info"].size(), shown);
    // MOT's lines: frames and pixels from 1.
    const std::string &mot = all.at("mot/gt/gt.txt");
    EXPECT_EQ(mot.rfind("1,", 0), 0u);
    double least = 1;
    size_t lines = 0;
    for (size_t at = 0; at < mot.size(); at = mot.find('\n', at) + 1, ++lines)
        least = std::min(least, std::stod(mot.substr(mot.rfind(',', mot.find('\n', at)) + 1)));
    EXPECT_GE(lines, shown);
    EXPECT_LT(least, 1);
}

TEST_F(FilesOfLabels, HoldADensityWhoseSumIsTheNumberOfHeads)
{
    const std::string &file = files_.at("density/000012.npy");
    std::vector<float> values(sample_.actor.size());
    std::memcpy(values.data(), file.data() + file.size() - sizeof(float) * values.size(),
                sizeof(float) * values.size());
    double sum = 0, heads = 0;
    for (const float value : values) sum += static_cast<double>(value);
    for (const labels::Person &person : sample_.people)
        heads += person.head.seen == labels::Seen::visible || person.head.seen == labels::Seen::hidden;
    EXPECT_GT(heads, 5);
    EXPECT_NEAR(sum, heads, 1e-3);
}

TEST(FormatsOfLabels, AreRefusedByName)
{
    EXPECT_EQ(labels::read_formats("coco,flo").size(), 2u);
    try {
        labels::read_formats("coco,yolo");
        FAIL();
    } catch (const scenes::Failure &failure) {
        EXPECT_NE(std::string(failure.what()).find("no format 'yolo' of labels; there are coco, panoptic"),
                  std::string::npos)
            << failure.what();
    }
}

}  // namespace
