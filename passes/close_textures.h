// Textures of single individuals near the eye: the colours of their zones are multiplied in, so that they can be
// filtered and need neither alpha test nor dirty triangles.
//
// Which individuals show one follows from the draw list alone: the nearest first, as many as the budget holds. Textures
// are kept from draw to draw and found by what they show, so what was drawn before changes the cost only. With
// RendererOptions::close_per_draw that does not hold: individuals then wait for theirs.
#pragma once

#include <unordered_map>

#include "lib/draw/draw_list.h"
#include "passes/preflight.h"
#include "passes/prepared.h"

namespace claque::passes
{

class CloseTextures
{
public:
    CloseTextures(std::pmr::memory_resource *memory, const RendererOptions &options)
        : options_(options),
          memory_(memory),
          slots_(memory),
          free_(memory),
          by_hash_(memory),
          wishes_(memory),
          picks_(memory),
          pending_(memory),
          first_name_(memory),
          names_(memory),
          rgb_(memory),
          pixels_(memory)
    {
    }

    // Chooses for a list and makes what is missing; the templates of all items that are drawn are prepared. Fails with
    // CLQ_GL_STATE or CLQ_OUT_OF_MEMORY (claque's) and has then made nothing. `left_out`: how many textures GL had no
    // memory for; their individuals show none.
    base::Status make(const Gl11 &gl, const Preflight &preflight, const Array<PreparedTemplate> &templates,
                      const draw::DrawList &list, uint32_t &left_out, DrawStats &stats);

    // Of the last list: GL names, one for each surface of the item's level, or null.
    const uint32_t *of(size_t item) const
    {
        return item < first_name_.size() && first_name_[item] != model::none ? &names_[first_name_[item]] : nullptr;
    }

    uint64_t held_bytes() const { return held_; }  // of GL's memory, by all textures that are kept

    void destroy(const Gl11 &gl);  // deletes all textures
    void forget();                 // for a lost context

private:
    // A texture and what it shows.
    struct Slot {
        explicit Slot(std::pmr::memory_resource *memory) : rgb(memory) {}
        const model::Template *source = nullptr;  // null: free
        uint32_t texture = 0, image = 0;
        Array<uint8_t> rgb;  // of the texture's zones, in the order of its keys
        uint64_t hash = 0, bytes = 0;
        uint64_t drawn = 0;  // the last draw that wanted it
        uint32_t name = 0;   // of GL; 0: not made
    };
    struct Wish {
        float distance_m;
        uint32_t item;
        bool operator<(const Wish &o) const
        {
            return distance_m != o.distance_m ? distance_m < o.distance_m : item < o.item;
        }
    };

    void find_wishes(const Array<PreparedTemplate> &templates, const draw::DrawList &list);
    void choose(const Array<PreparedTemplate> &templates, const draw::DrawList &list);
    void pick(const PreparedTemplate &prepared, const draw::Item &item);
    uint64_t new_bytes(size_t first_pick) const;
    uint32_t slot_for(const PreparedTemplate &prepared, const draw::Item &item, uint32_t texture);
    void drop(uint32_t slot);
    void drop_pending_from(size_t first);
    void make_room(const Gl11 &gl);
    uint32_t make_pending(const Gl11 &gl, const Array<PreparedTemplate> &templates);
    bool upload(const Gl11 &gl, const PreparedTemplate &prepared, Slot &slot);
    void name_items(const draw::DrawList &list);

    RendererOptions options_;
    std::pmr::memory_resource *memory_;
    Array<Slot> slots_;
    Array<uint32_t> free_;
    std::pmr::unordered_multimap<uint64_t, uint32_t> by_hash_;
    uint64_t held_ = 0, draw_ = 0;

    // Of one draw.
    Array<Wish> wishes_;
    Array<uint32_t> picks_;       // slots of the items that are chosen, one after the other
    Array<uint32_t> pending_;     // slots to be made, the nearest first
    Array<uint32_t> first_name_;  // per item: its first pick, or none
    Array<uint32_t> names_;       // as picks_
    Array<uint8_t> rgb_, pixels_;
};

}  // namespace claque::passes
