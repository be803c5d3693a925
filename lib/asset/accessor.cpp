#include "lib/asset/accessor.h"

namespace claque::asset
{

using base::big;
using base::fail;

namespace
{

constexpr uint64_t max_bytes = 1ull << 48;

struct Type {
    const char *name;
    uint32_t width, columns;
};
constexpr Type types[] = {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1},
                          {"MAT2", 4, 2},   {"MAT3", 9, 3}, {"MAT4", 16, 4}};

Component component_of(const JsonView &view)
{
    const uint64_t code = view.integer(0, 0xffffffffu);
    for (const Component c :
         {Component::i8, Component::u8, Component::i16, Component::u16, Component::u32, Component::f32})
        if (static_cast<uint64_t>(c) == code) return c;
    return Component::unknown;
}

}  // namespace

uint32_t bytes_of(Component component)
{
    switch (component) {
        case Component::i8:
        case Component::u8:
            return 1;
        case Component::i16:
        case Component::u16:
            return 2;
        case Component::u32:
        case Component::f32:
            return 4;
        case Component::unknown:
            break;
    }
    return 0;
}

Accessors::Accessors(const JsonView &document, const Buffers &buffers, Budget &budget)
    : buffers_(buffers), budget_(budget)
{
    const JsonView list = document["accessors"];
    accessors_.reserve(list.count());
    for (size_t i = 0; i < list.count(); ++i) parse(list.at(i));
}

Accessors::Row Accessors::row_of(const Accessor &a, uint64_t count)
{
    const uint64_t unit = bytes_of(a.component), column = unit * (a.width / a.columns);
    if (a.columns == 1) return {count, column, column, unit};
    const uint64_t padded = (column + 3) / 4 * 4;
    return {count, padded * (a.columns - 1) + column, padded * a.columns, unit};
}

void Accessors::check_range(const Accessor &a, uint32_t view_index, uint64_t offset, const Row &row,
                            const char *what) const
{
    const BufferView &view = buffers_.view(view_index);
    const uint64_t stride = view.stride ? view.stride : row.stride;
    if (stride < row.bytes)
        fail(CLQ_FORMAT, "%s %s: elements of %llu bytes stand %llu apart", a.path.c_str(), what, big(row.bytes),
             big(stride));
    // No overflow: offset < 2^48, count < 2^32, stride < 2^8.
    const uint64_t end = offset + stride * (row.count - 1) + row.bytes;
    if (end > view.length)
        fail(CLQ_FORMAT, "%s %s: ends at byte %llu of buffer view %u, which has %llu", a.path.c_str(), what, big(end),
             view_index, big(view.length));
    if (offset % row.unit != 0 || (offset + view.offset) % row.unit != 0)
        fail(CLQ_FORMAT, "%s %s: starts at byte %llu of a view at byte %llu: not a multiple of %llu", a.path.c_str(),
             what, big(offset), big(view.offset), big(row.unit));
}

void Accessors::parse(const JsonView &view)
{
    Accessor out;
    out.path = view.path();
    const std::string &type = view["type"].text();
    for (const Type &known : types)
        if (type == known.name) out.width = known.width, out.columns = known.columns;
    out.component = component_of(view["componentType"]);
    out.count = static_cast<uint32_t>(view["count"].integer(1, 0xffffffffu));
    out.normalized = view["normalized"].boolean_or(false);
    if (out.normalized && (out.component == Component::f32 || out.component == Component::u32))
        fail(CLQ_FORMAT, "%s: floats and 32-bit integers cannot be normalized", out.path.c_str());
    out.view = view["bufferView"].index_or_none(buffers_.view_count(), "buffer view");
    out.offset = view["byteOffset"].integer_or(0, 0, max_bytes);
    const bool known = out.width != 0 && out.component != Component::unknown;
    if (out.columns > 1 && out.offset % 4 != 0)
        fail(CLQ_FORMAT, "%s: matrices start at byte %llu: not a multiple of 4", out.path.c_str(), big(out.offset));
    if (known && out.view != 0xffffffffu) check_range(out, out.view, out.offset, row_of(out, out.count), "values");
    if (view["sparse"].exists()) parse_sparse(view["sparse"], out);
    if (known && out.sparse.count)
        check_range(out, out.sparse.value_view, out.sparse.value_offset, row_of(out, out.sparse.count),
                    "sparse values");
    accessors_.push_back(std::move(out));
}

void Accessors::parse_sparse(const JsonView &view, Accessor &out) const
{
    Sparse &sparse = out.sparse;
    const JsonView indices = view["indices"], values = view["values"];
    sparse.count = static_cast<uint32_t>(view["count"].integer(1, out.count));
    sparse.index_view = indices["bufferView"].index(buffers_.view_count(), "buffer view");
    sparse.index_offset = indices["byteOffset"].integer_or(0, 0, max_bytes);
    sparse.index_type = component_of(indices["componentType"]);
    sparse.value_view = values["bufferView"].index(buffers_.view_count(), "buffer view");
    sparse.value_offset = values["byteOffset"].integer_or(0, 0, max_bytes);
    const Component t = sparse.index_type;
    if (t != Component::u8 && t != Component::u16 && t != Component::u32)
        fail(CLQ_FORMAT, "%s.indices.componentType is none of 5121, 5123 and 5125", view.path().c_str());
    if (buffers_.view(sparse.index_view).stride || buffers_.view(sparse.value_view).stride)
        fail(CLQ_FORMAT, "%s reads a buffer view with a byteStride", view.path().c_str());
    const uint64_t unit = bytes_of(t);
    check_range(out, sparse.index_view, sparse.index_offset, {sparse.count, unit, unit, unit}, "sparse indices");
}

bool Accessors::has_data(uint32_t index) const
{
    const Accessor &a = accessors_[index];
    const auto there = [&](uint32_t view) { return buffers_.has_data(view); };
    return (a.view == 0xffffffffu || there(a.view)) &&
           (a.sparse.count == 0 || (there(a.sparse.index_view) && there(a.sparse.value_view)));
}

const Accessor &Accessors::wanted(uint32_t index, uint32_t width, const std::string &needed_by) const
{
    const Accessor &a = accessors_[index];
    if (a.width != width || (a.columns > 1) != (width == 16) || a.component == Component::unknown)
        fail(CLQ_FORMAT, "%s needs elements of %u components: %s has others, or an unknown type", needed_by.c_str(),
             width, a.path.c_str());
    return a;
}

}  // namespace claque::asset
