// Common parts of the scenes of claque_bits: hashes of values from the C API, and lines with their names. A scene
// computes nothing with the C library's functions, so that a line differs only where claque does.
#pragma once

#include <claque/assets.h>
#include <claque/drawn_actor.h>

#include <string>
#include <utility>
#include <vector>

namespace bits
{

// Ends the program with the last error unless the call succeeded.
void check(clq_status status);

class Hash
{
public:
    void add(const void *bytes, size_t size_bytes);
    void add(uint64_t number) { add(&number, sizeof number); }
    template <class T>
    void add(const std::vector<T> &values)
    {
        add(values.data(), values.size() * sizeof(T));
    }
    uint64_t value() const { return value_; }
    // For clq_template_save and its like, with a Hash as the user's pointer.
    static int write(void *hash, const void *bytes, size_t size_bytes);

private:
    uint64_t value_ = 14695981039346656037u;
};

void print(const std::string &name, const Hash &hash);

extern const std::vector<const char *> people;  // the four built-in ones

clq_template *built(clq_context *context, const char *name);  // without levels that it does not bring itself
clq_camera camera_at(const double eye[3], const double target[3]);
// The lists, palettes and vertices of a view.
struct Seen {
    Hash list, palettes, vertices;
    void add(const clq_view *view, bool with_palettes);
};

// Callbacks run under the settings of the host, which may be any.
class OwnFloats
{
public:
    OwnFloats() { clq_floats_enter(); }
    ~OwnFloats() { clq_floats_leave(); }
};

// Prints the sections that are named, or all. Returns an exit status.
int print_sections(const clq_context_def *def, char **first, char **last);

void levels(clq_context *context);      // levels of detail of the people
void templates(clq_context *context);   // as prepared, with clips of other skeletons
void crowds(clq_context *context);      // posed, skinned and listed with each instruction set; key-poses
void mechanisms(clq_context *context);  // gaze, flight, ground
void files(clq_context *context);       // trajectories and areas
void tracks(clq_context *context);
void stage(clq_context *context);  // agents that decide and walk

}  // namespace bits
