// SPDX-License-Identifier: MIT
// One function a command, which declares its options; command_line.cpp lists them in the order of
// the help.
#pragma once

#include "options.h"
#include "uses.h"

namespace CLI {
class App;
}

namespace stig::cli {

void add_check(CLI::App& app, CheckOptions& o);
void add_fmt(CLI::App& app, FmtOptions& o);
void add_explore(CLI::App& app, ExploreOptions& o);
void add_explain(CLI::App& app, ExplainOptions& o);
void add_test(CLI::App& app, TestOptions& o);
void add_verify(CLI::App& app, VerifyFileOptions& o);
void add_certify(CLI::App& app, CertifyOptions& o);
void add_graph(CLI::App& app, GraphOptions& o);
void add_replay(CLI::App& app, ReplayOptions& o);
void add_schema(CLI::App& app, SchemaOptions& o);
void add_init(CLI::App& app, InitOptions& o);
void add_import(CLI::App& app, ImportOptions& o);
void add_voxelise(CLI::App& app, VoxeliseOptions& o);
void add_convex(CLI::App& app, ConvexOptions& o);
void add_measure(CLI::App& app, MeasureOptions& o);
void add_draw(CLI::App& app, DrawOptions& o);
void add_synth(CLI::App& app, SynthOptions& o);
void add_simulate(CLI::App& app, SimulateOptions& o);
void add_describe(CLI::App& app, DescribeOptions& o);
void add_compile(CLI::App& app, CompileFileOptions& o);
void add_validate(CLI::App& app, ValidateOptions& o);
void add_build(CLI::App& app, BuildOptions& o);
void add_sweep(CLI::App& app, SweepOptions& o);
void add_merge(CLI::App& app, MergeOptions& o);
void add_view(CLI::App& app, ViewOptions& o);
void add_render(CLI::App& app, RenderOptions& o);
void add_search(CLI::App& app, SearchFileOptions& o);
void add_archive(CLI::App& app, ArchiveOptions& o);
void add_completions(CLI::App& app, CompletionsOptions& o);
void add_doctor(CLI::App& app, DoctorOptions& o);

}  // namespace stig::cli
