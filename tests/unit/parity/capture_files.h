// A small result as docs/parity.md describes it, in a folder that is deleted afterwards.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace parity_test
{

// NumPy's format 1.0. The shape is as Python writes it: "2, 3" or "4,".
std::string npy(const std::string &type, const std::string &shape, const void *values, size_t bytes);

template <class Value>
std::string npy(const std::string &type, const std::string &shape, const std::vector<Value> &values)
{
    return npy(type, shape, values.data(), values.size() * sizeof(Value));
}

class CaptureFiles : public testing::Test
{
protected:
    CaptureFiles();
    ~CaptureFiles() override;

    std::string folder(const std::string &name) const { return (root_ / name).string(); }
    void write(const std::string &name, const std::string &file, const std::string &bytes) const;
    void remove(const std::string &name, const std::string &file) const;
    // Replaces text in a file of that folder; fails the test if the text is missing.
    void replace(const std::string &name, const std::string &file, const std::string &from,
                 const std::string &to) const;

    // Three individuals, two meshes, a picture of 16 x 12: actor 2 covers columns 2 to 6, actor 5 covers 8 to 13, actor
    // 6 is not visible.
    void write_result(const std::string &name) const;

private:
    std::filesystem::path root_;
};

constexpr int width = 16, height = 12;
constexpr size_t vertices = 3 + 3 + 4;

std::string numbers(const std::vector<uint32_t> &table, size_t columns);

}  // namespace parity_test
