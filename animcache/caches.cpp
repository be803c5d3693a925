#include "animcache/caches.h"

namespace claque::animcache
{

namespace
{

// Tasks an update is cut into, whatever the number of threads.
constexpr uint32_t strands = 64;

// A strand's share of n, in order.
template <class Body>
void share(uint32_t n, uint32_t strand, const Body &body)
{
    const uint32_t first = static_cast<uint32_t>(uint64_t(n) * strand / strands);
    const uint32_t last = static_cast<uint32_t>(uint64_t(n) * (strand + 1) / strands);
    for (uint32_t i = first; i < last; ++i) body(i);
}

}  // namespace

Caches::Caches(std::pmr::memory_resource *memory, const Settings &settings)
    : memory_(memory),
      settings_(settings),
      requests_(memory),
      entries_(memory),
      animate_(memory),
      skin_(memory),
      victims_(memory),
      scratch_(memory, strands)
{
}

Caches::~Caches()
{
    for (Entry &entry : entries_) {
        release(entry, &Entry::palette);
        release(entry, &Entry::vertices);
    }
}

void Caches::reserve(uint32_t row_count, base::Span<const model::Template *const> templates)
{
    Sizes sizes;
    for (const model::Template *tmpl : templates) sizes.grow_to(sizes_of(*tmpl));
    scratch_.reserve(sizes);
    requests_.reserve(row_count);
    animate_.reserve(row_count);
    skin_.reserve(row_count);
    victims_.reserve(row_count);
    if (entries_.size() < row_count) entries_.resize(row_count);
}

void Caches::find_due()
{
    animate_.clear();
    skin_.clear();
    for (uint32_t i = 0; i < requests_.size(); ++i) {
        const Request &request = requests_[i];
        const Entry &entry = entries_[request.row];
        const bool palette_good = settings_.mode != Mode::none && entry.palette && entry.palette_key == request.pose;
        const bool vertices_good = settings_.mode == Mode::full && entry.vertices &&
                                   entry.vertices_key == request.pose && entry.vertices_level == request.level;
        if (palette_good) {
            ++counters_.palette_served;
        } else {
            ++counters_.due;
            if (entry.palette) animate_.push_back(i);
        }
        if (!entry.vertices) {
            ++counters_.on_demand;
        } else if (vertices_good) {
            ++counters_.vertices_served;
        } else {
            skin_.push_back(i);
        }
    }
}

void Caches::animate(const base::Jobs &jobs)
{
    jobs.for_each(strands, [this](uint32_t strand) {
        const Scratch scratch = scratch_.strand(strand);
        share(static_cast<uint32_t>(animate_.size()), strand, [&](uint32_t i) {
            const Request &request = requests_[animate_[i]];
            Entry &entry = entries_[request.row];
            animcache::animate(request, scratch, entry.palette);
            entry.palette_key = request.pose;
            entry.animated_at = serial_;
        });
    });
    counters_.animated = static_cast<uint32_t>(animate_.size());
}

void Caches::skin(const base::Jobs &jobs)
{
    jobs.for_each(strands, [this](uint32_t strand) {
        const Scratch scratch = scratch_.strand(strand);
        share(static_cast<uint32_t>(skin_.size()), strand, [&](uint32_t i) {
            const Request &request = requests_[skin_[i]];
            Entry &entry = entries_[request.row];
            animcache::skin(request, entry.palette, scratch, entry.vertices);
            entry.vertices_key = request.pose;
            entry.vertices_level = request.level;
        });
    });
    counters_.skinned = static_cast<uint32_t>(skin_.size());
}

draw::Vertices Caches::vertices_of(uint32_t row) const
{
    const Entry &entry = entries_[row];
    if (!entry.vertices) return {};
    return vertices_in(entry.vertices, entry.tmpl->levels[entry.vertices_level]);
}

}  // namespace claque::animcache
