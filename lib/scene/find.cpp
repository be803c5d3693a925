// Questions without a place: by state, by category, in the host's order.
#include "lib/scene/candidates.h"

namespace claque::scene
{

namespace
{

// Takes rows in order.
struct List {
    const Asked &asked;
    clq_actor *out;
    uint32_t capacity, count = 0;
    void add(uint32_t row)
    {
        if (count < capacity) out[count] = id_of(asked.crowd, row);
        ++count;
    }
    void test(uint32_t row)
    {
        if (asked.effort) ++asked.effort->tested;
        if (asked.scene.matches(asked.crowd, row, asked.filter)) add(row);
    }
};

}  // namespace

uint32_t find(const Asked &asked, clq_actor *out, uint32_t capacity)
{
    const Scene &scene = asked.scene;
    List list{asked, out, capacity};
    if (scene.changes().everything) {
        for (uint32_t row = 0; row < asked.crowd.row_count(); ++row) list.test(row);
        return list.count;
    }
    // What is marked has to be put between the others: both are visited word by word.
    const Chosen chosen(scene, asked.crowd, asked.filter);
    const base::Bitmap &marked = scene.changes().rows;
    for (uint32_t k = 0; k < std::max(chosen.filled_count(), marked.filled_count()); ++k)
        for (uint64_t left = chosen.filled(k) | marked.filled(k); left != 0; left &= left - 1) {
            const uint32_t word = k * base::Bitmap::word_bits + base::lowest_bit(left);
            for (uint64_t rows = chosen.word(word) | marked.word(word); rows != 0; rows &= rows - 1) {
                const uint32_t row = word * base::Bitmap::word_bits + base::lowest_bit(rows);
                if (marked.has(row)) list.test(row);
                else list.add(row);
            }
        }
    return list.count;
}

uint32_t find_keys(const Asked &asked, double low, double high, clq_actor *out, uint32_t capacity)
{
    List list{asked, out, capacity};
    const Order &order = asked.scene.order();
    for (auto at = order.lower_bound({low, 0}); at != order.end() && at->key <= high; ++at) {
        if (asked.scene.knows(asked.crowd, at->row)) list.test(at->row);
    }
    return list.count;
}

bool next_in_order(const Asked &asked, uint32_t row, bool back, uint32_t &out)
{
    const Order &order = asked.scene.order();
    const double key = asked.scene.key_of(asked.crowd, row);
    auto at = std::isnan(key) ? order.end() : order.find({key, row});
    while (at != order.end()) {
        if (back && at == order.begin()) return false;
        if (back) --at;
        else if (++at == order.end()) return false;
        if (asked.effort) ++asked.effort->tested;
        if (!asked.scene.knows(asked.crowd, at->row)) continue;
        if (!asked.scene.matches(asked.crowd, at->row, asked.filter)) continue;
        out = at->row;
        return true;
    }
    return false;
}

}  // namespace claque::scene
