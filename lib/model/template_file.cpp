#include "lib/model/template_file.h"

#include <cstring>
#include <type_traits>

#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/model/template_check.h"
#include "lib/model/template_fields.h"

namespace claque::model
{

using base::fail;

namespace
{

constexpr uint8_t magic[8] = {'c', 'l', 'a', 'q', 'u', 'e', 'T', 0x1a};
constexpr size_t header_bytes = 32;

// The unsigned integer type with the size of T.
template <class T>
using Bits = std::conditional_t<
    sizeof(T) == 1, uint8_t,
    std::conditional_t<sizeof(T) == 2, uint16_t, std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>>;

class Writer
{
public:
    explicit Writer(std::pmr::vector<uint8_t> &out) : out_(out) {}

    template <class T>
    void value(const T &v)
    {
        Bits<T> bits;
        std::memcpy(&bits, &v, sizeof bits);
        for (size_t i = 0; i < sizeof bits; ++i) out_.push_back(static_cast<uint8_t>(uint64_t(bits) >> (8 * i)));
    }
    void flag(bool v) { value(static_cast<uint8_t>(v)); }
    template <class S>
    void text(const S &s)
    {
        value(uint64_t(s.size()));
        for (const char c : s) value(c);
    }
    template <class A, class Element>
    void array(const A &values, uint64_t, const Element &element)
    {
        value(uint64_t(values.size()));
        for (const auto &v : values) element(v);
    }
    template <class A, class Element>
    void rows(const A &values, uint64_t smallest, const Element &element)
    {
        array(values, smallest, element);
    }

private:
    std::pmr::vector<uint8_t> &out_;
};

class Reader
{
public:
    Reader(const uint8_t *bytes, size_t size) : at_(bytes), left_(size) {}

    template <class T>
    void value(T &v)
    {
        if (left_ < sizeof v) fail(CLQ_FORMAT, "a prepared template ends %zu bytes too early", sizeof v - left_);
        uint64_t bits = 0;
        for (size_t i = 0; i < sizeof v; ++i) bits |= uint64_t(at_[i]) << (8 * i);
        const Bits<T> narrow = static_cast<Bits<T>>(bits);
        std::memcpy(&v, &narrow, sizeof v);
        at_ += sizeof v, left_ -= sizeof v;
    }
    void flag(bool &v)
    {
        uint8_t byte = 0;
        value(byte);
        if (byte > 1) fail(CLQ_FORMAT, "a prepared template holds %u where yes or no is due", byte);
        v = byte == 1;
    }
    template <class S>
    void text(S &s)
    {
        const size_t size = count(1);
        s.assign(reinterpret_cast<const char *>(at_), size);
        at_ += size, left_ -= size;
    }
    template <class A, class Element>
    void array(A &values, uint64_t smallest, const Element &element)
    {
        values.resize(count(smallest));
        for (auto &v : values) element(v);
    }
    // For elements that are constructed with the array's memory resource.
    template <class A, class Element>
    void rows(A &values, uint64_t smallest, const Element &element)
    {
        const size_t size = count(smallest);
        values.reserve(size);
        for (size_t i = 0; i < size; ++i) {
            values.emplace_back(values.get_allocator().resource());
            element(values.back());
        }
    }
    size_t left() const { return left_; }

private:
    // A length; the remaining bytes must be able to hold that many elements of this size.
    size_t count(uint64_t smallest)
    {
        uint64_t n = 0;
        value(n);
        if (n > left_ / smallest)
            fail(CLQ_FORMAT, "a prepared template announces %llu elements in %zu bytes",
                 static_cast<unsigned long long>(n), left_);
        return static_cast<size_t>(n);
    }
    const uint8_t *at_;
    size_t left_;
};

void check_header(const uint8_t *bytes, size_t size)
{
    if (size < header_bytes || std::memcmp(bytes, magic, sizeof magic) != 0)
        fail(CLQ_FORMAT, "%zu bytes that are not a prepared template", size);
    Reader header(bytes + sizeof magic, header_bytes - sizeof magic);
    uint32_t version = 0, zero = 0;
    uint64_t payload = 0, hash = 0;
    header.value(version), header.value(zero), header.value(payload), header.value(hash);
    if (version != template_file_version)
        fail(CLQ_FORMAT, "a prepared template of version %u: this library reads version %u; make it anew", version,
             template_file_version);
    if (zero != 0 || payload != size - header_bytes)
        fail(CLQ_FORMAT, "a prepared template of %llu bytes is %zu bytes long",
             static_cast<unsigned long long>(payload), size - header_bytes);
    if (hash != base::fnv(base::fnv_start, bytes + header_bytes, payload))
        fail(CLQ_FORMAT, "a prepared template has been changed since it was saved: its hash differs");
}

}  // namespace

void save(const Template &tmpl, std::pmr::vector<uint8_t> &out)
{
    const size_t start = out.size();
    Writer writer(out);
    for (const uint8_t byte : magic) writer.value(byte);
    writer.value(template_file_version), writer.value(uint32_t(0));
    const size_t lengths = out.size();
    writer.value(uint64_t(0)), writer.value(uint64_t(0));
    walk_template(writer, tmpl);

    const uint64_t payload = out.size() - start - header_bytes;
    const uint64_t hash = base::fnv(base::fnv_start, out.data() + start + header_bytes, payload);
    for (size_t i = 0; i < 8; ++i) {
        out[lengths + i] = static_cast<uint8_t>(payload >> (8 * i));
        out[lengths + 8 + i] = static_cast<uint8_t>(hash >> (8 * i));
    }
}

void load(const uint8_t *bytes, size_t size, Template &out)
{
    check_header(bytes, size);
    Reader reader(bytes + header_bytes, size - header_bytes);
    walk_template(reader, out);
    if (reader.left() != 0) fail(CLQ_FORMAT, "a prepared template has %zu bytes too many", reader.left());
    try {
        check(out);
    } catch (const base::Error &error) {
        fail(CLQ_FORMAT, "a prepared template is no template: %s", error.what());
    }
    if (!out.motion.empty()) derive(out.rig, out.motion);
    for (Level &level : out.levels) plan_skinning(level);
}

}  // namespace claque::model
