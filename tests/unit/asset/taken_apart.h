// A written character as JSON and the bytes of its buffer, to be changed and put together again.
#pragma once

#include "assets.h"

namespace claque::testing
{

class TakenApart
{
public:
    explicit TakenApart(const std::string &name) : is_glb_(std::filesystem::path(name).extension() == ".glb")
    {
        const Bytes bytes = read_asset(name);
        if (!is_glb_) {
            json = Json::parse(bytes);
            return;
        }
        const auto word_at = [&](size_t at) {
            uint32_t word = 0;
            std::memcpy(&word, bytes.data() + at, sizeof word);
            return static_cast<std::ptrdiff_t>(word);
        };
        const auto head = bytes.begin() + 20, body = head + word_at(12) + 8;
        json = Json::parse(head, body - 8);
        binary.assign(body, bytes.end());
    }

    Bytes bytes() const
    {
        const std::string head = json.dump();
        if (!is_glb_) return Bytes(head.begin(), head.end());
        Maker maker;
        maker.binary = binary;
        return maker.glb_of(head);
    }

    Json json;
    Bytes binary;  // of a GLB

private:
    bool is_glb_;
};

}  // namespace claque::testing
