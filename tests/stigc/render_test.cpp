// SPDX-License-Identifier: MIT
// Pictures and films, with ffmpeg and without.
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>

#include "program.h"
#include "support/glb.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

using Size = std::pair<std::uint32_t, std::uint32_t>;

/// Of a .png, as its header has it.
Size size_of(const std::string& png) {
  REQUIRE(png.starts_with("\x89PNG"));
  const auto word = [&](std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4; ++i) out = out << 8U | static_cast<unsigned char>(png[at + i]);
    return out;
  };
  return {word(16), word(20)};
}

void make_runs(const Workplace& place) {
  REQUIRE(place
              .shell("stigc explore sets/line.yaml -q --trace line.stigt > /dev/null; "
                     "stigc explore sets/sheet.yaml -q --motion event --deposits 30 --trace "
                     "sheet.stigt -o sheet.txt > /dev/null; "
                     "stigc simulate sets/fall.yaml -q --duration 0.2 --trace fall.stigp")
              .exit_code == 0);
}

/// Without ffmpeg and everything else.
constexpr const char* kNoFfmpeg = "PATH=/nonexistent ";

TEST_CASE("a film's frames all have one size, whatever is in them, and a list of their times") {
  const Workplace place;
  make_runs(place);
  for (const std::string run : {"line.stigt", "sheet.stigt", "fall.stigp"}) {
    CAPTURE(run);
    const Outcome outcome = place.shell("stigc render " + run + " -o f/ --size 300x200 --fps 5");
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
    std::set<Size> sizes;
    std::size_t frames = 0;
    for (; place.has("f/frame-0000" + std::to_string(frames) + ".png"); ++frames) {
      sizes.insert(size_of(place.file("f/frame-0000" + std::to_string(frames) + ".png")));
    }
    CHECK(frames >= 2);
    CHECK(sizes == std::set<Size>{{300, 200}});
    CHECK(place.file("f/frames.csv").starts_with("frame,"));
    place.shell("rm -r f");
  }
}

TEST_CASE("frames replace those of an earlier film, and nothing else") {
  const Workplace place;
  make_runs(place);
  const std::string film = "stigc render line.stigt --size 100x80 -o f/ --fps 5";
  CHECK(place.shell(film).exit_code == 0);
  CHECK(place.has("f/frame-00002.png"));
  CHECK(place.shell(film + " --to 1").exit_code == 0);
  CHECK(place.has("f/frame-00001.png"));
  CHECK(!place.has("f/frame-00002.png"));
  place.shell("rm f/frames.csv; echo mine > f/frame-00000.png");
  const Outcome outcome = place.shell(film);
  CHECK(outcome.exit_code == 2);
  CHECK(place.file("f/frame-00000.png") == "mine\n");
}

TEST_CASE("the same command gives the same bytes") {
  const Workplace place;
  make_runs(place);
  for (const std::string what :
       {"line.stigt -o a.png --time 1 --ghost", "sheet.stigt -o a.svg --view orbit",
        "sheet.stigt -o a.glb", "fall.stigp -o a.png --time 0.1 --ghost --view top",
        "fall.stigp -o a.glb --from 0.05", "fall.stigp -o a.svg --time 0.1 --ghost",
        "fall.stigp -o a.glb --slice z=..1 --palette tol-bright",
        "sheet.txt -o a.svg --view front --no-legend"}) {
    CAPTURE(what);
    const std::string name = what.find(".svg") != std::string::npos   ? "a.svg"
                             : what.find(".glb") != std::string::npos ? "a.glb"
                                                                      : "a.png";
    const Outcome outcome = place.shell("stigc render " + what);
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
    const std::string first = place.file(name);
    if (name == "a.glb") CHECK(glb_content(first)["animations"].size() == 1);
    CHECK(place.shell("rm " + name + "; stigc render " + what).exit_code == 0);
    CHECK(place.file(name) == first);
  }
}

TEST_CASE("a moment is drawn alike by replay, and 0 s is one") {
  const Workplace place;
  make_runs(place);
  CHECK(place.shell("stigc render fall.stigp -q --at 0 -o a.png").exit_code == 0);
  CHECK(place.shell("stigc replay fall.stigp -q --at 0 -o b.png > /dev/null").exit_code == 0);
  CHECK(place.shell("stigc render fall.stigp -q -o end.png").exit_code == 0);
  CHECK(place.file("a.png") == place.file("b.png"));
  CHECK(place.file("a.png") != place.file("end.png"));
  CHECK(size_of(place.file("a.png")) == size_of(place.file("end.png")));
  CHECK(place.shell("stigc simulate sets/fall.yaml -q --duration 0.1 --at 0 -o s.png > /dev/null")
            .exit_code == 0);
  CHECK(place.shell("stigc simulate sets/fall.yaml -q --duration 0.1 -o e.png > /dev/null")
            .exit_code == 0);
  CHECK(place.file("s.png") != place.file("e.png"));
}

