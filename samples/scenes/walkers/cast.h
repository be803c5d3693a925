// The characters of a scene of walkers: templates with their locomotion.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/check.h"
#include "samples/scenes/library.h"
#include "samples/scenes/scene_crowd.h"
#include "samples/scenes/social_classes.h"
#include "samples/scenes/walkers/gaits.h"

namespace scenes::walkers
{

struct DestroyWalk {
    void operator()(clq_locomotion *p) const { clq_locomotion_destroy(p); }
    void operator()(clq_track *p) const { clq_track_destroy(p); }
};
using OwnLocomotion = std::unique_ptr<clq_locomotion, DestroyWalk>;
using OwnTrack = std::unique_ptr<clq_track, DestroyWalk>;

struct Member {
    SocialClass described;
    Own<clq_template> own;  // of a file; built-in people belong to the library
    clq_template *tmpl = nullptr;
    OwnLocomotion locomotion;
    double scale = 1;  // to the size of a person, unless the class has a size of its own
};

// A class of its own for a character.
SocialClass class_of(const std::string &character);

// Whether a built-in person can turn its head to what it looks at. A character of a file can if the file says so.
enum class Heads : uint8_t { still, turn };

// The template of a class whose character is a file.
Own<clq_template> template_of_file(Library &library, const SocialClass &one);

// Its template: a built-in character or a file.
void take_template(Library &library, Member &member, Lod lod, Heads heads = Heads::still);

// Its gaits (gaits.h), measured.
OwnLocomotion locomotion_of(Library &library, const Member &member);

// Its template and its locomotion.
Member cast(Library &library, const SocialClass &described, Lod lod, Heads heads = Heads::still);

}  // namespace scenes::walkers
