// A program of OpenSceneGraph with osgdb_claque in reach, and what its pictures show.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>
#include <osg/PositionAttitudeTransform>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgViewer/Viewer>

#include "samples/contexts/offscreen.h"
#include "tests/gl/support/absent.h"

namespace osg_plugin_test
{

constexpr int side_px = 256;

// A file of this text for the duration of a test.
class File
{
public:
    File(const std::string &name, const std::string &text)
        : path_(testing::TempDir() + std::to_string(getpid()) + "-" + name)
    {
        std::ofstream(path_) << text;
    }
    ~File() { std::filesystem::remove(path_); }
    const std::string &path() const { return path_; }

private:
    std::string path_;
};

inline osg::ref_ptr<osg::Node> read(const std::string &path) { return osgDB::readRefNodeFile(path); }

class OsgPlugin : public testing::Test
{
protected:
    void SetUp() override
    {
        osgDB::Registry::instance()->setLibraryFilePathList(std::string(PLUGIN_FOLDER));
        std::string why_not;
        context_ =
            contexts::make_offscreen(contexts::Kind::egl, side_px, side_px, contexts::PixelFormat::rgba8888, why_not);
        if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::egl, why_not);
        viewer_ = std::make_unique<osgViewer::Viewer>();
        viewer_->setThreadingModel(osgViewer::Viewer::SingleThreaded);
        viewer_->setUpViewerAsEmbeddedInWindow(0, 0, side_px, side_px);
        viewer_->setSceneData(root_);
        look_from({0, -9, 1.6}, {0, 0, 0.9});
    }

    void look_from(const osg::Vec3d &eye, const osg::Vec3d &at)
    {
        viewer_->getCamera()->setViewMatrixAsLookAt(eye, at, {0, 0, 1});
        viewer_->getCamera()->setProjectionMatrixAsPerspective(50, 1, 0.5, 100);
    }

    std::vector<uint8_t> picture(double time_s)
    {
        viewer_->frame(time_s);
        std::vector<uint8_t> rgb;
        context_->read_rgb(rgb);
        return rgb;
    }

    // A person at a place, as SUMO hangs them: a transform of each below the root, and one node for all.
    osg::PositionAttitudeTransform *stand(osg::Node &person, const osg::Vec3d &at)
    {
        osg::ref_ptr<osg::PositionAttitudeTransform> place = new osg::PositionAttitudeTransform;
        place->setPosition(at);
        place->addChild(&person);
        root_->addChild(place);
        return place;
    }

    osg::ref_ptr<osg::Node> citizen()
    {
        const File file("citizen.claque", "character = \"citizen\"\n");
        return read(file.path());
    }

    std::unique_ptr<contexts::Offscreen> context_;
    osg::ref_ptr<osg::Group> root_ = new osg::Group;
    std::unique_ptr<osgViewer::Viewer> viewer_;
};

// The pixels in columns [x0, x1) that are not the background's, which is that of the first pixel.
inline std::vector<uint8_t> people_in(const std::vector<uint8_t> &rgb, int x0, int x1)
{
    std::vector<uint8_t> out;
    for (int y = 0; y < side_px; ++y)
        for (int x = x0; x < x1; ++x) {
            const uint8_t *pixel = &rgb[3 * static_cast<size_t>(y * side_px + x)];
            if (!std::equal(pixel, pixel + 3, rgb.data())) out.insert(out.end(), pixel, pixel + 3);
        }
    return out;
}

// Pixels with a channel that differs by more than `by`.
inline size_t differing(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b, int by = 0)
{
    size_t count = 0;
    for (size_t i = 0; i < a.size(); i += 3)
        count += !std::equal(&a[i], &a[i] + 3, &b[i], [=](int p, int q) { return std::abs(p - q) <= by; });
    return count;
}

}  // namespace osg_plugin_test
