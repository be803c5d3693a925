// What the pixels of a film depend on besides its scene: the build, the GL, the processor, the driver's variables.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace cli
{

std::string sha256_of(const void *bytes, size_t size);
std::string sha256_of_file(const std::string &path);  // throws scenes::Failure
bool is_still(const std::string &path, const std::string &sha256);

// Restricts Mesa to what every x86-64 processor of the last fifteen years can do, so that it computes the same bits on
// all of them. To be called before any context is made. A value that the environment has already stays.
void use_portable_drivers();

// `gl`: what the context calls itself. Keys: build, gl, processor, drivers.
nlohmann::ordered_json provenance(const std::string &gl);

}  // namespace cli
