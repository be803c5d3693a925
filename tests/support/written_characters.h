// Small characters that tests write themselves: every way that glTF has of saying a shape, a skeleton and a motion, so
// that the laws of readers run in a checkout without ../shared/assets. The same bytes on every machine.
#pragma once

#include <string>
#include <vector>

namespace written
{

// WrittenPerson.glb     skinned; mask and both sides; rigid parts on a joint; linear, spline and step clips
// WrittenRigid.glb      no skin: a mesh on many nodes, matrices, mirrored scales, animated scale
// WrittenMorph.gltf     morph targets with normals, weights of mesh and of nodes; everything in data URIs
// WrittenSkins.glb      three skins, eight influences, 16-bit joints and weights, a skin without inverse binds
// WrittenSparse.gltf    sparse positions, weights, targets and keys; buffer and image in files of their own
// WrittenQuantised.glb  KHR_mesh_quantization, interleaved; normalized weights and rotations
// WrittenOdd.gltf       sheared, mirrored and flattened transforms; strips, fans, no indices; two scenes
// WrittenClips.glb      bones and clips of the person, no mesh
// WrittenLines.gltf     points and lines alone
//
// To be refused: WrittenRequires.glb requires an extension that claque does not know; the sparse indices of
// WrittenRepeats.glb repeat.

std::vector<std::string> files();       // all that load
std::vector<std::string> characters();  // those with triangles
std::vector<std::string> people();      // those that are people
std::vector<std::string> refused();

bool is_written(const std::string &name);

// Folder of the build where they lie, with a slash behind it, beside WrittenWalk.bvh and inventory.json, which says
// what each must load as, in the form of ../shared/assets/inventory.json. The first call in a process writes them.
const std::string &folder();

// A file of folder(), or the file of this name below the folder `collected`.
std::string path_of(const std::string &name, const std::string &collected);

// The file's name without its ending, as names of test cases must be.
std::string case_name(const std::string &name);

}  // namespace written
