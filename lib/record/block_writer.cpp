#include "lib/record/block_writer.h"

namespace claque::record
{

namespace
{

template <class T>
uint8_t *put(uint8_t *to, const T &v)
{
    base::Bits<T> bits;
    std::memcpy(&bits, &v, sizeof bits);
    for (size_t i = 0; i < sizeof bits; ++i) to[i] = static_cast<uint8_t>(uint64_t(bits) >> (8 * i));
    return to + sizeof bits;
}

}  // namespace

void BlockWriter::open(Kind kind)
{
    bytes_.insert(bytes_.end(), entry_header_bytes, 0);
    bytes_.back() = static_cast<uint8_t>(kind);
    if (is_call(kind)) ++calls_;
}

void BlockWriter::close(size_t begin)
{
    const uint64_t size = bytes_.size() - begin - sizeof(uint32_t);
    if (contents_size() > 0xffffffffu)
        base::fail(CLQ_LIMIT, "an entry of %llu bytes in a record: at most 4 GiB", base::big(size));
    put(bytes_.data() + begin, static_cast<uint32_t>(size));
}

void BlockWriter::transforms(const clq_actor *actors, const clq_transform *places, uint32_t count)
{
    const size_t begin = bytes_.size();
    open(Kind::crowd_set_transforms);
    const size_t first = bytes_.size();
    bytes_.resize(first + placed_bytes * count);
    uint8_t *to = bytes_.data() + first;
    for (uint32_t i = 0; i < count; ++i) {
        const clq_transform &place = places[i];
        to = put(put(to, actors[i].index1), actors[i].generation);
        for (int k = 0; k < 3; ++k) to = put(to, place.position[k]);
        for (int k = 0; k < 4; ++k) to = put(to, place.orientation_xyzw[k]);
        to = put(to, place.scale);
    }
    close(begin);
}

const model::Array<uint8_t> &BlockWriter::sealed()
{
    const uint32_t size = static_cast<uint32_t>(contents_size());
    const uint64_t checksum = checksum_of(bytes_.data() + block_header_bytes, size, number_);
    uint8_t *to = put(bytes_.data(), size);
    put(put(to, check_of_header(size, checksum, number_)), checksum);
    ++number_;
    return bytes_;
}

void BlockWriter::clear()
{
    bytes_.clear();
    bytes_.insert(bytes_.end(), block_header_bytes, 0);
}

}  // namespace claque::record
