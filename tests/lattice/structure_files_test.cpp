// SPDX-License-Identifier: MIT
#include "lattice/structure_files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "support/uses.h"

namespace stig {
namespace {

class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / "stig_structure_files_test") {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string written(const std::string& path, const Structure& structure) {
  std::string error;
  REQUIRE(write_structure_file(path, structure, numbered_bricks(3), {}, error));
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_CASE("every kind starts as it should") {
  const Folder folder;
  const Structure s = structure_literal("1 2\n---\n3 1");
  CHECK(written(folder / "s.txt", s) ==
        "// lattice: cubic\n// lowest corner: 0 0 0\n// bricks: 1 2 3\n1 2\n---\n3 1\n");
  CHECK(written(folder / "s.json", s).starts_with("{\"stigc_structure\": 1"));
  CHECK(written(folder / "s.vox", s).starts_with("VOX "));
  CHECK(written(folder / "s.stl", s).starts_with("stigc"));
  CHECK(written(folder / "s.ply", s).starts_with("ply\n"));
  CHECK(written(folder / "s.GLB", s).starts_with("glTF"));
  CHECK(written(folder / "s.png", s).starts_with("\x89PNG"));
  CHECK(written(folder / "s.svg", s).starts_with("<?xml"));
}

TEST_CASE("what is written is read back") {
  const Folder folder;
  const Structure s = structure_literal("1 2\n---\n3 1");
  for (const char* name : {"s.txt", "s.json", "s.vox"}) {
    written(folder / name, s);
    Diagnostics diagnostics;
    const auto loaded = read_structure_file(folder / name, {}, diagnostics);
    REQUIRE(loaded.has_value());
    CHECK(loaded->structure == s);
    CHECK(loaded->bricks.size() == 3);
  }
}

TEST_CASE("a byte order mark before a drawing does no harm") {
  const Folder folder;
  std::ofstream(folder / "marked.txt") << "\xEF\xBB\xBF"
                                       << "1 2\n";
  Diagnostics diagnostics;
  const auto loaded = read_structure_file(folder / "marked.txt", {}, diagnostics);
  REQUIRE(loaded.has_value());
  CHECK(loaded->structure == structure_literal("1 2"));
}

TEST_CASE("an unknown ending is refused, with the known ones") {
  std::string error;
  CHECK_FALSE(write_structure_file("s.obj", Structure(), {}, {}, error));
  CHECK(error ==
        "cannot write 's.obj': the ending must be one of .txt .json .vox .stl .ply .glb .png .svg");
  CHECK_FALSE(can_write_structure("folder.png/file", error));
  Diagnostics diagnostics;
  CHECK_FALSE(read_structure_file("s.stl", {}, diagnostics).has_value());
  CHECK(diagnostics.all().at(0).code == Code::F401);
}

TEST_CASE("a missing file is a diagnostic") {
  Diagnostics diagnostics;
  CHECK_FALSE(read_structure_file("/nowhere/s.vox", {}, diagnostics).has_value());
  CHECK(diagnostics.all().at(0).code == Code::R001);
}

TEST_CASE("a box too large for text is refused before it is drawn") {
  Structure s;
  s.place({0, 0, 0}, 1);
  s.place({kMaxCoordinate, kMaxCoordinate, kMaxCoordinate}, 1);
  std::string error;
  CHECK_FALSE(write_structure_file("s.txt", s, {}, {}, error));
  CHECK(error.find("too large") != std::string::npos);
}

TEST_CASE("a folder that is not there is an error, not a crash") {
  std::string error;
  CHECK_FALSE(write_structure_file("/nowhere/s.json", Structure(), {}, {}, error));
  CHECK(error.find("/nowhere") != std::string::npos);
}

}  // namespace
}  // namespace stig
