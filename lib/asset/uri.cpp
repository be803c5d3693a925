#include "lib/asset/uri.h"

#include <algorithm>

#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr std::string_view scheme = "data:";

std::string shortened(std::string_view uri) { return std::string(uri.substr(0, 80)); }

int hex_of(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percent_decoded(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out.push_back(text[i]);
            continue;
        }
        const int high = i + 2 < text.size() ? hex_of(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? hex_of(text[i + 2]) : -1;
        if (high < 0 || low < 0) fail(CLQ_FORMAT, "URI '%s' has a broken percent code", shortened(text).c_str());
        out.push_back(static_cast<char>(16 * high + low));
        i += 2;
    }
    return out;
}

int base64_of(char c)
{
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::vector<uint8_t> base64_decoded(std::string_view text)
{
    if (text.size() % 4 != 0) fail(CLQ_FORMAT, "base64 data of %zu characters: not a multiple of 4", text.size());
    size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
    const size_t length = text.size() / 4 * 3 - padding;
    std::vector<uint8_t> out;
    out.reserve(length + 2);
    for (size_t i = 0; i < text.size(); i += 4) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 4; ++k) {
            const bool padded = i + k >= text.size() - padding;
            const int value = padded ? 0 : base64_of(text[i + k]);
            if (value < 0) fail(CLQ_FORMAT, "base64 data has a wrong character at place %zu", i + k);
            bits = bits << 6 | static_cast<uint32_t>(value);
        }
        out.push_back(static_cast<uint8_t>(bits >> 16));
        out.push_back(static_cast<uint8_t>(bits >> 8));
        out.push_back(static_cast<uint8_t>(bits));
    }
    out.resize(length);
    return out;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.substr(0, scheme.size()) == scheme; }

uint64_t data_uri_bound(std::string_view uri) { return uri.size(); }

std::vector<uint8_t> decode_data_uri(std::string_view uri)
{
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos) fail(CLQ_FORMAT, "data URI '%s' has no comma", shortened(uri).c_str());
    const std::string_view head = uri.substr(scheme.size(), comma - scheme.size()), body = uri.substr(comma + 1);
    if (head.find(";;") != std::string_view::npos)
        fail(CLQ_FORMAT, "data URI '%s' has an empty parameter", shortened(uri).c_str());
    constexpr std::string_view mark = ";base64";
    if (head.size() >= mark.size() && head.substr(head.size() - mark.size()) == mark) return base64_decoded(body);
    const std::string text = percent_decoded(body);
    return std::vector<uint8_t>(text.begin(), text.end());
}

std::string decode_relative_path(std::string_view uri)
{
    const std::string name = shortened(uri);
    const size_t colon = uri.find(':');
    if (colon != std::string_view::npos && colon < uri.find('/')) {
        if (colon == 0) fail(CLQ_FORMAT, "URI '%s' has an empty scheme", name.c_str());
        fail(CLQ_UNSUPPORTED, "URI '%s': only data URIs and files beside this one are read", name.c_str());
    }
    const std::string path = percent_decoded(uri);
    if (path.empty()) fail(CLQ_FORMAT, "a URI is empty");
    if (path[0] == '/') fail(CLQ_FORMAT, "URI '%s' is an absolute path", name.c_str());
    const bool odd = std::any_of(path.begin(), path.end(),
                                 [](char c) { return c == '\\' || static_cast<unsigned char>(c) < 32 || c == 127; });
    if (odd) fail(CLQ_FORMAT, "URI '%s' has a backslash or control character", name.c_str());
    for (size_t at = 0; at <= path.size();) {
        const size_t end = std::min(path.find('/', at), path.size());
        if (path.compare(at, end - at, "..") == 0) fail(CLQ_FORMAT, "URI '%s' leaves the folder", name.c_str());
        at = end + 1;
    }
    return path;
}

}  // namespace claque::asset
