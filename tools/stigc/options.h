// SPDX-License-Identifier: MIT
// What the command line says, as plain data. The options that options_*.cpp declare fill it;
// every command takes its own part and knows nothing of how it was written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lattice/rgb.h"
#include "lattice/swarm.h"
#include "rules/published_table.h"
#include "synthesis/synthesise.h"
#include "uses.h"
#include "validate/set_up.h"

namespace stig::cli {

enum class Coloured : std::uint8_t { automatic, always, never };

/// Options that every command has.
struct GlobalOptions {
  bool json_diagnostics = false;
  Coloured color = Coloured::automatic;
  bool warnings_are_errors = false;
  bool quiet = false;
};

struct CheckOptions {
  std::vector<std::string> files;
};

struct FmtOptions {
  std::vector<std::string> files;
  bool write = false;  ///< in place
  bool check = false;  ///< say which files are not in canonical form
};

/// A box as the command line gives it: a size, or "none" for unbounded space.
struct BoxOption {
  std::optional<Offset> size;
};

/// The world, where the command line says something of it.
struct WorldOptions {
  std::optional<BoxOption> box;
  std::optional<Cell> origin;  ///< the box's lowest cell
  bool periodic = false;
};

struct ExploreOptions {
  std::string file;
  WorldOptions world;
  std::optional<int> agents;
  std::vector<Cell> agents_at;
  std::optional<std::uint64_t> steps, deposits;
  Motion motion = Motion::walk;
  std::optional<int> moves;
  std::uint64_t seed = 1;
  int runs = 1;
  std::optional<int> run;  ///< this one of several alone
  int threads = 0;         ///< 0: all cores
  bool json = false;
  std::vector<std::string> outputs;
  Palette palette = Palette::file;  ///< of pictures
  std::optional<std::string> trace;
};

struct ExplainOptions {
  std::string file;
  std::optional<std::string> structure;  ///< left out: the start
  Cell at;
  int stage = 1;
  std::optional<int> rule;  ///< 1-based: this one alone
  bool json = false;
};

struct TestOptions {
  std::vector<std::string> files;
  std::optional<std::uint32_t> samples;
  std::optional<std::uint64_t> states;
  bool json = false;
};

struct VerifyFileOptions {
  std::string file;
  std::vector<std::string> sides;  ///< rules for robots at these alone; empty: in every turn
  WorldOptions world;
  double effort = 1;             ///< multiple of kVerifyWork
  std::optional<double> budget;  ///< seconds
  std::uint64_t states = 2'000'000;
  std::optional<std::string> certificate;
  std::optional<std::string> witness;  ///< begins the names of the files that show the verdict
  bool losses = false;                 ///< also whether the loss of a brick is mended
  bool json = false;
};

/// A certificate for a rule set, or a proof for a formula.
struct CertifyOptions {
  std::string file;                         ///< rule set, or formula
  std::string proof;                        ///< certificate, or proof
  std::vector<std::string> sides;           ///< as with VerifyFileOptions
  std::optional<std::string> robot, block;  ///< files, of a certificate of robots' work
  bool fewest = false;  ///< `file` is a folder with the proof that fewer colours do not do
  bool drat = false;
  WorldOptions world;
  bool json = false;
};

struct GraphOptions {
  std::string file;
};

struct ReplayOptions {
  std::string trace;
  bool verify = false;
  std::optional<double> at;          ///< s
  std::vector<std::string> outputs;  ///< .png or .csv
  bool json = false;
};

struct SimulateOptions {
  std::string scene;  ///< empty: the one of `resume`
  std::optional<std::uint64_t> seed;
  std::optional<double> duration;      ///< s
  std::optional<double> at;            ///< s, of the picture
  std::optional<std::string> picture;  ///< .png
  std::optional<std::string> camera;   ///< ROBOT[:CAMERA], whose view the picture is
  std::optional<std::string> trace;
  bool detail = false;  ///< of the trace: what robots sense, and magnets
  std::optional<std::string> checkpoint;
  std::optional<std::string> resume;
  int runs = 1;
  int threads = 0;  ///< 0: all cores
  bool json = false;
};

/// What `stigc compile` prints.
enum class CompileTarget : std::uint8_t { table, lua, argos, dot, ir };
struct CompileFileOptions {
  std::string file;
  std::optional<std::string> robot;  ///< a robot's file; otherwise the paper's robot
  std::optional<std::string> block;  ///< a block's file; otherwise the paper's block
  std::vector<std::string> sides;    ///< "+x" "-x" "+y" "-y"; empty: the file's
  std::optional<int> robots;         ///< that work at once; otherwise the file's
  std::optional<CompileTarget>
      target;  ///< otherwise by the output's name: .lua, .argos, or a table
  std::optional<std::string> output;
  std::optional<std::string> report;       ///< the table, whatever the target
  std::optional<std::string> page;         ///< .html, of a refusal or a warning
  std::optional<std::string> certificate;  ///< of the proof that robots complete it
  std::optional<double> budget;            ///< s, of the proof
  std::uint64_t states = 100'000;
};

struct ValidateOptions {
  std::string file;
  std::optional<std::string> scene;  ///< in place of the usual set-up
  std::optional<std::string> robot;  ///< a robot's file; otherwise the paper's robot
  std::vector<std::string> sides;    ///< "+x" "-x" "+y" "-y"; empty: the file's
  std::optional<int> structures;     ///< in the usual set-up; otherwise one
  std::optional<int> robots;         ///< of all of them; otherwise as the file says
  Allocation allocation = Allocation::fixed;
  std::optional<double> duration;  ///< s
  std::uint64_t seed = 1;          ///< of the first run
  int runs = 1;
  std::optional<int> run;             ///< this one of several alone
  int threads = 0;                    ///< 0: all cores
  std::optional<std::string> output;  ///< folder
  bool detail = false;                ///< of its traces, as above
  bool json = false;
};

/// The number-th of so many parts of a study or a search.
struct SliceOption {
  std::uint64_t number = 1, of = 1;
};

struct SweepOptions {
  std::string plan;
  std::vector<std::string> outputs;
  std::optional<std::uint64_t> run;  ///< this item alone
  SliceOption slice;
  int threads = 0;  ///< 0: all cores
  bool json = false;
};

struct MergeOptions {
  std::vector<std::string> files, outputs;
  bool json = false;
};

struct DescribeOptions {
  std::string robot;
  std::optional<std::string> picture;  ///< .png
  bool json = false;
};

enum class FileForm : std::uint8_t { rules, scene, robot, block, solid, search, sweep };
struct SchemaOptions {
  FileForm form = FileForm::rules;
  std::optional<std::string> symbols_of;  ///< a rule set whose symbols are offered
};

inline constexpr int kUsualBricks = 100;
/// How a mesh becomes bricks; lengths in mm.
struct MeshOptions {
  std::optional<int> bricks;   ///< about so many, where no side is given; otherwise kUsualBricks
  std::optional<double> side;  ///< of a brick
  double unit = 1;             ///< of the file's numbers
  std::string up = "z";        ///< the file's axis, "-" before it: the other way
  bool shell = false;          ///< only where a surface is
};

struct VoxeliseOptions {
  std::string model;
  MeshOptions mesh;
  std::vector<std::string> outputs;
  bool json = false;
};

struct ConvexOptions {
  std::string model;
  int parts = 16;   ///< convex pieces, at most
  double unit = 1;  ///< mm, of the file's numbers
  std::string up = "z";
  std::optional<std::string> output;
  bool json = false;
};

struct InitOptions {
  std::string folder;
};

struct ImportOptions {
  std::string table;
  TableReading reading;
  std::optional<std::string> output;  ///< otherwise standard output
};

struct MeasureOptions {
  std::string structure;
  std::optional<Lattice> lattice;  ///< of a file that does not say it
  MeshOptions mesh;
  bool json = false;
};

struct DrawOptions {
  std::string structure;
  std::optional<Lattice> lattice;  ///< of a file that does not say it
  MeshOptions mesh;
  Palette palette = Palette::file;  ///< of pictures
  std::vector<std::string> outputs;
};

/// A part of space along an axis, in cells of a lattice or in m.
struct Slice {
  int axis = 0;  ///< x, y, z; of the hexagonal lattice q, r, z
  double low = -1e300, high = 1e300;
};

/// From where pictures are taken; neither: as is usual for what is shown.
struct RenderView {
  /// rad, of the camera about what is shown: from the x axis, and above the ground
  std::optional<double> azimuth, elevation;
  bool orbit = false;  ///< once round while the film lasts
};

/// Pictures of runs and structures, without a window.
struct RenderOptions {
  std::string file;
  std::string output;              ///< .png .svg .mp4 .webm .gif .glb, or a folder
  std::optional<Lattice> lattice;  ///< of structure files that do not say it
  std::optional<double> time;      ///< of a picture: s, or bricks placed
  std::optional<double> from, to;  ///< of a film, likewise
  std::optional<double> fps;       ///< frames a second
  std::optional<double> speed;     ///< s of the run, or bricks, a second of film
  std::optional<int> width, height;
  RenderView view;
  std::vector<Slice> slices;
  std::optional<std::string> camera;  ///< ROBOT[:CAMERA]
  Palette palette = Palette::file;
  bool ghost = false;
  bool no_title = false, no_legend = false;
};

/// One page that shows runs and structures.
struct ViewOptions {
  std::vector<std::string> files;
  std::optional<Lattice> lattice;  ///< of structure files that do not say it
  MeshOptions mesh;
  std::optional<std::string> target;  ///< a structure file
  std::optional<std::string> title;
  std::string output;  ///< .html; empty: none
  // A run that goes on while it is looked at.
  bool live = false;
  bool paused = false;
  std::optional<int> port;
  std::optional<std::uint64_t> seed;
  std::optional<std::string> trace, checkpoint;
};

enum class Shell : std::uint8_t { bash, zsh, fish };
struct CompletionsOptions {
  Shell shell = Shell::bash;
};

struct DoctorOptions {
  std::vector<std::string> files;  ///< rule sets to check as well
  bool json = false;
};

struct SynthOptions {
  std::string target;
  std::optional<Lattice> lattice;  ///< of a file that does not say it
  MeshOptions mesh;
  ColourUse use = ColourUse::free;
  std::optional<int> colours;  ///< so many at most
  Symmetry symmetry = Symmetry::none;
  std::vector<Cell> start;
  bool floor = false;
  std::optional<std::string> robot;  ///< that has to be able to follow the rules
  bool shipped_robot = false;        ///< the one of that name that came with the program
  std::optional<std::string> block;  ///< that it builds with; otherwise the paper's
  std::vector<std::string> sides;    ///< that it works from; empty: chosen
  std::optional<int> robots;         ///< that work at once; otherwise as many as may be
  std::optional<int> kinds;          ///< of brick that its blocks may show; otherwise four
  Fewest fewest = Fewest::colours;
  std::optional<OrderFamily> family;
  bool strict = false;   ///< no ties
  bool exact = false;    ///< no merging
  int scaffold = 0;      ///< cells that may be added
  int effort = 1;        ///< how much is tried
  double seconds = 300;  ///< after which the search ends early
  std::optional<std::string> output;
  std::optional<std::string> certificate;
  std::optional<std::string> proof;
  bool json = false;
};

/// From a drawing to an evaluated structure: synth --robot, compile and validate.
struct BuildOptions {
  std::string target;
  MeshOptions mesh;
  std::optional<std::string> robot;  ///< a robot's file; otherwise the paper's robot
  std::vector<std::string> sides;    ///< empty: chosen
  std::optional<int> robots;         ///< that work at once; otherwise one
  std::optional<int> kinds;          ///< of brick that blocks may show; otherwise four
  ColourUse use = ColourUse::free;
  std::optional<int> colours;  ///< so many at most
  std::vector<Cell> start;
  int effort = 1;
  double seconds = 300;            ///< for the search
  std::optional<double> duration;  ///< s, of a run
  std::uint64_t seed = 1;          ///< of the first run
  int runs = 1;
  int threads = 0;     ///< 0: all cores
  std::string output;  ///< folder
};

struct SearchFileOptions {
  std::string plan;
  std::string output;  ///< .sqlite
  SliceOption slice;
  int threads = 0;  ///< 0: all cores
};

struct ArchiveOptions {
  std::string results;
  std::int64_t top = 10;
  std::vector<std::string> beside;     ///< further results, for figures
  std::optional<std::int64_t> pick;    ///< number of an individual
  std::optional<std::string> plot;     ///< names of what is on the axes
  std::optional<std::string> gallery;  ///< .html
  std::optional<std::string> output;   ///< of what is picked or plotted
  bool json = false;
};

using CommandOptions =
    std::variant<CheckOptions, FmtOptions, ExploreOptions, ExplainOptions, TestOptions,
                 VerifyFileOptions, CertifyOptions, SynthOptions, GraphOptions, ReplayOptions,
                 SchemaOptions, MeasureOptions, DrawOptions, CompletionsOptions, DoctorOptions,
                 SimulateOptions, DescribeOptions, CompileFileOptions, ValidateOptions,
                 BuildOptions, ViewOptions, RenderOptions, VoxeliseOptions, ConvexOptions,
                 SearchFileOptions, ArchiveOptions, SweepOptions, MergeOptions, ImportOptions,
                 InitOptions>;

struct CommandLine {
  GlobalOptions global;
  CommandOptions command;
};

}  // namespace stig::cli