TEST_CASE("without ffmpeg a film is its frames, and the message says so") {
  const Workplace place;
  make_runs(place);
  const Outcome outcome =
      place.shell("s=$(command -v stigc); " + std::string(kNoFfmpeg) +
                  "$s render line.stigt -q -o 'my film;.mp4' --size 100x80 --fps 5");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err ==
        "stigc: there is no ffmpeg here, which makes videos: 'my film;.mp4' has not been written, "
        "but its frames into 'my film;-frames'\n");
  CHECK(place.has("my film;-frames/frame-00000.png"));
  CHECK(!place.has("my film;.mp4"));
}

/// A program in the place of ffmpeg, in a folder of its own.
void put_ffmpeg(const Workplace& place, const std::string& script) {
  place.shell("mkdir -p bin");
  place.write("bin/ffmpeg", "#!/bin/sh\n" + script);
  REQUIRE(place.shell("chmod +x bin/ffmpeg").exit_code == 0);
}

const std::string kWithOurs = "PATH=\"$PWD/bin:$PATH\" ";

TEST_CASE(
    "ffmpeg is given frames and no name of ours; what it writes appears whole or not at all") {
  const Workplace place;
  make_runs(place);
  put_ffmpeg(place, "printf '%s\\n' \"$@\" > arguments; cat > frames; echo a film > /dev/fd/3\n");
  const std::string good = kWithOurs +
                           "stigc render line.stigt -q -o '--help $(x).webm' "
                           "--size 100x80 --fps 5";
  const Outcome outcome = place.shell(good);
  CHECK_MESSAGE(outcome.exit_code == 0, outcome.err);
  CHECK(place.file("--help $(x).webm") == "a film\n");
  CHECK(place.file("arguments").find("help") == std::string::npos);
  CHECK(size_of(place.file("frames")) == Size{100, 80});
  put_ffmpeg(place, "cat > /dev/null; echo half > /dev/fd/3; echo 'no such codec' >&2; exit 1\n");
  const Outcome failed = place.shell(good);
  CHECK(failed.exit_code == 3);
  CHECK(failed.err == "stigc: ffmpeg failed: no such codec\n");
  CHECK(place.file("--help $(x).webm") == "a film\n");
  put_ffmpeg(place, "exit 0\n");
  CHECK(place.shell(good).exit_code == 3);
  CHECK(place.file("--help $(x).webm") == "a film\n");
}

TEST_CASE("a film that is broken off leaves nothing behind") {
  const Workplace place;
  make_runs(place);
  // The user's Ctrl-C comes while frames are drawn.
  put_ffmpeg(place, "head -c 8 > /dev/null; kill -INT $PPID; cat > /dev/null\n");
  const std::vector<std::string> before = place.files();
  const Outcome outcome =
      place.shell(kWithOurs + "stigc render fall.stigp -q -o f.mp4 --fps 100000 --speed 1");
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.starts_with("stigc: interrupted after "));
  CHECK(place.files() == before);
}

TEST_CASE("ffmpeg's own films, where it is") {
  if (std::system("command -v ffmpeg > /dev/null 2>&1") != 0) return;
  const Workplace place;
  make_runs(place);
  for (const auto& [name, magic] :
       {std::pair("f.gif", "GIF89a"), {"f.webm", "\x1a\x45\xdf\xa3"}, {"f.mp4", "ftyp"}}) {
    // An odd size, which two of them do not take as it is.
    const Outcome outcome = place.shell(std::string("stigc render line.stigt --size 99x81 -o ") +
                                        name + " --view orbit");
    CHECK_MESSAGE(outcome.exit_code == 0, outcome.err);
    CHECK(place.file(name).substr(0, 12).find(magic) != std::string::npos);
  }
}

