// Reading OFF: triangles only, decimal text rounded once to the nearest double (strtod).
#pragma once
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Row = std::array<double, 3>;
using Face = std::array<std::size_t, 3>;

struct Mesh {
  std::vector<Row> points;
  std::vector<Face> faces;
};

// An input that cannot be used: one line on stderr, exit code 2.
[[noreturn]] inline void refuse(const std::string& text) {
  std::cerr << "error: " << text << '\n';
  std::exit(2);
}

class Words {
 public:
  explicit Words(const std::string& path) : path_(path) {
    std::ifstream in(path);
    if (!in) refuse(path + ": cannot be read");
    std::string line;
    while (std::getline(in, line)) {
      std::istringstream words(line.substr(0, line.find('#')));
      for (std::string word; words >> word;) words_.push_back(word);
    }
  }
  const std::string& next() {
    if (at_ >= words_.size()) refuse(path_ + ": ends too early");
    return words_[at_++];
  }
  std::size_t index() {
    const std::string& word = next();
    char* end = nullptr;
    const unsigned long long value = std::strtoull(word.c_str(), &end, 10);
    if (*end != '\0' || word[0] == '-') refuse(path_ + ": not an index: " + word);
    return value;
  }
  double coordinate() {
    const std::string& word = next();
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) refuse(path_ + ": not a finite number: " + word);
    return value;
  }
  std::size_t left() const { return words_.size() - at_; }

 private:
  std::string path_;
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

inline Mesh read_off(const std::string& path) {
  Words words(path);
  if (words.next() != "OFF") refuse(path + ": is not OFF");
  const std::size_t vertices = words.index(), faces = words.index();
  words.index();
  if (vertices > words.left() / 3 || faces > words.left() / 4) refuse(path + ": counts exceed the file");
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double x = words.coordinate(), y = words.coordinate(), z = words.coordinate();
    mesh.points.push_back({x, y, z});
  }
  for (std::size_t i = 0; i < faces; ++i) {
    if (words.index() != 3) refuse(path + ": a face is not a triangle");
    Face face;
    for (auto& v : face) {
      v = words.index();
      if (v >= vertices) refuse(path + ": an index is out of range");
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

// A shell as three meshes of one connectivity: bottom, middle, top.
struct Shell {
  std::array<std::vector<Row>, 3> layers;
  std::vector<Face> faces;

  bool pinched(std::size_t v) const { return layers[0][v] == layers[1][v] && layers[1][v] == layers[2][v]; }
};

inline Shell read_shell(char** paths) {
  Shell shell;
  for (int layer = 0; layer < 3; ++layer) {
    Mesh mesh = read_off(paths[layer]);
    if (layer > 0 && (mesh.faces != shell.faces || mesh.points.size() != shell.layers[0].size()))
      refuse(std::string(paths[layer]) + ": another connectivity");
    shell.layers[layer] = std::move(mesh.points);
    shell.faces = std::move(mesh.faces);
  }
  return shell;
}
