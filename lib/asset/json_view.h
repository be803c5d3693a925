// Checked access to the JSON of a glTF file. Every read states what it expects, and an error names the position in the
// file, such as 'animations[3].channels[0].target.node'.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "lib/base/error.h"

namespace claque::asset
{

// Points into a parsed document, which must outlive it. A view may be of an absent value: exists() is then false, and a
// read fails as a missing property. All reads throw base::Error (CLQ_FORMAT).
class JsonView
{
public:
    JsonView() = default;
    JsonView(const nlohmann::json *value, std::string path) : value_(value), path_(std::move(path)) {}

    bool exists() const { return value_ != nullptr; }
    bool is_object() const { return value_ && value_->is_object(); }
    const std::string &path() const { return path_; }

    // A member of an object; absent if the object has no such member or is itself absent.
    JsonView operator[](const char *key) const;

    // The number of elements of an array; 0 if it is absent.
    size_t count() const;
    JsonView at(size_t index) const;

    const nlohmann::json &object() const;  // fails unless it is an object
    const std::string &text() const;
    bool boolean() const;
    double number() const;
    float real() const;                                     // a number that fits a float
    uint64_t integer(uint64_t first, uint64_t last) const;  // a whole number in [first, last]
    uint32_t index(size_t count, const char *what) const;   // a whole number below count: a reference to a `what`
    void numbers(float *out, size_t count) const;           // an array of exactly `count` numbers

    // The same with a default for an absent value.
    std::string text_or(const char *otherwise) const { return exists() ? text() : otherwise; }
    bool boolean_or(bool otherwise) const { return exists() ? boolean() : otherwise; }
    float real_or(float otherwise) const { return exists() ? real() : otherwise; }
    uint64_t integer_or(uint64_t otherwise, uint64_t first, uint64_t last) const
    {
        return exists() ? integer(first, last) : otherwise;
    }
    uint32_t index_or_none(size_t count, const char *what) const { return exists() ? index(count, what) : 0xffffffffu; }

private:
    const nlohmann::json &value() const;
    [[noreturn]] void refuse(const char *expected) const;

    const nlohmann::json *value_ = nullptr;
    std::string path_;
};

// A parsed text. Its destructor frees leaves first and allocates nothing; nlohmann's own allocates and would end the
// process when memory has run out.
class JsonDocument
{
public:
    // Scans the bytes before parsing: nesting at most 128 deep, and an estimate of the parsed size within
    // `memory_bytes`, so that the parser never needs more. Throws base::Error (CLQ_FORMAT, CLQ_LIMIT).
    JsonDocument(const uint8_t *bytes, size_t size, uint64_t memory_bytes);
    ~JsonDocument();
    JsonDocument(const JsonDocument &) = delete;
    JsonDocument &operator=(const JsonDocument &) = delete;

    JsonView root() const { return JsonView(&root_, ""); }

private:
    nlohmann::json root_;
};

}  // namespace claque::asset
