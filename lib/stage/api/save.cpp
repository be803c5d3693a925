// Saving and restoring a stage. A file is: 8 bytes magic, u32 version, u64 size of the contents, u64 hash of them; then
// the fields of save/fields.h.
#include <claque/stage.h>

#include <algorithm>

#include "lib/stage/api/boundary.h"
#include "lib/stage/api/stage_handle.h"
#include "lib/stage/save/fields.h"

using namespace claque;
using stage::fail;

namespace
{

constexpr char magic[8] = {'c', 'l', 'q', 's', 't', 'a', 'g', 'e'};
constexpr uint32_t save_version = 3;
constexpr size_t head_bytes = 8 + 4 + 8 + 8;

uint64_t hash_of(const uint8_t *bytes, size_t size)
{
    uint64_t h = 0xcbf29ce484222325ULL;
    for (size_t i = 0; i < size; ++i) h = (h ^ bytes[i]) * 0x100000001b3ULL;
    return h;
}

std::vector<uint8_t> bytes_of(stage::SavedStage &&all)
{
    stage::SaveWriter contents, file;
    stage::fields(contents, all);
    file.bytes.assign(magic, magic + sizeof magic);
    file.number(save_version);
    file.number(uint64_t(contents.bytes.size()));
    file.number(hash_of(contents.bytes.data(), contents.bytes.size()));
    file.bytes.insert(file.bytes.end(), contents.bytes.begin(), contents.bytes.end());
    return std::move(file.bytes);
}

stage::SavedStage read_saved(const uint8_t *bytes, size_t size)
{
    if (size < head_bytes || std::memcmp(bytes, magic, sizeof magic) != 0) stage::bad_save("they do not begin as one");
    stage::SaveReader head(bytes + sizeof magic, head_bytes - sizeof magic);
    uint32_t version = 0;
    uint64_t length = 0, hash = 0;
    stage::numbers(head, version, length, hash);
    if (version != save_version) fail(CLQ_FORMAT, "a saved stage of version %u: %u is known", version, save_version);
    if (length != size - head_bytes) stage::bad_save("they are cut off or continued");
    if (hash != hash_of(bytes + head_bytes, size - head_bytes)) stage::bad_save("they have been changed");
    stage::SaveReader contents(bytes + head_bytes, size - head_bytes);
    stage::SavedStage all;
    stage::fields(contents, all);
    if (contents.left() > 0) stage::bad_save("more follows");
    return all;
}

}  // namespace

extern "C" {

clq_status clq_stage_save(const clq_stage *stage, clq_write_function write, void *user)
{
    return stage::boundary("clq_stage_save", [&] {
        stage::require(stage && write, "stage or write is NULL");
        if (!stage->director.is_between_ticks())
            fail(CLQ_BUSY, "the last step failed within a tick: step again before saving");
        const std::vector<uint8_t> bytes = bytes_of(stage::snapshot(stage->director, stage->shown));
        int refused = 0;
        try {
            stage::with_host_floats([&] { refused = write(user, bytes.data(), bytes.size()); });
        } catch (const std::exception &error) {
            fail(CLQ_CALLBACK, "the write function threw an exception: %.160s", error.what());
        } catch (...) {
            fail(CLQ_CALLBACK, "the write function threw an exception that is no std::exception");
        }
        if (refused) fail(CLQ_IO, "the writer refused %zu bytes of a saved stage", bytes.size());
    });
}

clq_status clq_stage_restore(clq_stage *stage, clq_crowd *crowd, const void *bytes, size_t size_bytes)
{
    return stage::boundary("clq_stage_restore", [&] {
        stage::require(stage && bytes, "stage or bytes is NULL");
        const stage::Deciding deciding(stage);
        const stage::Only only(stage->is_applying, "drawing flow");
        stage::SavedStage all = read_saved(static_cast<const uint8_t *>(bytes), size_bytes);
        if (all.made_of != stage::hash_of_parts(stage->director))
            fail(CLQ_ARGUMENT, "the saved stage had other settings, actions or machines than the %zu of this one",
                 stage->director.machines.size());
        stage::check_saved(all, stage->director);
        stage::put_back(std::move(all), stage->director, stage->shown, crowd);
    });
}

}  // extern "C"
