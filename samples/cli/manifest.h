// The manifest of a film, or of one job's share of it: which frames it has, the SHA-256 of each, and what their pixels
// depend on. It is written anew after each frame, whole or not at all, so that a job that was killed goes on where it
// stopped.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace cli
{

// "0-3,7": frames in the form in which schedulers take the indices of an array.
std::string array_words(const std::vector<int> &frames);

class Manifest
{
public:
    using Json = nlohmann::ordered_json;

    // `about`: what the frames depend on. Entries of an older manifest at `path` stay if its `about` is the same.
    // `out`: the pattern of the frames' files.
    Manifest(std::string path, Json about, const std::vector<int> &asked, const std::string &out);

    // Whether the frame has an entry, and its file is still what it was.
    bool has(int frame, const std::string &file) const;
    void add(int frame, const std::string &file);

private:
    void write() const;

    std::string path_;
    Json about_;
    std::string asked_, pattern_;
    struct Entry {
        std::string file, sha256;
    };
    std::map<int, Entry> entries_;
};

// What is wrong with the film whose manifests, all *.json that are such, lie in `folder`. `wanted`: the frames that it
// shall have; empty: those that its jobs were asked for.
struct FilmReport {
    size_t whole = 0;
    std::vector<int> missing;            // not drawn, gone, or changed since
    std::vector<std::string> sentences;  // all that is wrong
};
FilmReport check_film(const std::string &folder, const std::vector<int> &wanted);

}  // namespace cli
