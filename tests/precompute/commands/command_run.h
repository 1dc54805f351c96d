// Runs the built command as a person would, in a folder of its own, on a small room made here.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#ifndef FIATLUX_BINARY  // for tools that read this without the build's settings
#define FIATLUX_BINARY "fiatlux"
#endif

namespace fiatlux {

/// A folder that vanishes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fiatlux-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }

 private:
  std::string path_;
};

struct CommandRun {
  int status = -1;  // exit status, or -signal
  std::string out, err;
};

inline std::string textOfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void writeTextFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Runs a shell line in which $FIATLUX is the command, inside `folder`.
inline CommandRun runShell(const TemporaryFolder& folder, const std::string& line) {
  static int runs = 0;
  const std::string base = std::filesystem::temp_directory_path().string() + "/fiatlux-run-" +
                           std::to_string(::getpid()) + "-" + std::to_string(runs++);
  const std::string shell = "cd '" + folder.path() + "' && FIATLUX='" FIATLUX_BINARY "'; { " + line +
                            "\n} >" + base + ".out 2>" + base + ".err";
  const int status = std::system(shell.c_str());
  CommandRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), textOfFile(base + ".out"),
                 textOfFile(base + ".err")};
  std::filesystem::remove(base + ".out");
  std::filesystem::remove(base + ".err");
  return run;
}

inline CommandRun runFiatlux(const TemporaryFolder& folder, const std::string& arguments) {
  return runShell(folder, "\"$FIATLUX\" " + arguments);
}

/// A 4 x 3 x 3 m box seen from inside as a .gltf with its .bin: nodes floor, ceiling (the mount), wall 1..4;
/// where asked a "plane" in it, 1 m up, for --measure.
inline void writeBoxRoom(const TemporaryFolder& folder, const std::string& name, bool mount = true,
                         bool plane = false) {
  using Point = std::array<float, 3>;
  const float x = 4, y = 3, z = 3;
  const int count = plane ? 7 : 6;
  const std::array<std::array<Point, 4>, 7> quads = {
      {{{{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}}},
       {{{0, y, 0}, {x, y, 0}, {x, y, z}, {0, y, z}}},
       {{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}},
       {{{x, 0, z}, {0, 0, z}, {0, y, z}, {x, y, z}}},
       {{{0, 0, z}, {0, 0, 0}, {0, y, 0}, {0, y, z}}},
       {{{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}},
       {{{.5, 1, .5}, {.5, 1, 2.5}, {3.5, 1, 2.5}, {3.5, 1, .5}}}}};
  const char* names[] = {"floor", "ceiling", "wall 1", "wall 2", "wall 3", "wall 4", "plane"};
  std::string bin, nodes, list, meshes, accessors, views;
  for (int i = 0; i < count; ++i) {
    const std::string comma = i > 0 ? "," : "";
    Point low = quads[i][0], high = low;
    for (int triangle : {0, 1, 2, 0, 2, 3}) {
      const Point& p = quads[i][triangle];
      bin.append(reinterpret_cast<const char*>(p.data()), 12);
      for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], p[c]), high[c] = std::max(high[c], p[c]);
    }
    const auto point = [](const Point& p) {
      return "[" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + "]";
    };
    const std::string number = std::to_string(i);
    nodes += comma + R"({"mesh":)" + number + R"(,"name":")" + names[i] + "\"" +
             (i == 1 && mount ? R"(,"extras":{"fiatlux":{"mount":true,"siteSpacing":1}})" : "") + "}";
    list += comma + number;
    meshes += comma + R"({"primitives":[{"attributes":{"POSITION":)" + number + R"(},"material":0}]})";
    accessors += comma + R"({"bufferView":)" + number +
                 R"(,"componentType":5126,"count":6,"type":"VEC3","min":)" + point(low) + R"(,"max":)" +
                 point(high) + "}";
    views += comma + R"({"buffer":0,"byteLength":72,"byteOffset":)" + std::to_string(72 * i) + "}";
  }
  writeTextFile(folder / (name + ".bin"), bin);
  writeTextFile(folder / (name + ".gltf"),
                R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + list + R"(]}],"nodes":[)" +
                    nodes + R"(],"meshes":[)" + meshes + R"(],"accessors":[)" + accessors +
                    R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":)" +
                    std::to_string(72 * count) + R"(,"uri":")" + name +
                    R"(.bin"}],"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1]}}]})");
}

}  // namespace fiatlux
