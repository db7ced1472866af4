// SPDX-License-Identifier: MIT
// The commands. Each returns the program's exit code; results go to app.print.
#pragma once

#include "app.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

int run(const CheckOptions& options, App& app);
int run(const FmtOptions& options, App& app);
int run(const ExploreOptions& options, App& app);
int run(const ExplainOptions& options, App& app);
int run(const TestOptions& options, App& app);
int run(const VerifyFileOptions& options, App& app);
int run(const CertifyOptions& options, App& app);
int run(const GraphOptions& options, App& app);
int run(const ReplayOptions& options, App& app);
int run(const SchemaOptions& options, App& app);
int run(const InitOptions& options, App& app);
int run(const ImportOptions& options, App& app);
int run(const VoxeliseOptions& options, App& app);
int run(const ConvexOptions& options, App& app);
int run(const MeasureOptions& options, App& app);
int run(const DrawOptions& options, App& app);
int run(const CompletionsOptions& options, App& app);
int run(const DoctorOptions& options, App& app);
int run(const SynthOptions& options, App& app);
int run(const SimulateOptions& options, App& app);
int run(const DescribeOptions& options, App& app);
int run(const CompileFileOptions& options, App& app);
int run(const ValidateOptions& options, App& app);
int run(const BuildOptions& options, App& app);
int run(const SweepOptions& options, App& app);
int run(const MergeOptions& options, App& app);
int run(const ViewOptions& options, App& app);
int run(const RenderOptions& options, App& app);
int run(const SearchFileOptions& options, App& app);
int run(const ArchiveOptions& options, App& app);

/// `stigc --explain CODE`; the empty code lists all.
int explain_code(const std::string& code, App& app);

}  // namespace stig::cli
