// Prepares templates in a folder of the test's own.
#pragma once

#include <claque/prepare.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace prepare_test
{

namespace fs = std::filesystem;
using Bytes = std::vector<char>;

inline Bytes read(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const fs::path &path, const Bytes &bytes)
{
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class Prepare : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("claque_prepare_") + test->name());
        fs::remove_all(folder_);
        const clq_context_def def = clq_context_def_init();
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_context_destroy(context_);
        fs::remove_all(folder_);
    }

    // The template's bytes and the message of the call.
    Bytes made(const clq_prepare_def &def, clq_prepare_report &report)
    {
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, &report), CLQ_OK) << clq_last_error();
        return tmpl ? saved(tmpl) : Bytes();
    }
    // Destroys the template.
    static Bytes saved(clq_template *tmpl)
    {
        Bytes bytes;
        const auto append = [](void *user, const void *more, size_t size) {
            auto *all = static_cast<Bytes *>(user);
            const char *first = static_cast<const char *>(more);
            all->insert(all->end(), first, first + size);
            return 0;
        };
        EXPECT_EQ(clq_template_save(tmpl, append, &bytes), CLQ_OK);
        clq_template_destroy(tmpl);
        return bytes;
    }
    clq_prepare_def owl()
    {
        clq_prepare_def def = clq_prepare_def_init();
        def.builtin = "owl";
        text_ = folder_.string();
        def.folder = text_.c_str();
        return def;
    }
    std::vector<fs::path> files() const
    {
        std::vector<fs::path> found;
        if (fs::exists(folder_))
            for (const auto &entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
        return found;
    }
    // A triangle whose numbers are in a file beside it.
    fs::path triangle() const
    {
        fs::create_directories(folder_ / "in");
        const float numbers[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const char *bytes = reinterpret_cast<const char *>(numbers);
        write(folder_ / "in" / "numbers.bin", Bytes(bytes, bytes + sizeof numbers));
        std::ofstream(folder_ / "in" / "triangle.gltf") << R"({"asset":{"version":"2.0"},"scene":0,
            "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "buffers":[{"uri":"numbers.bin","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
        return folder_ / "in" / "triangle.gltf";
    }

    fs::path folder_;
    std::string text_;
    clq_context *context_ = nullptr;
};

}  // namespace prepare_test
