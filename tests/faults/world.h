// One of everything that the C API can make, in memory that fails on request; and what a host can see of it.
#pragma once

#include <claque/assets.h>
#include <claque/claque.h>
#include <claque/colour_files.h>
#include <claque/levels.h>
#include <claque/prepare.h>
#include <claque/zones.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/api/busy_calls.h"

namespace faults
{

// Named hashes, one a line, so that a difference has a name.
std::string difference(const std::string &a, const std::string &b);  // "": none

class World
{
public:
    World();
    ~World();  // all of it is destroyed
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    std::string see();          // what is now
    std::string see_future();   // what updates and draws give from here
    void grow();                // by an actor, the one that calls then name
    uint32_t left_out() const;  // by the crowds' last updates

    // Made by a call that is tried; `untouched` until then.
    template <class T>
    T **out()
    {
        return reinterpret_cast<T **>(&made);
    }
    static void *const untouched;
    void *made = untouched;

    TestWorld test;
    busy::Objects objects;                                              // the crowd with everything
    clq_crowd *bare = nullptr, *key_posed = nullptr, *young = nullptr;  // without caches; with key-poses; never updated
    clq_view *bare_view = nullptr, *key_view = nullptr, *young_view = nullptr;
    clq_renderer *fresh = nullptr, *without_shadows = nullptr;  // without templates; prepared
    clq_renderer *close = nullptr;                              // prepared, with close textures
    clq_template *person_template = nullptr;
    std::vector<clq_actor> actors;
    clq_layer layer = {0};                            // of objects.actor
    bool sees_assets = false, builds_assets = false;  // which takes longer
    clq_asset *person = nullptr, *twin = nullptr, *shapes = nullptr, *walk = nullptr, *painted = nullptr;
    std::vector<unsigned char> file, toml, saved_crowd, saved_template, record;
    std::string folder;                      // of files
    uint32_t zone_image = 0, materials = 0;  // an image of `painted`; materials of `person`
    clq_status paint(clq_asset *asset, uint32_t image) const;
    uint64_t found = 0;  // hash of what the last call gave besides

private:
    void make_crowds();
    void make_renderers();
    void make_assets();
    clq_actor add_actor();
    void play_on(clq_actor actor);
    clq_crowd *crowd_of(clq_cache_mode cache, uint32_t key_pose_bands, clq_view **out_view, bool updated);

    int maker_;  // the process that removes the folder
};

// Of a crowd with everything, and of actors that come.
std::vector<unsigned char> recorded_run(TestWorld &test);

uint64_t hash_of(const void *bytes, size_t count);
uint64_t hash_of(const std::string &text);
uint64_t bytes_of(const clq_template *tmpl);  // hash of what clq_template_save writes
std::vector<unsigned char> read_bytes(const std::string &path);

}  // namespace faults