TEST_CASE("what a robot's camera sees is drawn, and a wrong name is answered with the right ones") {
  const Workplace place;
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  place.write(
      "s.yaml",
      "stigc_scene: 1\nduration: 0.05\nrobots: [{name: r, file: bebot.yaml, at: [0, 0]}]\n");
  REQUIRE(place.shell("stigc simulate s.yaml -q --trace r.stigp").exit_code == 0);
  const Outcome wrong = place.shell("stigc render r.stigp -o r.png --camera nobody");
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("no camera is called 'nobody', but there are r:") != std::string::npos);
  CHECK(place.shell("stigc render r.stigp -q -o r.png --time 0.05 --camera r").exit_code == 0);
  CHECK(place.shell("stigc simulate s.yaml -q -o s.png --camera r > /dev/null").exit_code == 0);
  CHECK(place.file("r.png") == place.file("s.png"));
}

TEST_CASE("slices and palettes change pictures, sizes do what they say") {
  const Workplace place;
  make_runs(place);
  std::set<std::string> pictures;
  for (const std::string options :
       {"", "--slice x=0..1", "--slice z=..0 --slice x=2..", "--palette okabe-ito",
        "--palette tol-bright", "--no-title", "--no-legend", "--view 1,1,0", "--view top"}) {
    CAPTURE(options);
    const Outcome outcome = place.shell("stigc render sheet.stigt -q -o a.png " + options);
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
    CHECK(size_of(place.file("a.png")) == Size{1200, 800});
    pictures.insert(place.file("a.png"));
  }
  CHECK(pictures.size() >= 8);  // all of a sheet lies at z = 0
  CHECK(place
            .shell("stigc draw sheet.txt -q -o a.png && stigc draw sheet.txt -q -o b.png "
                   "--palette tol-bright")
            .exit_code == 0);
  CHECK(place.file("a.png") != place.file("b.png"));
}

TEST_CASE("LEDs are lit in the palette's colours, those that are off stay grey") {
  const Workplace place;
  place.write("lit.yaml", "stigc_scene: 1\nduration: 0.01\nblocks: [{column: 2, color: Q2}]\n");
  place.write("dark.yaml", "stigc_scene: 1\nduration: 0.01\nblocks: [{column: 2}]\n");
  for (const std::string name : {"lit", "dark"}) {
    const Outcome outcome = place.shell("stigc simulate " + name + ".yaml -q --trace " + name +
                                        ".stigp && stigc render " + name + ".stigp -q -o " + name +
                                        ".png && stigc render " + name + ".stigp -q -o " + name +
                                        "-tol.png --palette tol-bright");
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
  }
  CHECK(place.file("lit.png") != place.file("lit-tol.png"));
  CHECK(place.file("dark.png") == place.file("dark-tol.png"));
}

TEST_CASE("options that make no sense together are refused before any work") {
  const Workplace place;
  make_runs(place);
  for (const std::string line : {"line.stigt -o a.bmp",
                                 "line.stigt -o a.png --from 1",
                                 "line.stigt -o a.gif --time 1",
                                 "line.stigt -o a.gif --from 2 --to 1",
                                 "line.stigt -o a.glb --ghost",
                                 "line.stigt -o a.png --camera r",
                                 "fall.stigp -o a.svg --camera r",
                                 "sheet.txt -o a.gif",
                                 "fall.stigp -o a.png --camera r --view top",
                                 "line.stigt -o a.png --view side",
                                 "line.stigt -o a.png --view 0,0,0",
                                 "line.stigt -o a.png --size 10x10",
                                 "line.stigt -o a.png --slice w=1..2",
                                 "line.stigt -o a.png --slice z=2..1",
                                 "line.stigt -o a.png --slice z=..",
                                 "line.stigt -o a.png --slice z=0..1 --slice z=2..3",
                                 "line.stigt -o frames",
                                 "line.stigt -o -",
                                 "sheet.txt -o a.png --time 1",
                                 "sheet.txt -o a.png --ghost",
                                 "line.stigt -o a/ --fps 100000 --speed 0.001",
                                 "line.stigt"}) {
    CAPTURE(line);
    const Outcome outcome = place.shell("stigc render " + line);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.starts_with("stigc: "));
  }
  CHECK(place.stigc({"render", "none.stigp", "-o", "a.png"}).exit_code == 1);
  CHECK(place.stigc({"render", "line.stigt", "-o", "a.png", "--time", "-1"}).err ==
        "stigc: --time: '-1' is no moment\ntry 'stigc render --help'\n");
}

TEST_CASE("of many files that cannot be written some are named, and how many more there are") {
  const Workplace place;
  make_runs(place);
  const Outcome outcome =
      place.stigc({"render", "line.stigt", "-o", "none/frames/", "--fps", "60"});
  CHECK(outcome.exit_code == 3);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 9);
  CHECK(outcome.err.find(" more of the same\n") != std::string::npos);
}

}  // namespace
}  // namespace stig
