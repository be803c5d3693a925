// Restores a crowd's state from bytes. Every rule of edits.h holds afterwards, whatever the bytes are.
#include "lib/crowd/restore.h"

#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"
#include "lib/crowd/save_check.h"

namespace claque::crowd
{

using base::fail;

namespace
{

void read_templates(Reader &in, Resolver &resolver, Tables &out)
{
    const uint32_t count = in.count(12);
    std::pmr::memory_resource *memory = out.templates.get_allocator().resource();
    std::pmr::string name(memory);
    out.templates.reserve(count);
    out.colours.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        in.text(name);
        uint64_t structure = 0;
        in.value(structure);
        const model::Template &tmpl = resolver.find_template(name, structure);
        out.templates.push_back(&tmpl);
        out.colours.emplace_back(memory, tmpl.zone_count());
    }
}

void read_groups(Reader &in, base::SlotMap<GroupRow> &out)
{
    const auto append = [&](uint32_t generation) { out.append(generation); };
    read_rows(in, "group", out, append, [&](uint32_t row) {
        walk_transform(in, out[row].transform);
        checked(out[row].transform);
        in.flag(out[row].enabled), in.value(out[row].speed);
        checked_speed(out[row].speed);
    });
}

void read_attached(Reader &in, Crowd &out)
{
    base::SlotMap<Attachment> &all = out.tables.extras.attached;
    const auto append = [&](uint32_t generation) { all.append(generation); };
    read_rows(in, "attached object", all, append, [&](uint32_t index) {
        Attachment read;
        walk_attached(in, read);
        if (read.row >= out.row_count() || !out.alive(read.row))
            fail(CLQ_FORMAT, "a saved crowd's attached object %u is of actor %u, which there is not", index, read.row);
        check_attached(out.template_of(read.row), read);
        all[index] = read;
        link_attached(make_extra(out.tables, read.row), all, index);
    });
}

// Compares what is written with what was read.
class ComparingSink : public base::Sink
{
public:
    ComparingSink(const uint8_t *wanted, size_t size) : wanted_(wanted), size_(size) {}
    void take(const uint8_t *bytes, size_t count) override
    {
        for (size_t i = 0; i < count; ++i, ++at_)
            if (at_ == size_ || bytes[i] != wanted_[at_])
                fail(CLQ_FORMAT, "byte %zu of the saved crowd is none that saving this crowd would write", at_);
    }
    bool complete() const { return at_ == size_; }

private:
    const uint8_t *wanted_;
    size_t size_, at_ = 0;
};

// Equal crowds have equal bytes, so bytes of a crowd that saves as others hold a state that no call leaves.
void require_same_bytes(const uint8_t *bytes, size_t size, const Crowd &restored)
{
    ComparingSink sink(bytes, size);
    save_contents(restored, sink);
    if (!sink.complete()) fail(CLQ_FORMAT, "the saved crowd has more bytes than saving this crowd would write");
}

}  // namespace

const model::Template *template_at(const Tables &tables, uint32_t index)
{
    if (index >= tables.templates.size())
        fail(CLQ_FORMAT, "a saved crowd names template %u, which does not exist: there are %zu", index,
             tables.templates.size());
    return tables.templates[index];
}

void restore(const uint8_t *bytes, size_t size, Resolver &resolver, Crowd &out)
{
    Reader in = base::open_file(save_form, bytes, size);
    in.value(out.tables.seed);
    read_templates(in, resolver, out.tables);
    read_behaviours(in, resolver, out.tables);
    try {
        read_layers(in, out.tables);
        read_groups(in, out.tables.groups.all);
        read_actors(in, out);
        read_attached(in, out);
    } catch (const Missing &) {
        throw;
    } catch (const base::Error &error) {
        if (error.status() == CLQ_FORMAT) throw;
        fail(CLQ_FORMAT, "the saved crowd is invalid: %s", error.what());  // a rule of the public calls
    }
    for (uint32_t row = 0; row < out.row_count(); ++row)
        if (out.alive(row)) measure(out, row);
    in.end();
    require_same_bytes(bytes + base::file_header_bytes, size - base::file_header_bytes, out);
}

}  // namespace claque::crowd
